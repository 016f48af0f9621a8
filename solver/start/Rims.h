// What holds a component of the cover, and on which side of that the cloth stands.
#pragma once

#include "SewnMesh.h"

#include <optional>
#include <vector>

namespace bolster {

/// Fixed points of a component.
struct Rim {
    Vec3 centre = Vec3::Zero();
    Vec3 up = Vec3::Zero(); ///< where cloth that is closed above them stands, unit: to the outside; else zero
    bool isFlat = false;    ///< they lie in a plane
};

/// The cloth lies on one side of its outline, seen from outside. So a rim in a plane, which goes around what it
/// holds, says on which side of that plane the cloth is to stand. One of each component.
std::vector<Rim> rimsOf(const SewnMesh& mesh);

bool isHeld(const SewnMesh& mesh, int v);
const Vec3& heldAt(const SewnMesh& mesh, int v); ///< mm, where it is

/// Along the outline, of one of its vertices.
int nextOf(const SewnMesh::Part& part, int v);
/// Where that is held, too; none for vertices inside.
std::optional<int> nextHeld(const SewnMesh& mesh, const SewnMesh::Part& part, int v);

/// 1 where the cloth lies to the left of its outline, seen from +z of the pattern; of a mirrored twin it may not.
double senseOf(const SewnMesh& mesh, const SewnMesh::Part& part);

} // namespace bolster
