#include "OutlineCrossings.h"

#include "BezierPieces.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double near = 0.05; // mm: as good as met

/// Calls visit(piece of almost no length) where a piece meets the line through a point.
template <class Visit>
void meetLine(const BezierPiece<2>& piece, const Vec2& through, const Vec2& direction, int depth,
              const Visit& visit)
{
    double low = 0, high = 0;
    for (int i = 0; i <= piece.degree; ++i) {
        const double side = cross(direction, piece.points[static_cast<std::size_t>(i)] - through);
        low = i == 0 ? side : std::min(low, side);
        high = i == 0 ? side : std::max(high, side);
    }
    if (low > 0 || high < 0 || high - low < 1e-12) // beside it, or along it
        return;
    if (depth == 0) {
        visit(piece);
        return;
    }
    for (const BezierPiece<2>& half : piece.halves())
        meetLine(half, through, direction, depth - 1, visit);
}

class Crossings {
public:
    Crossings(const BSpline2& outline, const std::vector<Vec2>& line)
        : m_outline(outline)
    {
        offerEnd(line.front(), 0);
        for (std::size_t k = 0; k + 1 < line.size(); ++k)
            addSegment(line[k], line[k + 1], static_cast<double>(k));
        offerEnd(line.back(), static_cast<double>(line.size() - 1));
        std::stable_sort(m_found.begin(), m_found.end(),
                         [](const OutlineCrossing& a, const OutlineCrossing& b) { return a.along < b.along; });
    }

    std::vector<OutlineCrossing> take() { return std::move(m_found); }

private:
    void offerEnd(const Vec2& end, double along)
    {
        const BSpline2::Closest closest = m_outline.closest(end);
        if (closest.distance <= near)
            offer({along, closest.parameter, closest.point});
    }

    void addSegment(const Vec2& from, const Vec2& to, double number)
    {
        const Vec2 way = to - from;
        if (!(way.norm() > 1e-9))
            return;
        for (const BezierPiece<2>& piece : bezierPieces(m_outline))
            meetLine(piece, from, way.normalized(), 40, [&](const BezierPiece<2>& met) {
                const double share = (met.front() - from).dot(way) / way.squaredNorm();
                if (share >= -1e-9 && share <= 1 + 1e-9)
                    offer({number + std::clamp(share, 0.0, 1.0), met.start, met.front()});
            });
    }

    void offer(OutlineCrossing crossing)
    {
        for (const OutlineCrossing& other : m_found)
            if ((other.point - crossing.point).norm() <= near)
                return;
        for (const double knot : m_outline.breaks())
            if ((m_outline.at(knot) - crossing.point).norm() <= near)
                crossing.parameter = knot;
        crossing.parameter = m_outline.wrapped(crossing.parameter);
        m_found.push_back(crossing);
    }

    const BSpline2& m_outline;
    std::vector<OutlineCrossing> m_found;
};

} // namespace

std::vector<OutlineCrossing> outlineCrossings(const BSpline2& outline, const std::vector<Vec2>& line)
{
    return line.size() < 2 ? std::vector<OutlineCrossing>() : Crossings(outline, line).take();
}

std::vector<Vec2> between(const std::vector<Vec2>& line, const OutlineCrossing& from, const OutlineCrossing& to)
{
    std::vector<Vec2> points = {from.point};
    for (std::size_t k = 0; k < line.size(); ++k)
        if (static_cast<double>(k) > from.along && static_cast<double>(k) < to.along &&
            (line[k] - points.back()).norm() > near && (line[k] - to.point).norm() > near)
            points.push_back(line[k]);
    points.push_back(to.point);
    return points;
}

bool isInside(const BSpline2& outline, const Vec2& point)
{
    constexpr int chords = 24; // of a curved span
    bool inside = false;
    Vec2 before = outline.at(outline.domainStart());
    for (const BezierPiece<2>& piece : bezierPieces(outline)) {
        const int count = piece.degree == 1 ? 1 : chords;
        for (int k = 1; k <= count; ++k) {
            const Vec2 next = k == count ? piece.back() : piece.at(static_cast<double>(k) / count);
            if ((before.y() > point.y()) != (next.y() > point.y()) &&
                point.x() <
                    before.x() + (point.y() - before.y()) / (next.y() - before.y()) * (next.x() - before.x()))
                inside = !inside;
            before = next;
        }
    }
    return inside;
}

} // namespace bolster::edits
