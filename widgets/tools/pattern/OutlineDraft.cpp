#include "OutlineDraft.h"

#include "CurvePath.h"

#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double samePlace = 1e-3; // mm
constexpr int ellipsePoints = 12;  // a multiple of 4, so that width and height are exact

/// The two inner control points of the cubic from a to b.
std::pair<Vec2, Vec2> innerPoints(const DraftPoint& a, const DraftPoint& b)
{
    if (!a.handle && !b.handle)
        return {a.at + (b.at - a.at) / 3, b.at - (b.at - a.at) / 3};
    const Vec2 after = a.handle ? Vec2(a.at + *a.handle) : Vec2(a.at);
    const Vec2 before = b.handle ? Vec2(b.at - *b.handle) : Vec2(b.at);
    // From a corner the curve sets out towards the handle of the other point.
    return {a.handle ? after : Vec2((a.at + before) / 2), b.handle ? before : Vec2((b.at + after) / 2)};
}

void withoutRepeated(std::vector<DraftPoint>& points)
{
    const auto same = [](const DraftPoint& a, const DraftPoint& b) { return (a.at - b.at).norm() < samePlace; };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    while (points.size() > 1 && same(points.front(), points.back()))
        points.pop_back();
}

BSpline2 mixedOutline(const std::vector<DraftPoint>& points)
{
    std::vector<Vec2> control;
    std::vector<double> knots;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const DraftPoint& here = points[i];
        const Vec2 before = innerPoints(points[(i + points.size() - 1) % points.size()], here).second;
        const Vec2 after = innerPoints(here, points[(i + 1) % points.size()]).first;
        control.push_back(before);
        if (!here.handle)
            control.push_back(here.at);
        control.push_back(after);
        knots.insert(knots.end(), here.handle ? 2 : 3, static_cast<double>(i));
    }
    knots.push_back(static_cast<double>(points.size()));
    return BSpline2(3, true, std::move(control), std::move(knots));
}

void addPiece(QPainterPath& path, const DraftPoint& a, const DraftPoint& b)
{
    const auto [after, before] = innerPoints(a, b);
    if (a.handle || b.handle)
        path.cubicTo(toPoint(after), toPoint(before), toPoint(b.at));
    else
        path.lineTo(toPoint(b.at));
}

double side(QPointF a, QPointF b, QPointF c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool cross(const QLineF& a, const QLineF& b)
{
    return side(a.p1(), a.p2(), b.p1()) * side(a.p1(), a.p2(), b.p2()) < 0 &&
           side(b.p1(), b.p2(), a.p1()) * side(b.p1(), b.p2(), a.p2()) < 0;
}

} // namespace

std::optional<BSpline2> draftOutline(std::vector<DraftPoint> points)
{
    withoutRepeated(points);
    const bool polygon = std::ranges::none_of(points, [](const DraftPoint& p) { return p.handle.has_value(); });
    if (points.size() < (polygon ? 3U : 2U))
        return std::nullopt;
    if (!polygon) {
        BSpline2 outline = mixedOutline(points);
        return BSpline2::problem(3, true, outline.points(), outline.knots()) ? std::nullopt
                                                                             : std::optional(std::move(outline));
    }
    std::vector<Vec2> corners;
    for (const DraftPoint& point : points)
        corners.push_back(point.at);
    if (BSpline2::problem(1, true, corners))
        return std::nullopt;
    return BSpline2(1, true, std::move(corners));
}

QPainterPath draftPath(const std::vector<DraftPoint>& points)
{
    QPainterPath path;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (i == 0)
            path.moveTo(toPoint(points[i].at));
        else
            addPiece(path, points[i - 1], points[i]);
    return path;
}

QPainterPath closingPath(const std::vector<DraftPoint>& points)
{
    QPainterPath path;
    if (points.size() < 2)
        return path;
    path.moveTo(toPoint(points.back().at));
    addPiece(path, points.back(), points.front());
    return path;
}

bool crossesItself(const QPainterPath& path, double scale)
{
    std::vector<QLineF> lines;
    for (const QPolygonF& polygon : path.toSubpathPolygons(QTransform::fromScale(scale, scale)))
        for (qsizetype i = 0; i + 1 < polygon.size(); ++i)
            lines.emplace_back(polygon[i], polygon[i + 1]);
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = i + 2; j < lines.size(); ++j)
            if (cross(lines[i], lines[j]))
                return true;
    return false;
}

std::optional<BSpline2> rectangleOutline(const Vec2& a, const Vec2& b)
{
    if (!((b - a).cwiseAbs().minCoeff() > samePlace))
        return std::nullopt;
    const Vec2 least = a.cwiseMin(b);
    const Vec2 most = a.cwiseMax(b);
    const std::vector<Vec2> corners = {least, {most.x(), least.y()}, most, {least.x(), most.y()}};
    return BSpline2::problem(1, true, corners) ? std::nullopt : std::optional(BSpline2(1, true, corners));
}

std::optional<BSpline2> ellipseOutline(const Vec2& a, const Vec2& b)
{
    if (!((b - a).cwiseAbs().minCoeff() > samePlace))
        return std::nullopt;
    const Vec2 centre = (a + b) / 2;
    const double step = 2 * std::numbers::pi / ellipsePoints;
    // At a knot a uniform cubic is (p_(i-1) + 4 p_i + p_(i+1)) / 6.
    const Vec2 radii = (b - a).cwiseAbs() / 2 / ((4 + 2 * std::cos(step)) / 6);
    std::vector<Vec2> points;
    for (int i = 0; i < ellipsePoints; ++i)
        points.push_back(centre + radii.cwiseProduct(Vec2(std::cos(i * step), std::sin(i * step))));
    return BSpline2::problem(3, true, points) ? std::nullopt : std::optional(BSpline2(3, true, points));
}

} // namespace bolster
