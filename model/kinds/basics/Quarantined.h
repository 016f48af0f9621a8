// An element that could not be read. It keeps its text, so that saving loses nothing.
#pragma once

#include "Problem.h"

#include <string>

namespace bolster {

struct Quarantined {
    std::string text; ///< the JSON object as it stood in the file, in one line
    Problems problems;

    /// The problems follow from the text and its place among the others.
    friend bool operator==(const Quarantined& a, const Quarantined& b) { return a.text == b.text; }
};

} // namespace bolster
