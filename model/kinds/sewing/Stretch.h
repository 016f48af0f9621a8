// A stretch of a patch's outline: the (i, r, s) of the paper, section 3.1.
#pragma once

#include "ElementId.h"

namespace bolster {

class Design;

/// Runs from `from` to `to` in increasing parameter. `to` <= `from` passes the outline's start; `to` = `from`
/// is the whole outline.
struct Stretch {
    ElementId patch{};
    double from = 0;
    double to = 0;

    friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// How positions on two joined stretches belong together: equal fractions of arc length, or of the parameter
/// (the paper's labels, section 3.2).
enum class Match { Length, Parameter };

/// The parameter where the stretch ends, made larger than `from` by adding the period if need be.
double unwrappedEnd(double from, double to, double domainStart, double domainEnd);

} // namespace bolster
