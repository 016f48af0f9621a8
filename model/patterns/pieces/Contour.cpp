#include "Contour.h"

#include "PointGrid.h"
#include "SegmentDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace bolster {

namespace {

class Joiner {
public:
    Joiner(std::vector<DrawnLine> lines, const JoinOrder& order)
        : m_lines(std::move(lines))
        , m_order(order)
    {}

    std::vector<Contour> join(int& doubled)
    {
        dropDoubles(doubled);
        closeAlmostClosed();
        pairEnds(m_order.same);
        if (m_order.largestGap > m_order.same)
            pairEnds(m_order.largestGap);
        std::vector<Contour> result;
        for (std::size_t i = 0; i < m_lines.size(); ++i)
            if (!m_done[i])
                result.push_back(chainFrom(i));
        for (Contour& contour : result)
            if (contour.closed && contour.signedArea() < 0)
                std::ranges::reverse(contour.points);
        return result;
    }

private:
    static constexpr std::size_t none = SIZE_MAX;
    static constexpr std::size_t mostAtOnePoint = 100; // ends, of a square of the grid

    // End 2 i is where line i begins, 2 i + 1 where it ends.
    const DrawnPoint& pointAt(std::size_t end) const
    {
        const DrawnLine& line = m_lines[end / 2];
        return end % 2 == 0 ? line.points.front() : line.points.back();
    }

    /// What lines on each other have in common: middle, length, spread, number of points.
    using LineKey = std::array<std::int64_t, 7>;
    static LineKey keyOf(const DrawnLine& line)
    {
        const auto count = static_cast<double>(line.points.size());
        Vec2 middle = Vec2::Zero();
        for (const DrawnPoint& point : line.points)
            middle += point.at / count;
        double length = 0, across = 0, along = 0;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const Vec2 off = line.points[i].at - middle;
            across += off.x() * off.y() / count;
            along += (off.x() * off.x() - off.y() * off.y()) / count;
            if (i > 0)
                length += (line.points[i].at - line.points[i - 1].at).norm();
        }
        const auto rounded = [](double value) {
            return static_cast<std::int64_t>(std::llround(std::clamp(value, -1e12, 1e12) / 0.05));
        };
        const double scale = std::max(length, 1e-9); // an error of the points' is as large in these
        return {rounded(middle.x()),
                rounded(middle.y()),
                rounded(length),
                rounded(across / scale),
                rounded(along / scale),
                static_cast<std::int64_t>(line.points.size()),
                line.closed};
    }

    /// The same points, forwards or backwards, within what is one place.
    void dropDoubles(int& doubled)
    {
        constexpr std::size_t mostAlike = 64;
        std::map<LineKey, std::vector<std::size_t>> seen;
        std::vector<DrawnLine> kept;
        for (DrawnLine& line : m_lines) {
            auto& there = seen[keyOf(line)];
            if (std::ranges::any_of(there, [&](std::size_t other) { return isSame(kept[other], line); })) {
                ++doubled;
                continue;
            }
            if (there.size() < mostAlike)
                there.push_back(kept.size());
            kept.push_back(std::move(line));
        }
        m_lines = std::move(kept);
        m_done.assign(m_lines.size(), false);
        m_partner.assign(2 * m_lines.size(), none);
    }

    bool isSame(const DrawnLine& a, const DrawnLine& b) const
    {
        bool forwards = true, backwards = true;
        for (std::size_t i = 0; i < a.points.size(); ++i) {
            forwards = forwards && (a.points[i].at - b.points[i].at).norm() <= m_order.same;
            backwards = backwards && (a.points[i].at - b.points[b.points.size() - 1 - i].at).norm() <= m_order.same;
        }
        return forwards || backwards;
    }

    void closeAlmostClosed()
    {
        for (DrawnLine& line : m_lines)
            if (!line.closed && line.points.size() > 3 &&
                (line.points.front().at - line.points.back().at).norm() <= m_order.same) {
                if (line.points.back().bend == Bend::Smooth)
                    line.points.front().bend = Bend::Smooth;
                line.points.pop_back();
                line.closed = true;
            }
    }

    /// Nearest ends first; where more than two meet, those of one layer, then whatever is left over.
    void pairEnds(double reach)
    {
        PointGrid grid(reach);
        std::vector<std::size_t> free;
        for (std::size_t end = 0; end < m_partner.size(); ++end)
            if (m_partner[end] == none && !m_lines[end / 2].closed) {
                grid.add(pointAt(end).at, end);
                free.push_back(end);
            }
        struct Pair {
            bool otherLayer;
            double distance;
            std::size_t a, b;
        };
        std::vector<Pair> pairs;
        for (const std::size_t end : free) {
            grid.nearLater(pointAt(end).at, end, mostAtOnePoint, [&](std::size_t other) {
                const double distance = (pointAt(other).at - pointAt(end).at).norm();
                if (distance <= reach)
                    pairs.push_back({m_lines[end / 2].layer != m_lines[other / 2].layer, distance, end, other});
            });
        }
        std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) {
            return std::pair(a.otherLayer, a.distance) < std::pair(b.otherLayer, b.distance);
        });
        for (const Pair& pair : pairs)
            if (m_partner[pair.a] == none && m_partner[pair.b] == none &&
                (pair.a / 2 != pair.b / 2 || m_lines[pair.a / 2].points.size() > 2)) {
                m_partner[pair.a] = pair.b;
                m_partner[pair.b] = pair.a;
            }
    }

    Contour chainFrom(std::size_t first)
    {
        Contour chain;
        chain.layer = m_lines[first].layer;
        chain.circle = m_lines[first].circle;
        chain.closed = m_lines[first].closed;
        // To the chain's beginning, or once around.
        std::size_t start = 2 * first;
        while (!chain.closed && m_partner[start] != none) {
            start = m_partner[start] ^ 1;
            if (start / 2 == first)
                break;
        }
        for (std::size_t end = start;;) {
            append(chain, end);
            const std::size_t next = m_lines[end / 2].closed ? none : m_partner[end ^ 1];
            if (next == none)
                break;
            chain.gap = std::max(chain.gap, (pointAt(next).at - pointAt(end ^ 1).at).norm());
            if (m_done[next / 2]) {
                chain.closed = true;
                break;
            }
            end = next;
        }
        if (chain.closed)
            tidyClosed(chain);
        else
            chain.gap = (chain.points.front().at - chain.points.back().at).norm();
        return chain;
    }

    /// The whole line that has this end first.
    void append(Contour& chain, std::size_t end)
    {
        const DrawnLine& line = m_lines[end / 2];
        m_done[end / 2] = true;
        if (chain.called.empty())
            chain.called = line.called;
        chain.about.insert(chain.about.end(), line.about.begin(), line.about.end());
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const DrawnPoint& point = line.points[end % 2 == 0 ? i : line.points.size() - 1 - i];
            if (chain.points.empty() || (chain.points.back().at - point.at).norm() > m_order.same)
                chain.points.push_back(point);
            else if (point.bend == Bend::Corner)
                chain.points.back().bend = Bend::Corner;
        }
    }

    void tidyClosed(Contour& chain) const
    {
        while (chain.points.size() > 3 && (chain.points.front().at - chain.points.back().at).norm() <= m_order.same)
            chain.points.pop_back();
        if (chain.points.size() < 3) {
            chain.closed = false;
            chain.gap = 0;
        }
    }

    std::vector<DrawnLine> m_lines;
    JoinOrder m_order;
    std::vector<bool> m_done;
    std::vector<std::size_t> m_partner;
};

} // namespace

Box2 Contour::box() const
{
    Box2 box;
    for (const DrawnPoint& point : points)
        box.extend(point.at);
    return box;
}

double Contour::signedArea() const
{
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += cross(points[i].at, points[(i + 1) % points.size()].at);
    return sum / 2;
}

bool Contour::contains(const Vec2& point) const
{
    bool inside = false;
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
        const Vec2 &a = points[i].at, &b = points[j].at;
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

double Contour::distance(const Vec2& point) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i)
        nearest = std::min(nearest, segmentDistance(point, points[i].at, points[(i + 1) % points.size()].at));
    return nearest;
}

std::vector<Vec2> Contour::places() const
{
    std::vector<Vec2> result;
    for (const DrawnPoint& point : points)
        result.push_back(point.at);
    return result;
}

std::vector<Contour> joinedLines(std::vector<DrawnLine> lines, const JoinOrder& order, int& doubled)
{
    return Joiner(std::move(lines), order).join(doubled);
}

} // namespace bolster
