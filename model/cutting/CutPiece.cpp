#include "CutPiece.h"

#include "SegmentDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {

namespace {

std::vector<Vec2> notchLine(const NotchShape& shape, const Vec2& at, const Vec2& in)
{
    const Vec2 side = Vec2(-in.y(), in.x()) * (shape.width / 2);
    const Vec2 deep = in * shape.depth;
    switch (shape.kind) {
    case NotchShape::Kind::Slit:
        return {at, at + deep};
    case NotchShape::Kind::V:
        return {at - side, at + deep, at + side};
    case NotchShape::Kind::T:
        return {at, at + deep, at + deep - side, at + deep + side};
    case NotchShape::Kind::Castle:
        return {at - side, at - side + deep, at + side + deep, at + side};
    case NotchShape::Kind::U:
        break;
    }
    std::vector<Vec2> line{at - side};
    const double radius = std::min(shape.width / 2, shape.depth);
    const Vec2 centre = at + in * (shape.depth - radius);
    constexpr int steps = 8;
    for (int k = 0; k <= steps; ++k) {
        const double angle = std::numbers::pi * k / steps;
        line.push_back(centre - side * std::cos(angle) + in * (radius * std::sin(angle)));
    }
    line.push_back(at + side);
    return line;
}

void mirror(Vec2& point)
{
    point.x() = -point.x();
}

void mirror(BSpline2& curve)
{
    if (curve.empty())
        return;
    std::vector<Vec2> points = curve.points();
    for (Vec2& point : points)
        mirror(point);
    curve = curve.withPoints(std::move(points));
}

void mirror(std::vector<LinePoint>& line, bool closed)
{
    for (LinePoint& point : line)
        mirror(point.at);
    if (closed)
        std::ranges::reverse(line);
}

} // namespace

Box2 CutPiece::box() const
{
    Box2 box;
    for (const LinePoint& point : cut)
        box.extend(point.at);
    return box;
}

std::string quantityText(const CutPiece& piece)
{
    return std::to_string(piece.quantity).append(",").append(std::to_string(piece.pair ? piece.quantity : 0));
}

double distanceTo(const std::vector<LinePoint>& line, const Vec2& point)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.size(); ++i)
        least = std::min(least, segmentDistance(point, line[i].at, line[(i + 1) % line.size()].at));
    return least;
}

bool isInside(const std::vector<LinePoint>& line, const Vec2& point)
{
    bool inside = false;
    for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
        const Vec2 &a = line[i].at, &b = line[j].at;
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

double areaOf(const std::vector<LinePoint>& line)
{
    double sum = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
        sum += cross(line[i].at, line[(i + 1) % line.size()].at);
    return sum / 2;
}

double lengthOf(const std::vector<LinePoint>& line, bool closed)
{
    double sum = 0;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i)
        sum += (line[(i + 1) % line.size()].at - line[i].at).norm();
    return sum;
}

CutPiece mirroredPiece(CutPiece piece)
{
    piece.grown.row(0) = -piece.grown.row(0).eval();
    mirror(piece.outline);
    mirror(piece.sew, true);
    mirror(piece.cut, true);
    for (Vec2& gap : piece.gaps)
        mirror(gap);
    for (CutNotch& notch : piece.notches) {
        mirror(notch.at);
        mirror(notch.inwards);
        mirror(notch.sewn);
    }
    for (CutHole& hole : piece.holes)
        mirror(hole.at);
    for (PieceLine& line : piece.inner) {
        mirror(line.curve);
        mirror(line.points, false);
    }
    mirror(piece.grain.from);
    mirror(piece.grain.to);
    mirror(piece.label.at);
    piece.label.rotation = -piece.label.rotation;
    piece.mirrored = !piece.mirrored;
    return piece;
}

std::vector<std::vector<Vec2>> grainLines(const GrainLine& grain)
{
    constexpr double length = 6, half = 2; // of a head, mm
    if (grain.from == grain.to)
        return {};
    std::vector<std::vector<Vec2>> lines{{grain.from, grain.to}};
    const Vec2 way = (grain.to - grain.from).normalized(), side(-way.y(), way.x());
    const auto head = [&](const Vec2& tip, const Vec2& back) {
        lines.push_back({tip + length * back + half * side, tip, tip + length * back - half * side});
    };
    head(grain.to, -way);
    if (grain.nap != Nap::OneWay)
        head(grain.from, way);
    return lines;
}

std::vector<Vec2> notchPoints(const CutNotch& notch)
{
    if (!notch.twice)
        return {notch.at};
    const Vec2 along(-notch.inwards.y(), notch.inwards.x());
    const double apart = std::max(notch.shape.width, 5.0) / 2 + 1;
    return {notch.at - apart * along, notch.at + apart * along};
}

std::vector<std::vector<Vec2>> notchLines(const CutNotch& notch)
{
    std::vector<std::vector<Vec2>> lines;
    for (const Vec2& at : notchPoints(notch))
        lines.push_back(notchLine(notch.shape, at, notch.inwards));
    return lines;
}

} // namespace bolster
