#include "SeamLineRows.h"

#include "PatternLocator.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int placesOfSeam = 40;
constexpr double weight = 2; // against 1 mm from a form

Vec3 placeOf(const std::array<std::uint32_t, 3>& corners, const Eigen::Vector3d& weights,
             const std::vector<Vec3>& places)
{
    return weights[0] * places[corners[0]] + weights[1] * places[corners[1]] + weights[2] * places[corners[2]];
}

} // namespace

SeamLineRows::SeamLineRows(const std::vector<SeamGoal>& goals, const Design& design)
    : m_goals(goals)
    , m_design(design)
{}

/// What is on the outline of the pattern that the triangles were made of goes with it when the outline changes.
std::vector<SeamLineRows::Place> SeamLineRows::placesOn(const WarmCover& cover) const
{
    std::vector<Place> places;
    const SurfaceTopology& topology = *cover.mesh().topology;
    for (const SeamGoal& goal : m_goals) {
        const auto* seam = cover.homeDesign().find<Seam>(goal.seam);
        const auto* patch = seam ? cover.homeDesign().find<Patch>(seam->a.patch) : nullptr;
        const auto range = std::ranges::find(topology.patches, seam ? seam->a.patch : noElement,
                                             &SurfaceTopology::PatchRange::patch);
        if (!patch || range == topology.patches.end() || range->triangleCount == 0)
            continue;
        const BSpline2& outline = patch->outline;
        const double end = unwrappedEnd(seam->a.from, seam->a.to, outline.domainStart(), outline.domainEnd());
        const PatternLocator locator(topology, *range);
        for (int k = 0; k <= placesOfSeam; ++k) {
            const double at = seam->a.from + (end - seam->a.from) * k / placesOfSeam;
            const PatternPlace found = locator.locate(outline.at(outline.wrapped(at)));
            places.push_back({found.corners, found.weights, &goal.line});
        }
    }
    return places;
}

void SeamLineRows::aim(const WarmCover& cover)
{
    m_aims.clear();
    const std::vector<Vec3> vertices = cover.surface()->positions;
    for (const Place& place : placesOn(cover)) {
        const auto nearest = place.line->closest(placeOf(place.corners, place.weights, vertices));
        const Vec3 along = place.line->derivative(nearest.parameter).normalized();
        const Vec3 other = std::abs(along.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
        const Vec3 first = along.cross(other).normalized();
        m_aims.push_back({place, {first, along.cross(first)}, place.line->at(nearest.parameter)});
    }
}

void SeamLineRows::add(const std::vector<Vec3>& places, std::vector<double>& rows) const
{
    const double each = m_aims.empty() ? 0 : weight / std::sqrt(static_cast<double>(m_aims.size()));
    for (const Aim& aim : m_aims) {
        const Vec3 off = placeOf(aim.place.corners, aim.place.weights, places) - aim.to;
        for (const Vec3& across : aim.across)
            rows.push_back(each * across.dot(off));
    }
}

double SeamLineRows::rms(const WarmCover& cover) const
{
    const std::vector<Vec3> vertices = cover.surface()->positions;
    double squares = 0;
    const std::vector<Place> places = placesOn(cover);
    for (const Place& place : places)
        squares += std::pow(place.line->closest(placeOf(place.corners, place.weights, vertices)).distance, 2);
    return places.empty() ? 0 : std::sqrt(squares / static_cast<double>(places.size()));
}

} // namespace bolster
