#include "Orientations.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double firmness = 10;

/// The normal (to the outside) nearest to the present one that is as it is held.
Vec3 heldNormal(const SewnMesh::Oriented& held, const Vec3& normal)
{
    if (held.kind == Orientation::Kind::Normal)
        return held.direction;
    const Vec3 across = normal - normal.dot(held.direction) * held.direction;
    const double length = across.norm();
    return length > 1e-6 ? Vec3(across / length) : normal;
}

/// The quaternion (w, x, y, z) of the shortest turn between unit vectors; about `axis`, which is normal to the
/// first, when they are opposite.
Quat shortestTurn(const Vec3& from, const Vec3& to, const Vec3& axis)
{
    const double cosine = from.dot(to);
    if (cosine < -1 + 1e-9)
        return {0, axis.x(), axis.y(), axis.z()};
    const Vec3 cross = from.cross(to);
    return Quat(1 + cosine, cross.x(), cross.y(), cross.z()).normalized();
}

} // namespace

double orientationWeight(const SewnMesh& mesh, const SewnMesh::Oriented& held)
{
    return held.weight * firmness * (mesh.area[held.vertex] + 2 * mesh.parts[held.part].bendingSquared());
}

void addOrientations(const SheetMoment& sheet, Columns& right)
{
    for (const SewnMesh::Oriented& held : sheet.mesh.oriented) {
        const Eigen::Vector4d q = sheet.frames.col(held.vertex);
        const Vec3 normal = sheet.outside(sheet.mesh.parts[held.part], held.vertex);
        const Quat turn = shortestTurn(normal, heldNormal(held, normal), rotationOf(q).col(0));
        const Quat wanted = turn * Quat(q[0], q[1], q[2], q[3]);
        Eigen::Vector4d goal(wanted.w(), wanted.x(), wanted.y(), wanted.z());
        if (goal.dot(q) < 0)
            goal = -goal;
        right.col(held.vertex) += orientationWeight(sheet.mesh, held) * (goal - q);
    }
}

} // namespace bolster
