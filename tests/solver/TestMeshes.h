// Frames made of a few numbers.
#pragma once

#include "TriangleMesh.h"

namespace bolster::test {

/// One part, "Box", faces outwards: triangles 0 .. 11.
TriangleMesh boxMesh(const Box3& box);
/// Around the origin, from a cube whose faces have count x count squares; inscribed.
TriangleMesh sphereMesh(double radius, int count);
/// Takes away the triangles that lie in the plane p[axis] = value (of spheres: those that touch it).
void removeFace(TriangleMesh& mesh, int axis, double value);
/// The parts of both.
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b);
Vec3 triangleMiddle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle);

} // namespace bolster::test
