// Triangles of a part of a frame, their corners numbered by place, each face once.
#pragma once

#include "HalfEdges.h"
#include "Placement.h"
#include "TriangleMesh.h"

#include <array>
#include <stop_token>
#include <vector>

namespace bolster {

struct WeldedFrame {
    using Corners = std::array<int, 3>;

    std::vector<Vec3> points; ///< mm, in the order in which triangles name them first
    std::vector<Corners> triangles;

    Vec3 doubleArea(int triangle) const
    {
        const auto& [a, b, c] = triangles[triangle];
        return (points[b] - points[a]).cross(points[c] - points[a]);
    }
    Vec3 middle(int triangle) const
    {
        const auto& [a, b, c] = triangles[triangle];
        return (points[a] + points[b] + points[c]) / 3;
    }
};

/// Welds the parts of a mesh, each point p as placement.placed(p); without triangles that name a place twice.
/// Programs that know no inside (SketchUp) write every face twice, once for each side, which winds around nothing:
/// of these one is kept. A face that two bodies have in common, each its own, is a wall inside of both together and
/// goes.
class FrameWelder {
public:
    FrameWelder(const TriangleMesh& mesh, const Placement& placement, const std::stop_token& stop);

    /// When stopped it means nothing.
    WeldedFrame weld(const TriangleMesh::Part& part);

private:
    const TriangleMesh& m_mesh;
    Placement m_placement;
    std::stop_token m_stop;
    std::vector<int> m_places;  // of each point of the mesh, the same for those in the same place
    std::vector<int> m_numbers; // of each place in what is being welded; -1 elsewhere
};

} // namespace bolster
