// What foam looks like.
#pragma once

#include "Foam.h"
#include "TriangleMesh.h"

#include <vector>

namespace bolster {

/// The surface of a box, cylinder or sphere in its own axes, mm at scale 1, faces outwards; nothing for meshes.
TriangleMesh foamMesh(Foam::Shape shape, const Vec3& size);
/// Lines that show the shape, likewise; a box for meshes.
std::vector<std::vector<Vec3>> foamLines(Foam::Shape shape, const Vec3& size);
std::vector<std::vector<Vec3>> boxLines(const Box3& box);

} // namespace bolster
