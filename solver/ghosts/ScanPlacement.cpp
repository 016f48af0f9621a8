#include "ScanPlacement.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int mostIterations = 200;
constexpr std::size_t mostVertices = 4000;
constexpr double kept = 0.8;           // share of the pairs that count
constexpr double leastFraction = 1e-6; // of the largest eigenvalue: directions in which the cover slides on itself
constexpr double gain = 0.999;         // a smaller share of the rms counts as progress
constexpr int patience = 10;           // iterations without

struct Pair {
    Vec3 point;       // of the scan, placed, from the cover's middle
    Vec3 normal;      // of the scan's plane there
    double along = 0; // mm, from the cover to that plane
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
        pairs.push_back({point - middle, normal, normal.dot(point - at), (point - at).norm()});
    }
    const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(kept * static_cast<double>(pairs.size()));
    std::nth_element(pairs.begin(), end, pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    pairs.erase(end, pairs.end());
    return pairs;
}

/// The small turn (times the radius, so that both are lengths) and shift that bring the planes to the cover.
Vector6 bestStep(const std::vector<Pair>& pairs, double radius)
{
    Matrix6 matrix = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (const Pair& pair : pairs) {
        Vector6 row;
        row << pair.point.cross(pair.normal) / radius, pair.normal;
        matrix += row * row.transpose();
        right -= row * pair.along;
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6> axes(matrix);
    Vector6 step = Vector6::Zero();
    for (int k = 0; k < 6; ++k)
        if (axes.eigenvalues()[k] > leastFraction * axes.eigenvalues()[5]) {
            const Vector6 axis = axes.eigenvectors().col(k);
            step += axis * (axis.dot(right) / axes.eigenvalues()[k]);
        }
    return step;
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
        const Vector6 step = bestStep(pairs, radius);
        if (!step.allFinite())
            return std::nullopt;
        if (progress)
            progress(iteration);
        const Vec3 turn = step.head<3>() / radius;
        const Quat rotation(
            Eigen::AngleAxisd(turn.norm(), turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3(Vec3::UnitZ())));
        placement.position = rotation * (placement.position - middle) + middle + step.tail<3>();
        placement.rotation = (rotation * placement.rotation).normalized();
    }
    return best;
}

} // namespace bolster
