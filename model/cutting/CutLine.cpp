#include "CutLine.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace bolster {

namespace {

constexpr double scale = 1e4;    // Clipper counts in 0.1 micrometres
constexpr double mostMitre = 4;  // times the allowance: a longer tip is cut off, and a longer fold is none
constexpr double arcStep = 0.07; // radians; 10 mm around a corner: 6 micrometres
constexpr double leastTurn = 1e-9;

using ClipperLib::IntPoint;
using Path = ClipperLib::Path;
using Paths = ClipperLib::Paths;

IntPoint rounded(const Vec2& point)
{
    return {std::llround(point.x() * scale), std::llround(point.y() * scale)};
}

Vec2 exact(const IntPoint& point)
{
    return Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) / scale;
}

/// Right of the direction, where counter-clockwise lines have their outer side.
Vec2 outwards(const Vec2& direction)
{
    return {direction.y(), -direction.x()};
}

/// Points of the offset of a smooth line, which are no corners of the result. Clipper moves them by a unit or two.
class SmoothPoints {
public:
    void add(const Vec2& point)
    {
        const IntPoint p = rounded(point);
        m_cells.insert({p.X / cell, p.Y / cell});
    }
    bool contains(const IntPoint& p) const
    {
        for (const int dx : {-slack, slack})
            for (const int dy : {-slack, slack})
                if (m_cells.contains({(p.X + dx) / cell, (p.Y + dy) / cell}))
                    return true;
        return false;
    }

private:
    static constexpr int cell = 50, slack = 20;
    std::set<std::pair<ClipperLib::cInt, ClipperLib::cInt>> m_cells;
};

/// Everything that belongs to the piece, a part at a time; and what is taken off it again.
class Parts {
public:
    void add(std::initializer_list<Vec2> polygon) { put(m_added, {polygon}); }
    void add(const std::vector<Vec2>& polygon) { put(m_added, polygon); }
    void takeOff(std::initializer_list<Vec2> polygon) { put(m_taken, {polygon}); }

    Paths whole() const
    {
        Paths all;
        ClipperLib::Clipper clipper;
        clipper.AddPaths(m_added, ClipperLib::ptSubject, true);
        clipper.Execute(ClipperLib::ctUnion, all, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        if (m_taken.empty())
            return all;
        Paths rest;
        ClipperLib::Clipper second;
        second.AddPaths(all, ClipperLib::ptSubject, true);
        second.AddPaths(m_taken, ClipperLib::ptClip, true);
        second.Execute(ClipperLib::ctDifference, rest, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        return rest;
    }

private:
    /// All the same way round, so that none cancels another one.
    static void put(Paths& paths, const std::vector<Vec2>& polygon)
    {
        Path path;
        for (const Vec2& point : polygon)
            path.push_back(rounded(point));
        if (ClipperLib::Area(path) < 0)
            ClipperLib::ReversePath(path);
        if (path.size() > 2 && ClipperLib::Area(path) > 0)
            paths.push_back(std::move(path));
    }

    Paths m_added, m_taken;
};

/// A corner of the sewing line: both edges meet at p.
struct Corner {
    Vec2 p;
    Vec2 d1, d2; ///< directions of the edges
    double w1, w2;

    Vec2 n1() const { return outwards(d1); }
    Vec2 n2() const { return outwards(d2); }
    double sine() const { return cross(d1, d2); }
    double cosine() const { return d1.dot(d2); }
    Vec2 end1() const { return p + w1 * n1(); }
    Vec2 end2() const { return p + w2 * n2(); }
    double widest() const { return std::max(w1, w2); }
    /// How far the first cut line runs on until it meets the second one; negative: it does before its end.
    double ahead() const { return (w2 - w1 * cosine()) / sine(); }
    double behind() const { return (w1 - w2 * cosine()) / sine(); }
    /// Where the second cut line crosses the first edge.
    Vec2 crossing() const { return p + (w2 / sine()) * d1; }
};

class Joins {
public:
    Joins(Parts& parts, SmoothPoints& smooth)
        : m_parts(parts)
        , m_smooth(smooth)
    {}

    /// Convex ones alone; at the others the allowances overlap.
    void add(const Corner& c, CornerJoin join)
    {
        if (c.widest() <= 0 || c.sine() < -leastTurn || (c.sine() <= leastTurn && c.cosine() > 0))
            return;
        if (c.sine() <= leastTurn) { // a spike: there is no point where the cut lines meet
            round(c);
            return;
        }
        switch (join) {
        case CornerJoin::Mitred:
            cutOff(c, mostMitre * c.widest());
            break;
        case CornerJoin::Square:
            cutOff(c, c.widest());
            break;
        case CornerJoin::Rounded:
            c.w1 == c.w2 ? round(c) : roundOff(c);
            break;
        case CornerJoin::Folded:
            fold(c, true);
            break;
        case CornerJoin::Stepped:
            fold(c, false);
            break;
        }
    }

    /// Between two samples of a smooth curve.
    void smooth(const Corner& c)
    {
        const Vec2 middle = c.p + (c.n1() + c.n2()) * (c.w1 / (1 + c.cosine()));
        for (const Vec2& point : {c.end1(), middle, c.end2()})
            m_smooth.add(point);
        if (c.sine() > 0)
            m_parts.add({c.p, c.end1(), middle, c.end2()});
    }

private:
    /// To the point where the cut lines meet, but nothing beyond a distance from the corner.
    void cutOff(const Corner& c, double most)
    {
        const double ahead = c.ahead(), behind = c.behind();
        if (ahead < 0 || behind < 0) // one of the bands reaches over the other's end
            return;
        const Vec2 tip = c.end1() + ahead * c.d1;
        const Vec2 axis = (tip - c.p).normalized();
        if ((tip - c.p).norm() <= most) {
            m_parts.add({c.p, c.end1(), tip, c.end2()});
            return;
        }
        const auto stop = [&](const Vec2& from, const Vec2& along, double length) {
            const double speed = along.dot(axis);
            const double t = speed > 1e-9 ? (most - (from - c.p).dot(axis)) / speed : length;
            return Vec2(from + std::clamp(t, 0.0, length) * along);
        };
        m_parts.add({c.p, c.end1(), stop(c.end1(), c.d1, ahead), stop(c.end2(), -c.d2, behind), c.end2()});
    }

    /// From one cut line to the other, tangent to both: of different allowances part of an ellipse.
    void roundOff(const Corner& c)
    {
        const double ahead = c.ahead(), behind = c.behind();
        if (ahead < 0 || behind < 0) // one of the bands reaches over the other's end
            return;
        const Vec2 tip = c.end1() + ahead * c.d1;
        const double turn = std::atan2(c.sine(), c.cosine()), weight = std::cos(turn / 2);
        const int steps = std::max(2, static_cast<int>(std::ceil(turn / arcStep)));
        std::vector<Vec2> fan{c.p, c.end1()};
        for (int k = 1; k < steps; ++k) { // a conic as a rational Bezier curve of degree 2
            const double t = static_cast<double>(k) / steps;
            const double a = (1 - t) * (1 - t), b = 2 * weight * t * (1 - t), d = t * t;
            fan.emplace_back((a * c.end1() + b * tip + d * c.end2()) / (a + b + d));
            m_smooth.add(fan.back());
        }
        fan.push_back(c.end2());
        if (ahead > 0)
            m_smooth.add(c.end1());
        if (behind > 0)
            m_smooth.add(c.end2());
        m_parts.add(fan);
    }

    void round(const Corner& c)
    {
        const double turn = std::atan2(c.sine(), c.cosine());
        const double whole = turn > 0 ? turn : turn + 2 * std::numbers::pi;
        const int steps = std::max(2, static_cast<int>(std::ceil(whole / arcStep)));
        std::vector<Vec2> fan{c.p, c.end1()};
        for (int k = 1; k < steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            const Vec2 way = Eigen::Rotation2Dd(share * whole) * c.n1();
            fan.push_back(c.p + ((1 - share) * c.w1 + share * c.w2) * way);
            m_smooth.add(fan.back());
        }
        m_smooth.add(c.end1()); // an arc goes on from the band without a corner
        m_smooth.add(c.end2());
        fan.push_back(c.end2());
        m_parts.add(fan);
    }

    /// The first allowance ends where the second cut line crosses the edge: at right angles, or as the mirror image
    /// of that line, so that it does not stick out when it is folded back. Where the edges hardly turn, or turn
    /// nearly back, that place is far away: such a corner is mitred.
    void fold(const Corner& c, bool mirrored)
    {
        const double most = mostMitre * c.widest();
        const double reach = c.w2 / c.sine(), folded = mirrored ? reach + c.w1 * c.cosine() / c.sine() : reach;
        if (std::max(reach, std::abs(folded)) > most) {
            cutOff(c, most);
            return;
        }
        const Vec2 foot = c.crossing();
        const Vec2 square = foot + c.w1 * c.n1();
        m_parts.add({c.p, foot, square, c.end1()});
        m_parts.add({c.p, foot, c.end2()});
        if (!mirrored)
            return;
        const Vec2 slant = c.p + folded * c.d1 + c.w1 * c.n1();
        (slant - square).dot(c.d1) > 0 ? m_parts.add({foot, slant, square})
                                       : m_parts.takeOff({foot, square, slant});
    }

    Parts& m_parts;
    SmoothPoints& m_smooth;
};

/// Without what Clipper's rounding leaves: points nearer than a micrometre, or on the line between their
/// neighbours.
Path tidied(Path path)
{
    ClipperLib::CleanPolygon(path, 5);
    return path;
}

} // namespace

CutLine cutLineOf(const SewingLine& line)
{
    const std::vector<SewingLine::Vertex>& vertices = line.vertices;
    const std::size_t count = vertices.size();
    CutLine result;
    if (count < 3)
        return result;
    if (std::ranges::all_of(vertices, [](const auto& v) { return v.width <= 0; })) {
        for (const SewingLine::Vertex& vertex : vertices)
            result.points.push_back({vertex.at, vertex.corner});
        return result;
    }
    Parts parts;
    SmoothPoints smooth;
    Joins joins(parts, smooth);
    std::vector<Vec2> inside;
    for (std::size_t i = 0; i < count; ++i) {
        const SewingLine::Vertex &before = vertices[(i + count - 1) % count], &here = vertices[i],
                                 &after = vertices[(i + 1) % count];
        inside.push_back(here.at);
        const Vec2 d1 = (here.at - before.at).normalized(), d2 = (after.at - here.at).normalized();
        const Vec2 out = here.width * outwards(d2);
        if (here.width > 0)
            parts.add({here.at, after.at, after.at + out, here.at + out});
        else if (!here.corner)
            smooth.add(here.at);
        const Corner corner{here.at, d1, d2, before.width, here.width};
        if (here.corner)
            joins.add(corner, here.join);
        else if (before.width == here.width)
            joins.smooth(corner);
    }
    parts.add(inside);

    double largest = 0;
    for (const Path& path : parts.whole()) {
        const double area = ClipperLib::Area(path);
        if (area <= 0) {
            if (area < -scale * scale) // more than a square millimetre; less is rounding
                result.gaps.push_back(exact(path.front()));
            continue;
        }
        if (area <= largest)
            continue;
        largest = area;
        result.points.clear();
        for (const IntPoint& point : tidied(path))
            result.points.push_back({exact(point), !smooth.contains(point)});
    }
    return result;
}

} // namespace bolster
