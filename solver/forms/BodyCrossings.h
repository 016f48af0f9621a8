// Bodies of a form that go through each other. Private to the library.
#pragma once

#include "WeldedForm.h"

#include <optional>
#include <stop_token>

namespace bolster {

struct BodyCrossings {
    int pairs = 0;          ///< of bodies
    Vec3 at = Vec3::Zero(); ///< mm, on both of the first ones

    /// What comes of it; empty without pairs.
    Message note() const;
};

/// A body is all that hangs together. What only touches another one, or goes into it by less than a mm, does not go
/// through it. Forms of more than some hundreds of bodies are not looked at. When stopped it means nothing.
BodyCrossings bodyCrossings(const WeldedForm& form, const std::stop_token& stop = {});

} // namespace bolster
