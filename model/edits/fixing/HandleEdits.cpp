#include "HandleEdits.h"

#include "ArcLength.h"
#include "CurveFit.h"
#include "ElementEdits.h"
#include "PatternLocator.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double tolerance = 0.2; // mm, of the curve in space
constexpr int mostSamples = 2000;
constexpr double smallestKink = 0.1; // jump of the velocity, relative to it

Vec3 placeOf(const SurfaceMesh& surface, const PatternLocator& locator, const Vec2& p)
{
    const PatternPlace at = locator.locate(p);
    Vec3 place = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        place += at.weights[k] * surface.positions[at.corners[static_cast<std::size_t>(k)]];
    return place;
}

/// The parameters between two breaks of the curve, without the last one.
void addParameters(std::vector<double>& parameters, double t0, double t1, int count)
{
    for (int k = 0; k < count; ++k)
        parameters.push_back(t0 + (t1 - t0) * k / count);
}

/// Whether the line through the samples has a kink at sample i, or its speed jumps.
bool kinks(const CurveSamples& samples, std::size_t i)
{
    const std::size_t count = samples.points.size();
    const auto velocity = [&](std::size_t from, std::size_t to) -> Vec3 {
        double step = samples.parameters[to] - samples.parameters[from];
        if (step <= 0)
            step += samples.end - samples.start;
        return (samples.points[to] - samples.points[from]) / step;
    };
    const Vec3 before = velocity((i + count - 1) % count, i), after = velocity(i, (i + 1) % count);
    return (after - before).norm() > smallestKink * std::max(before.norm(), after.norm());
}

} // namespace

std::optional<BSpline3> liftedCurve(const SurfaceMesh& surface, ElementId patch, const BSpline2& curve)
{
    const auto& patches = surface.topology->patches;
    const auto range = std::find_if(patches.begin(), patches.end(),
                                    [&](const SurfaceTopology::PatchRange& r) { return r.patch == patch; });
    if (range == patches.end() || range->triangleCount == 0 || curve.empty())
        return std::nullopt;
    const PatternLocator locator(*surface.topology, *range);
    CurveSamples samples;
    samples.start = curve.domainStart();
    samples.end = curve.domainEnd();
    samples.closed = curve.closed();
    const ArcLength2 length(curve);
    const std::vector<double> breaks = curve.breaks();
    // A dozen a span at least, and closer than triangles are large.
    const double step = std::max(length.total() / mostSamples, 3.0);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
        addParameters(samples.parameters, breaks[k], breaks[k + 1],
                      std::max(12, static_cast<int>(length.between(breaks[k], breaks[k + 1]) / step)));
    if (!samples.closed)
        samples.parameters.push_back(samples.end);
    for (const double t : samples.parameters)
        samples.points.push_back(placeOf(surface, locator, curve.at(t)));
    for (const double t : curve.corners()) {
        const auto at = std::lower_bound(samples.parameters.begin(), samples.parameters.end(), t);
        if (at != samples.parameters.end() && *at == t &&
            kinks(samples, static_cast<std::size_t>(at - samples.parameters.begin())))
            samples.corners.push_back(t);
    }
    return fitCurve(samples, tolerance);
}

Edit addHandleCurve(const Design& design, const SurfaceMesh& surface, ElementId patch, BSpline2 curve,
                    const std::string& name)
{
    std::optional<BSpline3> target = liftedCurve(surface, patch, curve);
    if (!target)
        return {};
    HandleCurve handle;
    handle.name = name;
    handle.patch = patch;
    handle.curve = std::move(curve);
    handle.target = std::move(*target);
    handle.match = Match::Parameter; // the cover may be stretched unevenly along the curve
    return addElement(design, makeElement(std::move(handle)));
}

Edit addFancySeam(const Design& design, ElementId patch, BSpline2 curve, const std::string& name)
{
    FancySeam seam;
    seam.name = name;
    seam.patch = patch;
    seam.curve = std::move(curve);
    return addElement(design, makeElement(std::move(seam)));
}

std::optional<BSpline2> drawnCurve(const std::vector<Vec2>& points, bool closed, bool smooth)
{
    const int count = static_cast<int>(points.size());
    if (count < (closed ? 3 : 2))
        return std::nullopt;
    const int degree = smooth ? std::min(3, closed ? 3 : count - 1) : 1;
    std::vector<double> knots;
    if (degree == 1) {
        knots.push_back(0);
        for (int k = 1; k < count + (closed ? 1 : 0); ++k)
            knots.push_back(
                knots.back() +
                (points[static_cast<std::size_t>(k % count)] - points[static_cast<std::size_t>(k - 1)]).norm());
        if (!closed) {
            knots.insert(knots.begin(), knots.front());
            knots.push_back(knots.back());
        }
    }
    if (BSpline2::problem(degree, closed, points, knots))
        return std::nullopt;
    return BSpline2(degree, closed, points, knots);
}

} // namespace bolster::edits
