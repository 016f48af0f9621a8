#include "PieceNotches.h"

#include "DrawnWords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double usualDepth = 4;    // mm
constexpr double deepestNotch = 50; // mm
constexpr double onOutline = 1.5;   // mm: on a curve the two of a double notch are beside it

double sensible(double size)
{
    return std::clamp(size, 0.5, deepestNotch);
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
    if (line.closed || p.size() < 2 || p.size() > 40)
        return std::nullopt;
    const double near = std::min(onOutline, 0.3 * line.box().sizes().norm());
    const auto isOn = [&](const Vec2& at) { return outline.distance(at) < near; };
    if (!isOn(p.front()) && isOn(p.back()))
        std::ranges::reverse(p);
    if (!isOn(p.front()))
        return std::nullopt;
    FoundNotch notch;
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
    if (!(notch.shape.depth > 0.1) || notch.shape.depth > deepestNotch)
        return std::nullopt;
    // What was written with four decimals was meant with two.
    const auto rounded = [](double size) { return sensible(std::round(size * 100) / 100); };
    notch.shape.depth = rounded(notch.shape.depth);
    notch.shape.width = rounded(notch.shape.width);
    return notch;
}

void pairDoubles(std::vector<FoundNotch>& notches)
{
    for (std::size_t i = 0; i < notches.size(); ++i)
        for (std::size_t k = i + 1; k < notches.size(); ++k) {
            FoundNotch &a = notches[i], &b = notches[k];
            const double apart = (a.at - b.at).norm();
            if (a.twice || b.twice || !(a.shape == b.shape) || std::abs(apart - doubleDistance(a.shape)) > 0.3)
                continue;
            a.at = (a.at + b.at) / 2;
            a.twice = true;
            notches.erase(notches.begin() + static_cast<std::ptrdiff_t>(k));
            break;
        }
}

} // namespace bolster
