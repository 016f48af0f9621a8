// Edges that go on in each other, as one.
#include "ArcLength.h"
#include "FrameEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bolster {
namespace {

constexpr double joinedWithin = 0.01;  // mm
constexpr double doubledWithin = 0.02; // mm
const double joinedTurn = std::cos(10 * std::numbers::pi / 180);
constexpr std::size_t noEnd = std::numeric_limits<std::size_t>::max();

/// Askew, as many places have the same x, y or z.
double sortKey(const Vec3& point)
{
    return Vec3(0.61, 0.53, 0.59).dot(point);
}

/// End 2i is where edge i begins, end 2i + 1 where it ends.
class EdgeEnds {
public:
    explicit EdgeEnds(const std::vector<FrameEdge>& edges)
        : m_edges(edges)
        , m_next(2 * edges.size(), noEnd)
    {
        for (std::size_t end = 0; end < m_next.size(); ++end)
            m_sorted.emplace_back(sortKey(place(end)), end);
        std::ranges::sort(m_sorted);
        std::vector<std::size_t> candidates(m_next.size(), noEnd);
        for (std::size_t end = 0; end < m_next.size(); ++end)
            candidates[end] = onlyOneAfter(end);
        for (std::size_t end = 0; end < m_next.size(); ++end)
            if (candidates[end] != noEnd && candidates[candidates[end]] == end)
                m_next[end] = candidates[end];
    }

    std::vector<FrameEdge> rows()
    {
        std::vector<FrameEdge> rows;
        m_walked.resize(m_edges.size());
        for (const bool open : {true, false})
            for (std::size_t end = 0; end < m_next.size(); ++end)
                if (!m_walked[end / 2] && (!open || m_next[end] == noEnd))
                    rows.push_back(walk(end));
        return rows;
    }

private:
    const Vec3& place(std::size_t end) const
    {
        const std::vector<Vec3>& points = m_edges[end / 2].points;
        return end % 2 == 0 ? points.front() : points.back();
    }

    /// Out of the edge.
    Vec3 direction(std::size_t end) const
    {
        const std::vector<Vec3>& points = m_edges[end / 2].points;
        return (end % 2 == 0 ? points[0] - points[1] : points.back() - points[points.size() - 2]).normalized();
    }

    std::size_t onlyOneAfter(std::size_t end) const
    {
        if (m_edges[end / 2].closed())
            return noEnd;
        const double at = sortKey(place(end));
        std::size_t found = noEnd;
        for (auto near = std::ranges::lower_bound(m_sorted, std::pair(at - joinedWithin, std::size_t{0}));
             near != m_sorted.end() && near->first <= at + joinedWithin; ++near) {
            const std::size_t other = near->second;
            if (other / 2 == end / 2 || m_edges[other / 2].part != m_edges[end / 2].part ||
                (place(other) - place(end)).norm() > joinedWithin ||
                !(direction(end).dot(-direction(other)) > joinedTurn))
                continue;
            if (found != noEnd)
                return noEnd;
            found = other;
        }
        return found;
    }

    /// From an end through its edge, and on.
    FrameEdge walk(std::size_t end)
    {
        FrameEdge row{{place(end)}, m_edges[end / 2].part, m_edges[end / 2].exact};
        const std::size_t first = end;
        for (;;) {
            const std::vector<Vec3>& points = m_edges[end / 2].points;
            m_walked[end / 2] = true;
            if (end % 2 == 0)
                row.points.insert(row.points.end(), points.begin() + 1, points.end());
            else
                row.points.insert(row.points.end(), points.rbegin() + 1, points.rend());
            end = m_next[end ^ 1];
            if (end == noEnd)
                return row;
            if (m_walked[end / 2]) {
                if (end == first)
                    row.points.back() = row.points.front();
                return row;
            }
        }
    }

    const std::vector<FrameEdge>& m_edges;
    std::vector<std::pair<double, std::size_t>> m_sorted;
    std::vector<std::size_t> m_next; // of each end the one in which it goes on
    std::vector<bool> m_walked;
};

} // namespace

std::vector<FrameEdge> distinctEdges(const std::vector<FrameEdge>& edges)
{
    std::vector<std::pair<double, std::size_t>> sorted;
    std::vector<Vec3> middles;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        middles.push_back(placeAlong(edges[i].points, 0.5));
        sorted.emplace_back(sortKey(middles[i]), i);
    }
    std::ranges::sort(sorted);
    const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() <= doubledWithin; };
    const auto same = [&](std::size_t a, std::size_t b) {
        const Vec3 &from = edges[a].points.front(), &to = edges[a].points.back();
        const Vec3 &first = edges[b].points.front(), &last = edges[b].points.back();
        return near(middles[a], middles[b]) &&
               ((near(from, first) && near(to, last)) || (near(from, last) && near(to, first)));
    };
    std::vector<FrameEdge> distinct;
    std::vector<bool> doubled(edges.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (doubled[sorted[i].second])
            continue;
        for (std::size_t k = i + 1; k < sorted.size() && sorted[k].first <= sorted[i].first + doubledWithin; ++k)
            if (same(sorted[i].second, sorted[k].second))
                doubled[sorted[k].second] = true;
    }
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!doubled[i])
            distinct.push_back(edges[i]);
    return distinct;
}

std::vector<FrameEdge> joinedSmoothly(const std::vector<FrameEdge>& edges)
{
    return EdgeEnds(edges).rows();
}

} // namespace bolster
