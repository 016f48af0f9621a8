// What the solver works on: a design, and what its files hold.
#pragma once

#include "Design.h"
#include "DesignFiles.h"

#include <utility>

namespace bolster {

struct SolveInput {
    Design design;
    DesignFiles files;

    SolveInput() = default;
    /// A design without files is one, too.
    SolveInput(Design theDesign, DesignFiles theFiles = {}) // NOLINT(google-explicit-constructor)
        : design(std::move(theDesign))
        , files(std::move(theFiles))
    {}
};

} // namespace bolster
