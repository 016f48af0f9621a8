#include "CoverCurves.h"

namespace bolster {

namespace {

CoverCurve sampled(const ElementPtr& element)
{
    CoverCurve curve{element, {}, {}};
    const BSpline3& spline = curve.spline();
    const std::vector<double> breaks = spline.breaks();
    const int steps = spline.degree() == 1 ? 1 : 12; // per polynomial piece
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int step = 0; step < steps; ++step)
            curve.parameters.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * step / steps);
    curve.parameters.push_back(breaks.back());
    for (const double t : curve.parameters)
        curve.points.push_back(spline.at(t));
    return curve;
}

} // namespace

void CoverCurves::update(const Design& design, const std::set<ElementId>& unseen)
{
    std::map<ElementId, CoverCurve> curves;
    for (const auto& [id, element] : design.elements()) {
        const BSpline3* curve = spaceCurve(*element);
        if (!curve || curve->empty() || unseen.contains(id))
            continue;
        const auto known = m_curves.find(id);
        const bool unchanged = known != m_curves.end() && known->second.element == element;
        curves.emplace(id, unchanged ? std::move(known->second) : sampled(element));
    }
    m_curves = std::move(curves);
}

Box3 CoverCurves::box() const
{
    Box3 box;
    for (const auto& [id, curve] : m_curves)
        for (const Vec3& p : curve.points)
            box.extend(p);
    return box;
}

Box3 CoverCurves::box(const std::set<ElementId>& ids) const
{
    Box3 box;
    for (const auto& [id, curve] : m_curves)
        if (ids.contains(id))
            for (const Vec3& p : curve.points)
                box.extend(p);
    return box;
}

} // namespace bolster
