// An element that could not be read. It keeps its text, so that saving loses nothing.
#pragma once

#include "Problem.h"

#include <string>

namespace bolster {

struct Quarantined {
    std::string text; ///< the JSON object as it stood in the file, in one line
    Problems problems;

    friend bool operator==(const Quarantined&, const Quarantined&) = default;
};

} // namespace bolster
