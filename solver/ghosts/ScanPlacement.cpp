#include "ScanPlacement.h"

#include "RigidFit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr int mostIterations = 200;
constexpr std::size_t mostVertices = 4000;
constexpr double kept = 0.8;   // share of the pairs that count
constexpr double gain = 0.999; // a smaller share of the rms counts as progress
constexpr int patience = 10;   // iterations without

struct Pair : PlanePair {
    double distance = 0;
};

std::vector<Pair> nearestPairs(const SurfaceMesh& surface, const Placement& placement, const ScanIndex& index,
                               const Vec3& middle)
{
    std::vector<Pair> pairs;
    const std::size_t step = std::max<std::size_t>(1, surface.positions.size() / mostVertices);
    for (std::size_t v = 0; v < surface.positions.size(); v += step) {
        const Vec3& at = surface.positions[v];
        const int nearest = index.search(placement.filePoint(at), std::numeric_limits<float>::max() / 4).first;
        if (nearest < 0)
            continue;
        const Vec3 point = placement.placed(index.point(nearest));
        const Vec3 normal = placement.rotation * index.normal(nearest);
        pairs.push_back({{point - middle, normal, normal.dot(point - at)}, (point - at).norm()});
    }
    const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(kept * static_cast<double>(pairs.size()));
    std::nth_element(pairs.begin(), end, pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    pairs.erase(end, pairs.end());
    return pairs;
}

double rmsOf(const std::vector<Pair>& pairs)
{
    double squares = 0;
    for (const Pair& pair : pairs)
        squares += pair.along * pair.along;
    return std::sqrt(squares / static_cast<double>(pairs.size()));
}

} // namespace

std::optional<PlacementFit> fitPlacement(const SurfaceMesh& surface, const Placement& from, const ScanIndex& index,
                                         const std::stop_token& stop, const std::function<void(int)>& progress)
{
    const Box3 box = surface.boundingBox();
    const double radius = 0.5 * box.diagonal().norm();
    const Vec3 middle = box.center();
    PlacementFit best{from, std::numeric_limits<double>::infinity()};
    Placement placement = from;
    for (int iteration = 0, lastGain = 0; iteration < mostIterations && iteration - lastGain < patience;
         ++iteration) {
        if (stop.stop_requested() || index.empty() || !(radius > 0))
            return std::nullopt;
        const std::vector<Pair> pairs = nearestPairs(surface, placement, index, middle);
        if (pairs.size() < 6)
            return std::nullopt;
        const double rms = rmsOf(pairs);
        if (rms < gain * best.rms)
            lastGain = iteration;
        if (rms < best.rms)
            best = {placement, rms, iteration};
        RigidFit step(middle, radius);
        for (const Pair& pair : pairs)
            step.add(pair);
        const std::optional<Placement> moved = step.moved(placement);
        if (!moved)
            return std::nullopt;
        if (progress)
            progress(iteration);
        placement = *moved;
    }
    return best;
}

} // namespace bolster
