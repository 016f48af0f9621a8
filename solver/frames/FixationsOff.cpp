#include "FixationsOff.h"

#include "SegmentDistance.h"
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

/// Edges in millimetres.
class MeshEdges {
public:
    explicit MeshEdges(const PlacedMesh& placed)
    {
        for (const std::vector<Vec3>& edge : placed.edges) {
            Line line;
            for (const Vec3& point : edge) {
                line.points.push_back(placed.placement.placed(point));
                line.box.extend(line.points.back());
            }
            m_lines.push_back(std::move(line));
        }
    }

    bool empty() const { return m_lines.empty(); }

    /// At most `most`.
    double distance(const Vec3& at, double most) const
    {
        double nearest = most;
        for (const Line& line : m_lines) {
            if (line.box.exteriorDistance(at) >= nearest)
                continue;
            for (std::size_t i = 1; i < line.points.size(); ++i)
                nearest = std::min(nearest, segmentDistance(at, line.points[i - 1], line.points[i]));
        }
        return nearest;
    }

private:
    struct Line {
        std::vector<Vec3> points;
        Box3 box;
    };
    std::vector<Line> m_lines;
};

} // namespace

std::vector<FixationOff> fixationsOff(const Design& design, const PlacedMesh& before, const PlacedMesh& after,
                                      const std::stop_token& stop)
{
    std::vector<FixationOff> found;
    if (!before.mesh || !after.mesh)
        return found;
    const TriangleTree old = treeOf(before, stop), present = treeOf(after, stop);
    const MeshEdges oldEdges(before), edges(after);
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& fixation) {
        const std::vector<Vec3> places = placesOf(fixation.curve);
        const bool fromEdge =
            !edges.empty() && !places.empty() && std::ranges::all_of(places, [&](const Vec3& place) {
                return oldEdges.distance(place, 2 * liesOnFrame) <= liesOnFrame;
            });
        double farthest = 0;
        for (const Vec3& place : places)
            if (!stop.stop_requested() && (fromEdge || old.distance(place, 2 * liesOnFrame) <= liesOnFrame))
                farthest = std::max(farthest, fromEdge ? edges.distance(place, farthestLooked)
                                                       : present.distance(place, farthestLooked));
        if (farthest > liesOnFrame)
            found.push_back({id, farthest, fromEdge});
    });
    if (stop.stop_requested())
        return {};
    std::ranges::stable_sort(found, std::ranges::greater{}, &FixationOff::distance);
    return found;
}

} // namespace bolster
