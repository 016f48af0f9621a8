// Triangles in a tree of boxes: how often they wind around a point, and how far away they are.
#pragma once

#include "Geometry.h"

#include <array>
#include <stop_token>
#include <vector>

namespace bolster {

class TriangleTree {
public:
    using Triangle = std::array<Vec3, 3>;

    /// When stopped it means nothing.
    explicit TriangleTree(std::vector<Triangle> triangles, const std::stop_token& stop = {});

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
    /// In the order of a walk that visits parents first; `next` is where the walk goes on behind the subtree.
    struct Node {
        Box3 box;
        Vec3 centre = Vec3::Zero(); ///< weighted by area
        Vec3 dipole = Vec3::Zero(); ///< sum of area times normal
        double radius = 0;          ///< of all corners around the centre
        int first = 0;
        int count = 0; ///< of triangles; 0 for inner nodes
        int next = 0;
    };

    void build(int begin, int end, const std::stop_token& stop);
    Node summary(int begin, int end) const;

    std::vector<Triangle> m_triangles;
    std::vector<Node> m_nodes;
    Box3 m_box;
};

/// The point of a triangle that is nearest to `point`.
Vec3 nearestPoint(const TriangleTree::Triangle& triangle, const Vec3& point);

} // namespace bolster
