// Closed bodies with fewer faces, for programs to which each face is heavy.
#pragma once

#include "TriangleMesh.h"

#include <stop_token>

namespace bolster {

struct FewerFaces {
    TriangleMesh mesh;
    double off = 0; ///< mm: 99 % of the points of what it was are no farther from it
};

/// Each edge stays between two triangles, the volume stays what it is, and no triangle is so thin that CAD systems
/// would sort it out, and leave a hole. About so many `faces`, or more where the body would be another one.
/// `solid`: mm, closed; stays as it is where it has no more. Nothing when stopped. Source: Lindstrom and Turk,
/// "Fast and memory efficient polygonal simplification", 1998 (CGAL).
FewerFaces withFewerFaces(const TriangleMesh& solid, std::size_t faces, const std::stop_token& stop = {});

} // namespace bolster
