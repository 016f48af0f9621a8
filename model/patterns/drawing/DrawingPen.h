// Makes lines of whatever a format calls a curve. Private to the library.
#pragma once

#include "Drawing.h"
#include "FileRefused.h"
#include "ImportWatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

namespace bolster {

/// What a drawing may hold in all, however often its blocks are inserted. Refuses the file beyond.
class DrawingLimits {
public:
    explicit DrawingLimits(ImportWatch watch)
        : m_watch(std::move(watch))
    {}

    void count(std::size_t points)
    {
        m_points += points + 1;
        if (m_points > mostPoints)
            refuseFile(
                {},
                QT_TRANSLATE_NOOP("Message", "%1: more is drawn in it than a pattern can have (over %2 points)"),
                {std::to_string(mostPoints)});
        if (++m_calls % 256 == 0)
            m_watch.checkStop();
    }

private:
    static constexpr std::size_t mostPoints = 2'000'000;

    ImportWatch m_watch;
    std::size_t m_points = 0;
    std::size_t m_calls = 0;
};

/// Maps within maps can lead to where no pattern is.
inline bool inReach(const Vec2& at)
{
    return at.allFinite() && at.cwiseAbs().maxCoeff() < 1e12;
}

/// Draws one line, point by point, through a map. Curves become polygons that are nearer to them than anybody cuts.
class DrawingPen {
public:
    using Map = Eigen::Affine2d;

    explicit DrawingPen(const Map& map)
        : m_map(map)
    {}

    bool empty() const { return m_points.empty(); }
    /// Whether all of it lies where numbers are exact enough.
    bool isInReach() const
    {
        return std::ranges::all_of(m_points, [](const DrawnPoint& point) { return inReach(point.at); });
    }
    /// Where it is, before the map.
    const Vec2& place() const { return m_place; }

    void moveTo(const Vec2& at)
    {
        m_points.clear();
        add(at, Bend::Unknown);
    }
    void lineTo(const Vec2& at) { add(at, Bend::Unknown); }
    /// Part of an ellipse: centre + cos(t) * a + sin(t) * b for t from `from` by `sweep`.
    void arcTo(const Vec2& centre, const Vec2& a, const Vec2& b, double from, double sweep);
    /// As a LWPOLYLINE has it: the tangent of a quarter of the angle.
    void bulgeTo(const Vec2& at, double bulge);
    void cubicTo(const Vec2& b, const Vec2& c, const Vec2& d);
    /// Points of a smooth curve, one after the other; the last one is the end.
    void smoothTo(const std::vector<Vec2>& points);
    /// There is no corner where it is.
    void smoothHere()
    {
        if (!m_points.empty())
            m_points.back().bend = Bend::Smooth;
    }

    /// Everything so far as a line; the pen is empty then. Points that lie on each other are one.
    DrawnLine line(std::string layer, bool closed);

private:
    void add(const Vec2& at, Bend bend)
    {
        m_place = at;
        m_points.push_back({m_map * at, bend});
    }

    Map m_map;
    Vec2 m_place = Vec2::Zero();
    std::vector<DrawnPoint> m_points;
};

} // namespace bolster
