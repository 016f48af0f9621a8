#include "FitGoals.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double farthest = 60;    // mm: what is farther from the target does not belong to it
constexpr double mostPoints = 1e6; // of a target
constexpr double unseen = 0.3;     // mm between a seam's sides: nobody notices it at the machine

} // namespace

FitTarget targetOf(const TriangleMesh& mesh)
{
    double area = 0;
    const auto corner = [&](const auto& t, int k) { return mesh.points[t[k]]; };
    for (const auto& t : mesh.triangles)
        area += 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    const double spacing = std::max(2.5, std::sqrt(area / mostPoints));
    PointCloud cloud;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = corner(t, 0), b = corner(t, 1) - a, c = corner(t, 2) - a;
        const int parts = static_cast<int>(std::ceil(std::max({b.norm(), c.norm(), (c - b).norm()}) / spacing));
        for (int i = 0; i < parts; ++i) // middles of the triangle's small triangles
            for (int j = 0; i + j < parts; ++j)
                cloud.points.emplace_back(a + (i + 1.0 / 3) / parts * b + (j + 1.0 / 3) / parts * c);
    }
    Scan place;
    place.threshold = farthest;
    return {place, std::make_shared<ScanIndex>(cloud, place.cuts)};
}

FitTarget targetOf(const Scan& scan, const PointCloud& cloud)
{
    return {scan, std::make_shared<ScanIndex>(cloud, scan.cuts)};
}

bool FitArea::hasWhole(ElementId patch) const
{
    return isAll() || patches.contains(patch);
}

bool FitArea::hasAny(ElementId patch) const
{
    return hasWhole(patch) || std::ranges::find(spots, patch, &AreaSpot::patch) != spots.end();
}

bool FitArea::has(ElementId patch, const Vec2& place) const
{
    return hasWhole(patch) || std::ranges::any_of(spots, [&](const AreaSpot& spot) {
               return spot.patch == patch && (spot.at - place).squaredNorm() <= spot.radius * spot.radius;
           });
}

bool missesLengths(const FitLocks& locks, const FitFigures& before, const FitFigures& after)
{
    return locks.lengths && locks.ease && after.sewnMost > before.sewnMost + unseen;
}

bool mendsLengths(const FitLocks& locks, const FitFigures& before, const FitFigures& after)
{
    return locks.lengths && locks.ease && before.sewnMost > after.sewnMost + unseen;
}

bool strainsForLittle(const FitFigures& before, const FitFigures& after)
{
    constexpr double littleGained = 0.9; // times the distance before
    constexpr double muchMore = 0.05;    // of the cover
    return after.distanceRms > littleGained * before.distanceRms && after.overLimit > before.overLimit + muchMore;
}

bool strainsMore(const FitFigures& before, const FitFigures& after)
{
    constexpr double notablyMore = 0.01; // of the cover
    return after.overLimit > before.overLimit + notablyMore;
}

std::vector<MissedGoal> missedGoals(bool strained, const FitFigures& before, const FitFigures& after)
{
    constexpr double hardlyNearer = 0.9;              // of what it was
    constexpr double mostOfIt = 0.5;                  // of all there is
    constexpr double nearMm = 0.5, nearShare = 0.005; // that is reached
    std::vector<MissedGoal> missed;
    const auto length = [&](MissedGoal::Kind kind, double was, double is) {
        if (was > nearMm && is > hardlyNearer * was)
            missed.push_back({kind, was, is});
    };
    const auto share = [&](MissedGoal::Kind kind, double was, double is) {
        if (was > nearShare && (is > hardlyNearer * was || is > mostOfIt))
            missed.push_back({kind, was, is});
    };
    length(MissedGoal::Kind::Form, before.distanceRms, after.distanceRms);
    if (strained)
        share(MissedGoal::Kind::Strain, before.overLimit, after.overLimit);
    share(MissedGoal::Kind::Smooth, before.pressed, after.pressed);
    length(MissedGoal::Kind::Seams, before.seamRms, after.seamRms);
    share(MissedGoal::Kind::Sizes, before.sizeMost, after.sizeMost);
    return missed;
}

} // namespace bolster
