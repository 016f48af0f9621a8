// How the cover leans along a curve on it: an orientation constraint (paper, section 3.2).
#pragma once

#include "Geometry.h"

#include <vector>

namespace bolster {

/// A wish for the surface normal at the vertices of a stretch or handle curve; no directions: no wish.
struct Orientation {
    enum class Kind {
        Normal, ///< the directions are normals, pointing to the outside
        Tangent ///< the directions lie in the tangent plane, which may turn about them
    };

    Kind kind = Kind::Normal;
    std::vector<Vec3>
        directions;    ///< of any length, spread evenly over the curve by arc length; between them interpolated
    double weight = 1; ///< 0: none, 1: nearly exact

    bool empty() const { return directions.empty(); }
    /// The unit direction at a fraction of the curve's length; zero where neighbours cancel out. Not for empty
    /// ones.
    Vec3 at(double fraction) const;

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

} // namespace bolster
