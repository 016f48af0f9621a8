#include "DrawingPen.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double fullTurn = 2 * std::numbers::pi;
constexpr double arcStep = fullTurn / 180; // 0.04 mm from an arc of 250 mm
constexpr int cubicSteps = 32;

} // namespace

void DrawingPen::arcTo(const Vec2& centre, const Vec2& a, const Vec2& b, double from, double sweep)
{
    sweep = std::clamp(sweep, -fullTurn, fullTurn);
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / arcStep)));
    const auto at = [&](int k) {
        const double t = from + sweep * k / steps;
        return Vec2(centre + std::cos(t) * a + std::sin(t) * b);
    };
    if (empty())
        moveTo(at(0));
    for (int k = 1; k < steps; ++k)
        add(at(k), Bend::Smooth);
    add(at(steps), Bend::Unknown);
}

void DrawingPen::bulgeTo(const Vec2& at, double bulge)
{
    const Vec2 chord = at - m_place;
    if (std::abs(bulge) < 1e-9 || !std::isfinite(bulge) || chord.norm() < 1e-12) {
        lineTo(at);
        return;
    }
    const double sweep = 4 * std::atan(bulge);
    // The centre lies on the left of the chord for positive bulges below a half circle.
    const Vec2 left(-chord.y(), chord.x());
    const Vec2 centre = m_place + chord / 2 + left * ((1 - bulge * bulge) / (4 * bulge));
    const Vec2 radius = m_place - centre;
    arcTo(centre, radius, Vec2(-radius.y(), radius.x()), 0, sweep);
    m_place = at;
    m_points.back().at = m_map * at;
}

void DrawingPen::cubicTo(const Vec2& b, const Vec2& c, const Vec2& d)
{
    const Vec2 a = m_place;
    for (int k = 1; k <= cubicSteps; ++k) {
        const double t = static_cast<double>(k) / cubicSteps, s = 1 - t;
        add(k == cubicSteps ? d : Vec2(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d),
            k == cubicSteps ? Bend::Unknown : Bend::Smooth);
    }
}

void DrawingPen::smoothTo(const std::vector<Vec2>& points)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        if (empty())
            moveTo(points[i]);
        else
            add(points[i], i + 1 < points.size() ? Bend::Smooth : Bend::Unknown);
}

DrawnLine DrawingPen::line(std::string layer, bool closed)
{
    DrawnLine result{std::move(layer), {}, closed, 0, {}};
    Box2 box;
    for (const DrawnPoint& point : m_points)
        box.extend(point.at);
    const double same = m_points.empty() ? 0 : 1e-9 * (box.sizes().norm() + 1e-9);
    for (const DrawnPoint& point : m_points)
        if (result.points.empty() || (point.at - result.points.back().at).norm() > same)
            result.points.push_back(point);
    while (result.closed && result.points.size() > 1 &&
           (result.points.back().at - result.points.front().at).norm() <= same)
        result.points.pop_back();
    m_points.clear();
    return result;
}

} // namespace bolster
