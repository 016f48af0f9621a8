// How far a material may be strained before it suffers.
#pragma once

namespace bolster {

/// In %, > 0. What a map of strain shows as too much; mechanics know nothing of it.
struct StretchLimits {
    double along = 8;  ///< the grain
    double across = 8; ///< the grain
    double shear = 10; ///< tangent of the angle by which threads leave the right angle, times 100

    friend bool operator==(const StretchLimits&, const StretchLimits&) = default;
};

} // namespace bolster
