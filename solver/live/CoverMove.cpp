#include "CoverMove.h"

#include "PatternLocator.h"
#include "Relief.h"

#include <algorithm>

namespace bolster {

namespace {

using Range = SurfaceTopology::PatchRange;

bool sameShape(const SurfaceTopology& a, const Range& of, const SurfaceTopology& b, const Range& in)
{
    return of.vertexCount == in.vertexCount &&
           std::equal(a.pattern.begin() + of.firstVertex, a.pattern.begin() + of.firstVertex + of.vertexCount,
                      b.pattern.begin() + in.firstVertex);
}

/// Puts the vertices of one patch where they were.
void carryPatch(const SurfaceMesh& before, const Range& old, SurfaceMesh& mesh, const Range& range)
{
    if (sameShape(*before.topology, old, *mesh.topology, range)) {
        std::copy_n(before.positions.begin() + old.firstVertex, old.vertexCount,
                    mesh.positions.begin() + range.firstVertex);
        return;
    }
    const PatternLocator locator(*before.topology, old);
    for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v) {
        const PatternPlace place = locator.locate(mesh.topology->pattern[v]);
        Vec3 position = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            position += place.weights[static_cast<Eigen::Index>(k)] * before.positions[place.corners[k]];
        if (position.allFinite())
            mesh.positions[v] = position;
    }
}

} // namespace

CoverMove moveBetween(const SurfaceMesh& before, const SurfaceMesh& after)
{
    CoverMove move;
    auto from = std::make_shared<SurfaceMesh>(after);
    for (const Range& range : after.topology->patches) {
        const auto& known = before.topology->patches;
        const auto old = std::ranges::find(known, range.patch, &Range::patch);
        if (old != known.end() && old->triangleCount > 0)
            carryPatch(before, *old, *from, range);
    }
    for (std::size_t v = 0; v < after.positions.size(); ++v)
        move.distance = std::max(move.distance, (after.positions[v] - from->positions[v]).norm());
    if (move.distance > 0) {
        from->normals = smoothNormals(*from->topology, from->positions);
        move.from = std::move(from);
    }
    return move;
}

} // namespace bolster
