// Triangles in a tree of boxes: how often they wind around a point, and how far away they are.
#pragma once

#include "BoxTree.h"
#include "Geometry.h"

#include <stop_token>
#include <vector>

namespace bolster {

class TriangleTree {
public:
    using Triangle = BoxTree<double>::Triangle;

    /// When stopped it means nothing.
    explicit TriangleTree(const std::vector<Triangle>& triangles, const std::stop_token& stop = {});

    /// The generalised winding number: the solid angle of all triangles seen from `point`, over 4 pi. 1 inside of a
    /// closed surface that is oriented outwards, 0 outside, and something between near an opening. Far triangles
    /// count together, as dipoles: the error stays below 0.02. Source: Barill et al., "Fast Winding Numbers for
    /// Soups and Clouds", 2018.
    double windingNumber(const Vec3& point) const;
    /// To the nearest point of a triangle, mm; `within` if none is nearer than that.
    double distance(const Vec3& point, double within) const;

    const Box3& box() const { return m_box; }
    const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
    /// What a node of the tree is from far away.
    struct Dipole {
        Vec3 centre = Vec3::Zero(); ///< weighted by area
        Vec3 moment = Vec3::Zero(); ///< sum of area times normal
        double radius = 0;          ///< of all corners around the centre
    };

    Dipole dipoleOf(const BoxTree<double>::Node& node) const;

    std::vector<Triangle> m_triangles; ///< in the tree's order
    BoxTree<double> m_boxes;
    std::vector<Dipole> m_dipoles; ///< of each node
    Box3 m_box;
};

} // namespace bolster
