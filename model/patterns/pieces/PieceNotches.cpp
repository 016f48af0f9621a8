#include "PieceNotches.h"

#include "DrawnWords.h"
#include "PointGrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double usualDepth = 4;             // mm
constexpr double deepestNotch = 50;          // mm
constexpr double onOutline = 1.5;            // mm: on a curve the two of a double notch are beside it
constexpr double besideEachOther = 3;        // mm: nobody means two places by that
constexpr std::size_t mostBars = 20;         // at one tip
constexpr std::size_t mostNotchPoints = 200; // of a round one

/// What was written with four decimals was meant with two.
double sensible(double size)
{
    return std::clamp(std::round(size * 100) / 100, 0.5, deepestNotch);
}

NotchShape::Kind kindOfLayer(const std::string& layer, bool hasWidth)
{
    const std::string number(trimmed(layer));
    if (number == "80")
        return NotchShape::Kind::T;
    if (number == "81")
        return NotchShape::Kind::Castle;
    if (number == "82")
        return NotchShape::Kind::V;
    if (number == "83")
        return NotchShape::Kind::U;
    return hasWidth ? NotchShape::Kind::V : NotchShape::Kind::Slit;
}

/// How far apart the two of a double notch are (notchPoints).
double doubleDistance(const NotchShape& shape)
{
    return std::max(shape.width, 5.0) + 2;
}

std::optional<FoundNotch> finished(FoundNotch notch)
{
    if (!(notch.shape.depth > 0.1) || notch.shape.depth > deepestNotch)
        return std::nullopt;
    notch.shape.depth = sensible(notch.shape.depth);
    notch.shape.width = sensible(notch.shape.width);
    return notch;
}

} // namespace

FoundNotch notchOfDot(const DrawnDot& dot, double unit)
{
    FoundNotch notch;
    notch.at = unit * dot.at;
    const double depth = std::abs(dot.height) * unit, width = std::abs(dot.thickness) * unit;
    notch.shape.kind = kindOfLayer(dot.layer, width > 1e-6);
    if (depth > 1e-6)
        notch.shape.depth = sensible(depth);
    else
        notch.shape.depth = usualDepth;
    if (width > 1e-6)
        notch.shape.width = sensible(width);
    if (dot.angle)
        notch.inwards =
            Vec2(std::cos(*dot.angle * std::numbers::pi / 180), std::sin(*dot.angle * std::numbers::pi / 180));
    return notch;
}

std::optional<FoundNotch> notchOfLine(const Contour& line, const Contour& outline)
{
    std::vector<Vec2> p = line.places();
    if (line.closed || p.size() < 2 || p.size() > mostNotchPoints)
        return std::nullopt;
    const double near = std::min(onOutline, 0.3 * line.box().sizes().norm());
    const auto isOn = [&](const Vec2& at) { return outline.distance(at) < near; };
    if (!isOn(p.front()) && isOn(p.back()))
        std::ranges::reverse(p);
    FoundNotch notch;
    if (p.size() == 3 && isOn(p[1]) && !isOn(p[0])) { // a V whose tip is where it is cut
        const Vec2 way = (p[0] + p[2]) / 2 - p[1];
        notch.at = p[1];
        notch.shape = {NotchShape::Kind::V, way.norm(), (p[2] - p[0]).norm()};
        notch.inwards = way.normalized();
        return finished(notch);
    }
    if (!isOn(p.front()))
        return std::nullopt;
    // The bar of a T lies across the end of its first line.
    const bool bar = p.size() == 4 && ((p[2] + p[3]) / 2 - p[1]).norm() < 0.1 * (p[3] - p[2]).norm();
    if (p.size() == 2 || bar) {
        const bool slit = p.size() == 2;
        notch.at = p[0];
        notch.shape.kind = slit ? NotchShape::Kind::Slit : NotchShape::Kind::T;
        notch.shape.depth = (p[1] - p[0]).norm();
        notch.shape.width = slit ? notch.shape.width : (p[3] - p[2]).norm();
        notch.inwards = (p[1] - p[0]).normalized();
    } else {
        notch.at = (p.front() + p.back()) / 2;
        notch.shape.kind = p.size() == 3   ? NotchShape::Kind::V
                           : p.size() == 4 ? NotchShape::Kind::Castle
                                           : NotchShape::Kind::U;
        notch.shape.width = (p.back() - p.front()).norm();
        const Vec2 along = (p.back() - p.front()).normalized();
        double deepest = 0;
        for (const Vec2& point : p)
            if (const double depth = cross(along, Vec2(point - p.front())); std::abs(depth) > std::abs(deepest))
                deepest = depth;
        notch.shape.depth = std::abs(deepest);
        notch.inwards = std::copysign(1, deepest) * Vec2(-along.y(), along.x());
    }
    return finished(notch);
}

std::vector<Contour> withBars(std::vector<Contour> lines)
{
    std::vector<bool> gone(lines.size(), false);
    PointGrid grid(1);
    const auto isStroke = [](const Contour& line) { return !line.closed && line.points.size() == 2; };
    const auto ends = [](const Contour& line) { return std::pair(line.points[0].at, line.points[1].at); };
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isStroke(lines[i]) && (lines[i].points[1].at - lines[i].points[0].at).norm() < deepestNotch)
            grid.add((lines[i].points[0].at + lines[i].points[1].at) / 2, i);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (gone[i] || !isStroke(lines[i]))
            continue;
        const auto [a, b] = ends(lines[i]);
        for (const auto& [from, tip] : {std::pair(a, b), std::pair(b, a)})
            grid.some(tip, mostBars, [&, from = from, tip = tip](std::size_t k) {
                if (k == i || gone[k] || gone[i] || lines[i].points.size() != 2)
                    return;
                const auto [c, d] = ends(lines[k]);
                const Vec2 stem = tip - from, bar = d - c;
                if (stem.norm() > deepestNotch || ((c + d) / 2 - tip).norm() > 0.05 * bar.norm() ||
                    std::abs(stem.dot(bar)) > 0.2 * stem.norm() * bar.norm())
                    return;
                lines[i].points = {{from}, {tip}, {c}, {d}};
                gone[k] = true;
            });
    }
    std::vector<Contour> kept;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!gone[i])
            kept.push_back(std::move(lines[i]));
    return kept;
}

void pairDoubles(std::vector<FoundNotch>& notches)
{
    for (std::size_t i = 0; i < notches.size(); ++i)
        for (std::size_t k = i + 1; k < notches.size(); ++k) {
            FoundNotch &a = notches[i], &b = notches[k];
            const double apart = (a.at - b.at).norm();
            const bool beside = apart < besideEachOther;
            if (b.twice || !(a.shape == b.shape) || (a.twice && !beside) ||
                (!beside && std::abs(apart - doubleDistance(a.shape)) > 0.3))
                continue;
            // A third one says no more than two, but where the middle is.
            a.at = a.twice ? Vec2((2 * a.at + b.at) / 3) : Vec2((a.at + b.at) / 2);
            a.twice = true;
            notches.erase(notches.begin() + static_cast<std::ptrdiff_t>(k));
            --k;
        }
}

} // namespace bolster
