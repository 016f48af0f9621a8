#include "EdgeTruing.h"

#include "ArcLength.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace bolster::edits {

namespace {

constexpr double noWay = 1e-9;       // mm
constexpr double flattest = 0.5;     // of a curve that bulges: how much of its depth is left
constexpr double deepest = 2;        // the same: how much its depth grows
constexpr double shallow = 1e-6;     // of the chord: nothing that could bulge
constexpr double forBulging = 0.5;   // what a millimetre costs that only the edge itself gives way
constexpr double forDarts = 2;       // what it costs more to take a dart along
constexpr double forNeighbours = 20; // what it costs more to make a neighbour longer that is sewn or held

/// A way to do it, and how much it changes.
struct TruedOutline {
    std::vector<Vec2> points;
    double cost = 0;
};

class EdgeChange {
public:
    EdgeChange(const BSpline2& outline, const std::vector<int>& edge, double length, const EdgeSurroundings& around)
        : m_outline(outline)
        , m_edge(edge)
        , m_length(length)
        , m_around(around)
        , m_now(lengthOf(outline, edge.front(), edge.back()))
    {
        for (const double corner : outline.corners())
            m_corners.insert(outline.pointAt(corner));
    }

    std::optional<BSpline2> best() const
    {
        std::optional<TruedOutline> best;
        for (const auto& way :
             {bulged(), scaled(at(m_edge.front()), false, true), scaled(at(m_edge.back()), true, false)})
            if (way && (!best || way->cost < best->cost))
                best = way;
        return outlineOf(best);
    }

    std::optional<BSpline2> aboutMiddle() const
    {
        return outlineOf(scaled((at(m_edge.front()) + at(m_edge.back())) / 2, true, true));
    }

private:
    const Vec2& at(int i) const { return m_outline.points()[static_cast<std::size_t>(i)]; }
    int beside(int i, int step) const { return (i + step + m_outline.pointCount()) % m_outline.pointCount(); }
    bool isPinned(int i) const { return m_around.pinned.contains(i); }

    std::optional<BSpline2> outlineOf(const std::optional<TruedOutline>& way) const
    {
        if (!way || BSpline2::problem(m_outline.degree(), true, way->points, m_outline.knots()))
            return std::nullopt;
        return m_outline.withPoints(way->points);
    }

    static double lengthOf(const BSpline2& outline, int from, int to)
    {
        return ArcLength2(outline.part(outline.parameterOfPoint(from), outline.parameterOfPoint(to))).total();
    }

    /// Deeper or flatter between its ends.
    std::optional<TruedOutline> bulged() const
    {
        const Vec2 chord = at(m_edge.back()) - at(m_edge.front());
        double depth = 0;
        for (std::size_t k = 1; k + 1 < m_edge.size(); ++k) {
            if (m_corners.contains(m_edge[k]) || isPinned(m_edge[k]))
                return std::nullopt;
            depth = std::max(depth, std::abs(cross(chord, Vec2(at(m_edge[k]) - at(m_edge.front())))));
        }
        if (!(chord.norm() > noWay) || !(depth > shallow * chord.squaredNorm()))
            return std::nullopt;
        const auto difference = [&](double factor) {
            return lengthOf(m_outline.withPoints(deepened(factor)), m_edge.front(), m_edge.back()) - m_length;
        };
        double low = flattest, high = deepest;
        if (difference(low) > 0 || difference(high) < 0)
            return std::nullopt;
        for (int step = 0; step < 50; ++step) {
            const double middle = (low + high) / 2;
            (difference(middle) < 0 ? low : high) = middle;
        }
        return TruedOutline{deepened(low), forBulging * std::abs(low - 1) * depth / chord.norm()};
    }

    std::vector<Vec2> deepened(double factor) const
    {
        std::vector<Vec2> points = m_outline.points();
        const Vec2 start = at(m_edge.front()), along = (at(m_edge.back()) - start).normalized();
        for (std::size_t k = 1; k + 1 < m_edge.size(); ++k) {
            Vec2& point = points[static_cast<std::size_t>(m_edge[k])];
            const Vec2 off = point - start;
            point += (factor - 1) * (off - off.dot(along) * along);
        }
        return points;
    }

    /// In its own shape, about a place that stays.
    std::optional<TruedOutline> scaled(const Vec2& about, bool first, bool last) const
    {
        TruedOutline result{m_outline.points()};
        bool free = true;
        for (std::size_t k = first ? 0 : 1; k < m_edge.size() - (last ? 0 : 1); ++k)
            free = put(m_edge[k], about + m_length / m_now * (at(m_edge[k]) - about), result) && free;
        free = free && (!first || bringAlong(m_edge.front(), -1, result));
        free = free && (!last || bringAlong(m_edge.back(), 1, result));
        return free ? std::optional(result) : std::nullopt;
    }

    /// False when the point has to stay.
    bool put(int i, const Vec2& place, TruedOutline& result) const
    {
        result.points[static_cast<std::size_t>(i)] = place;
        return !isPinned(i);
    }

    /// What lies beyond an end that has moved. False when something of it has to stay.
    bool bringAlong(int end, int step, TruedOutline& result) const
    {
        const Vec2 way = result.points[static_cast<std::size_t>(end)] - at(end);
        const int beyond = afterDarts(end, step);
        for (int i = end; i != beyond;) {
            i = beside(i, step);
            if (i == m_edge.front() || i == m_edge.back() || !put(i, at(i) + way, result))
                return false;
        }
        result.cost += way.norm() * (beyond == end ? 1 : 1 + forDarts);
        return turnNext(beyond, step, way, result);
    }

    /// The corner at the other end of the mouth that begins there, or of the last one of several side by side.
    int afterDarts(int corner, int step) const
    {
        for (std::size_t k = 0; k < m_around.mouths.size(); ++k) {
            const auto begins = [&](const std::pair<int, int>& mouth) {
                return corner == (step > 0 ? mouth.first : mouth.second);
            };
            const auto mouth = std::ranges::find_if(m_around.mouths, begins);
            if (mouth == m_around.mouths.end())
                break;
            corner = step > 0 ? mouth->second : mouth->first;
        }
        return corner;
    }

    /// The next edge is turned and scaled about its far corner. False when something of it has to stay, or that
    /// corner moves, too.
    bool turnNext(int corner, int step, const Vec2& way, TruedOutline& result) const
    {
        std::vector<int> inner;
        int far = beside(corner, step);
        for (; !m_corners.contains(far); far = beside(far, step))
            inner.push_back(far);
        const auto complex = [](const Vec2& v) { return std::complex<double>(v.x(), v.y()); };
        const Vec2 before = at(corner) - at(far);
        if (!(before.norm() > noWay) || result.points[static_cast<std::size_t>(far)] != at(far))
            return false;
        const std::complex<double> turn = complex(before + way) / complex(before);
        for (const int i : inner) {
            const std::complex<double> off = turn * complex(at(i) - at(far));
            if (!put(i, at(far) + Vec2(off.real(), off.imag()), result))
                return false;
        }
        const int from = step > 0 ? corner : far, to = step > 0 ? far : corner;
        if (isUsed(from, to))
            result.cost += forNeighbours * std::abs(std::abs(turn) - 1) * lengthOf(m_outline, from, to);
        return true;
    }

    /// Whether something is sewn or held between these corners.
    bool isUsed(int from, int to) const
    {
        const double start = m_outline.parameterOfPoint(from), period = m_outline.period();
        const double span = m_outline.wrapped(m_outline.parameterOfPoint(to) - start + m_outline.domainStart()) -
                            m_outline.domainStart();
        return std::ranges::any_of(m_around.used, [&](const Stretch& stretch) {
            const double end =
                unwrappedEnd(stretch.from, stretch.to, m_outline.domainStart(), m_outline.domainEnd());
            for (const double t : {stretch.from, end, (stretch.from + end) / 2}) {
                const double ahead = t - start - period * std::floor((t - start) / period);
                if (ahead > sameShareOfEdge * span && ahead < (1 - sameShareOfEdge) * span)
                    return true;
            }
            const double ahead = start + span / 2 - stretch.from;
            return ahead - period * std::floor(ahead / period) < end - stretch.from;
        });
    }

    static constexpr double sameShareOfEdge = 1e-6;

    const BSpline2& m_outline;
    const std::vector<int>& m_edge;
    double m_length;
    const EdgeSurroundings& m_around;
    double m_now;
    std::set<int> m_corners;
};

} // namespace

std::optional<BSpline2> truedEdge(const BSpline2& outline, const std::vector<int>& points, double length,
                                  const EdgeSurroundings& around)
{
    return EdgeChange(outline, points, length, around).best();
}

std::optional<BSpline2> edgeAboutMiddle(const BSpline2& outline, const std::vector<int>& points, double length,
                                        const EdgeSurroundings& around)
{
    return EdgeChange(outline, points, length, around).aboutMiddle();
}

} // namespace bolster::edits
