#include "CurvesForCad.h"

#include "CurveFit.h"

namespace bolster {

namespace {

/// Through the vertices of a chain; nothing when they are all at one place.
std::optional<BSpline3> curveThrough(const SurfaceMesh& surface, const std::vector<std::uint32_t>& chain,
                                     double tolerance)
{
    CurveSamples samples;
    double length = 0;
    for (const std::uint32_t vertex : chain) {
        const Vec3& p = surface.positions[vertex];
        if (!p.allFinite())
            return std::nullopt;
        const double step = samples.points.empty() ? 1 : (p - samples.points.back()).norm();
        if (step < 1e-6)
            continue;
        length += samples.points.empty() ? 0 : step;
        samples.points.push_back(p);
        samples.parameters.push_back(length);
    }
    if (samples.points.size() < 2)
        return std::nullopt;
    samples.end = length;
    return fitCurve(samples, tolerance);
}

} // namespace

std::vector<StepCurves> curvesForCad(const ModelSubject& subject, double tolerance)
{
    StepCurves fixed{"fixation curves", {}}, sewn{"seams", {}};
    subject.design.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        if (!curve.curve.empty())
            fixed.curves.push_back({elementLabel(id, *subject.design.element(id)), curve.curve});
    });
    for (const SurfaceTopology::Chain& chain : subject.surface->topology->seams)
        if (auto curve = curveThrough(*subject.surface, chain.a, tolerance)) {
            const ElementPtr seam = subject.design.element(chain.seam);
            sewn.curves.push_back({seam ? elementLabel(chain.seam, *seam) : "seam", std::move(*curve)});
        }
    return {fixed, sewn};
}

} // namespace bolster
