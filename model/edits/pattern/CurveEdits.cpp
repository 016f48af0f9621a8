#include "CurveEdits.h"

#include "ArcLength.h"
#include "EditHelpers.h"

namespace bolster::edits {

namespace {

Edit withFixation(const Design& design, ElementId id, std::optional<BSpline3> curve, Message verb)
{
    if (!curve)
        return {};
    return replaceElement(design, id, withSpaceCurve(*design.element(id), std::move(*curve)), std::move(verb));
}

const BSpline3* fixationOf(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    return element ? spaceCurve(*element) : nullptr; // alive as long as the design
}

/// Control points behind the first of one polynomial of that degree along the way.
std::vector<Vec3> pointsAlong(std::span<const Vec3> way, int degree)
{
    if (degree == 1)
        return {way.back()};
    if (degree == 2)
        return {2 * placeAlong(way, 0.5) - 0.5 * (way.front() + way.back()), way.back()};
    const Vec3 first = 27 * placeAlong(way, 1.0 / 3) - 8 * way.front() - way.back();
    const Vec3 second = 27 * placeAlong(way, 2.0 / 3) - way.front() - 8 * way.back();
    return {(2 * first - second) / 18, (2 * second - first) / 18, way.back()};
}

/// With one polynomial more behind the end, and every parameter as it was.
BSpline3 ledOn(const BSpline3& curve, std::span<const Vec3> way)
{
    std::vector<Vec3> points = curve.points();
    std::vector<double> knots = curve.knots();
    const double end = knots.back();
    const double width = curve.period() / (static_cast<double>(curve.breaks().size()) - 1);
    knots.pop_back(); // of an end there is one more than of a corner
    knots.insert(knots.end(), static_cast<std::size_t>(curve.degree()) + 1, end + width);
    for (const Vec3& point : pointsAlong(way, curve.degree()))
        points.push_back(point);
    return {curve.degree(), false, std::move(points), std::move(knots)};
}

/// The same curve with the parameters of another direction: t becomes -t.
BSpline3 turned(const BSpline3& curve)
{
    std::vector<Vec3> points(curve.points().rbegin(), curve.points().rend());
    std::vector<double> knots;
    for (auto knot = curve.knots().rbegin(); knot != curve.knots().rend(); ++knot)
        knots.push_back(-*knot);
    return {curve.degree(), false, std::move(points), std::move(knots)};
}

} // namespace

Edit moveCurvePoints(const Design& design, ElementId id, std::span<const int> points, const Vec3& delta)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve)
        return {};
    return withFixation(design, id, withMovedPoints(*curve, points, delta),
                        moveVerb(points.size(), displayName(design, id)));
}

Edit insertCurvePoint(const Design& design, ElementId id, double parameter)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve || !std::isfinite(parameter) || curve->pointCount() >= mostCurvePoints)
        return {};
    return withFixation(design, id, curve->withKnot(parameter), insertVerb(displayName(design, id)));
}

Edit removeCurvePoint(const Design& design, ElementId id, int point)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve || point < 0 || point >= curve->pointCount())
        return {};
    return withFixation(design, id, curve->withoutPoint(point), removeVerb(displayName(design, id)));
}

Edit leadCurveOn(const Design& design, ElementId id, std::span<const Vec3> way)
{
    const BSpline3* curve = fixationOf(design, id);
    if (!curve || curve->empty() || curve->closed() || way.size() < 2 ||
        curve->pointCount() + curve->degree() > mostCurvePoints)
        return {};
    const double first = (curve->points().front() - way.front()).norm();
    const double last = (curve->points().back() - way.front()).norm();
    std::vector<Vec3> from(way.begin(), way.end());
    from.front() = first < last ? curve->points().front() : curve->points().back();
    BSpline3 longer = first < last ? turned(ledOn(turned(*curve), from)) : ledOn(*curve, from);
    Edit edit = withFixation(design, id, std::move(longer),
                             {QT_TRANSLATE_NOOP("Message", "Lead %1 on"), {displayName(design, id)}});
    design.each<FixationSeam>([&](ElementId seam, const FixationSeam& fixed) {
        if (fixed.curve != id || fixed.curveRange)
            return;
        FixationSeam kept = fixed;
        kept.curveRange = {curve->domainStart(), curve->domainEnd()};
        edit.changes.push_back({seam, design.element(seam), makeElement(std::move(kept))});
    });
    return edit;
}

} // namespace bolster::edits
