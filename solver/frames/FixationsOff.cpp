#include "FixationsOff.h"

#include "TriangleTree.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr int placesOfPiece = 16; // of a curve between two of its knots

TriangleTree treeOf(const PlacedMesh& placed, const std::stop_token& stop)
{
    std::vector<TriangleTree::Triangle> triangles;
    triangles.reserve(placed.mesh->triangles.size());
    for (const auto& corners : placed.mesh->triangles) {
        TriangleTree::Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = placed.placement.placed(placed.mesh->points[corners[k]]);
        triangles.push_back(triangle);
    }
    return TriangleTree(triangles, stop);
}

std::vector<Vec3> placesOf(const BSpline3& curve)
{
    std::vector<Vec3> places;
    if (curve.empty())
        return places;
    const int count = placesOfPiece * curve.pointCount();
    for (int k = 0; k <= count; ++k)
        places.push_back(curve.at(curve.domainStart() + curve.period() * k / count));
    return places;
}

} // namespace

std::vector<FixationOff> fixationsOff(const Design& design, const PlacedMesh& before, const PlacedMesh& after,
                                      const std::stop_token& stop)
{
    std::vector<FixationOff> found;
    if (!before.mesh || !after.mesh)
        return found;
    const TriangleTree old = treeOf(before, stop), present = treeOf(after, stop);
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& fixation) {
        double farthest = 0;
        for (const Vec3& place : placesOf(fixation.curve))
            if (!stop.stop_requested() && old.distance(place, 2 * liesOnFrame) <= liesOnFrame)
                farthest = std::max(farthest, present.distance(place, farthestLooked));
        if (farthest > liesOnFrame)
            found.push_back({id, farthest});
    });
    if (stop.stop_requested())
        return {};
    std::ranges::stable_sort(found, std::ranges::greater{}, &FixationOff::distance);
    return found;
}

} // namespace bolster
