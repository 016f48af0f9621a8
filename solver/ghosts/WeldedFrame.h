// Triangles of a part of a frame, their corners numbered by place, each face once.
#pragma once

#include "Placement.h"
#include "TriangleMesh.h"

#include <array>
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

/// Each point p as placement.placed(p); without triangles that name a place twice. Programs that know no inside
/// (SketchUp) write every face twice, once for each side, which winds around nothing: of these one is kept. A face
/// that two bodies have in common, each its own, is a wall inside of both together and goes.
WeldedFrame weldFrame(const TriangleMesh& mesh, const TriangleMesh::Part& part, const Placement& placement);

/// A side of a triangle.
struct HalfEdge {
    int low = 0;
    int high = 0;
    int triangle = 0;
    bool forward = false; ///< from low to high

    bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Sorted, so that those of one edge follow each other.
std::vector<HalfEdge> halfEdges(const std::vector<WeldedFrame::Corners>& triangles);

/// Calls visit(first, last) for the half edges of each edge: pointers to the first and behind the last.
template <class Visit>
void eachEdge(const std::vector<HalfEdge>& halves, Visit visit)
{
    const HalfEdge* const end = halves.data() + halves.size();
    for (const HalfEdge *first = halves.data(), *last = first; first != end; first = last) {
        while (last != end && last->sameEdge(*first))
            ++last;
        visit(first, last);
    }
}

} // namespace bolster
