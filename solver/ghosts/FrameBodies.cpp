#include "FrameBodies.h"

#include "UnionFind.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace bolster {

namespace {

using Corners = std::array<int, 3>;

/// Triangles whose corners are numbered by place, without those that have no area for that.
struct Welded {
    std::vector<Vec3> points;
    std::vector<Corners> triangles;

    Vec3 doubleArea(int t) const
    {
        const auto& [a, b, c] = triangles[t];
        return (points[b] - points[a]).cross(points[c] - points[a]);
    }
    Vec3 middle(int t) const
    {
        const auto& [a, b, c] = triangles[t];
        return (points[a] + points[b] + points[c]) / 3;
    }
};

Welded weld(const TriangleMesh& mesh, const TriangleMesh::Part& part, const Placement& placement)
{
    Welded welded;
    std::map<std::array<double, 3>, int> numbers;
    for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
        Corners corners;
        for (int k = 0; k < 3; ++k) {
            const Vec3& p = mesh.points[mesh.triangles[t][k]];
            const auto [found, isNew] = numbers.try_emplace({p.x(), p.y(), p.z()}, std::ssize(welded.points));
            if (isNew)
                welded.points.push_back(placement.placed(p));
            corners[k] = found->second;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            welded.triangles.push_back(corners);
    }
    return welded;
}

struct HalfEdge {
    int low = 0;
    int high = 0;
    int triangle = 0;
    bool forward = false; ///< from low to high
};

/// Sorted, so that those of one edge follow each other.
std::vector<HalfEdge> halfEdges(const Welded& welded)
{
    std::vector<HalfEdge> halves;
    for (int t = 0; t < std::ssize(welded.triangles); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = welded.triangles[t][k], b = welded.triangles[t][(k + 1) % 3];
            halves.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return halves;
}

/// Triangles that hang together across edges of exactly two.
class Shells {
public:
    explicit Shells(Welded& welded)
        : m_welded(welded)
        , m_neighbours(welded.triangles.size())
    {
        UnionFind joined(static_cast<int>(welded.triangles.size()));
        const std::vector<HalfEdge> halves = halfEdges(welded);
        std::vector<int> open;
        for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
            while (end < halves.size() && halves[end].low == halves[i].low && halves[end].high == halves[i].high)
                ++end;
            if ((end - i) % 2 == 1)
                for (std::size_t k = i; k < end; ++k)
                    open.push_back(halves[k].triangle);
            if (end - i != 2)
                continue;
            const HalfEdge &a = halves[i], &b = halves[i + 1];
            joined.join(a.triangle, b.triangle);
            m_neighbours[a.triangle].push_back({b.triangle, a.forward == b.forward});
            m_neighbours[b.triangle].push_back({a.triangle, a.forward == b.forward});
        }
        int count = 0;
        const std::vector<int> label = joined.labels(&count);
        triangles.resize(count);
        closed.assign(count, 1);
        for (int t = 0; t < std::ssize(label); ++t)
            triangles[label[t]].push_back(t);
        for (int t : open)
            closed[label[t]] = 0;
        for (const std::vector<int>& shell : triangles)
            orient(shell.front());
    }

    /// Turns a shell so that most of it faces away from `middle`.
    void turnAwayFrom(const Vec3& middle, const std::vector<int>& shell)
    {
        double outwards = 0;
        for (int t : shell)
            outwards += m_welded.doubleArea(t).dot(m_welded.middle(t) - middle);
        if (outwards < 0)
            for (int t : shell)
                std::swap(m_welded.triangles[t][1], m_welded.triangles[t][2]);
    }

    std::vector<std::vector<int>> triangles;
    std::vector<char> closed;

private:
    struct Neighbour {
        int triangle = 0;
        bool opposed = false; ///< its orientation differs
    };

    /// Gives all of a shell the orientation of its first triangle.
    void orient(int first)
    {
        m_seen.resize(m_neighbours.size(), 0);
        std::vector<std::pair<int, bool>> waiting = {{first, false}};
        m_seen[first] = 1;
        while (!waiting.empty()) {
            const auto [t, turned] = waiting.back();
            waiting.pop_back();
            if (turned)
                std::swap(m_welded.triangles[t][1], m_welded.triangles[t][2]);
            for (const Neighbour& next : m_neighbours[t])
                if (!std::exchange(m_seen[next.triangle], 1))
                    waiting.push_back({next.triangle, turned != next.opposed});
        }
    }

    Welded& m_welded;
    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<char> m_seen;
};

Vec3 middleOf(const Welded& welded, const std::vector<int>& triangles)
{
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (int t : triangles) {
        const double a = welded.doubleArea(t).norm();
        sum += a * welded.middle(t);
        area += a;
    }
    return area > 0 ? Vec3(sum / area) : welded.middle(triangles.front());
}

FrameBody body(const Welded& welded, const std::vector<int>& triangles, bool closed)
{
    std::vector<TriangleTree::Triangle> list;
    for (int t : triangles) {
        const auto& [a, b, c] = welded.triangles[t];
        list.push_back({welded.points[a], welded.points[b], welded.points[c]});
    }
    return {TriangleTree(std::move(list)), closed};
}

} // namespace

std::vector<FrameBody> frameBodies(const TriangleMesh& mesh, const TriangleMesh::Part& part,
                                   const Placement& placement)
{
    Welded welded = weld(mesh, part, placement);
    Shells shells(welded);
    std::vector<FrameBody> bodies;
    std::vector<int> open;
    for (std::size_t s = 0; s < shells.triangles.size(); ++s) {
        if (shells.closed[s]) {
            // Turned away from its middle by its volume, which does not depend on the point it is measured from.
            shells.turnAwayFrom(middleOf(welded, shells.triangles[s]), shells.triangles[s]);
            bodies.push_back(body(welded, shells.triangles[s], true));
        } else {
            open.insert(open.end(), shells.triangles[s].begin(), shells.triangles[s].end());
        }
    }
    if (open.empty())
        return bodies;
    const Vec3 middle = middleOf(welded, open);
    for (std::size_t s = 0; s < shells.triangles.size(); ++s)
        if (!shells.closed[s])
            shells.turnAwayFrom(middle, shells.triangles[s]);
    bodies.push_back(body(welded, open, false));
    return bodies;
}

FrameParts frameParts(const TriangleMesh& mesh, const Placement& placement)
{
    FrameParts parts;
    for (const TriangleMesh::Part& part : mesh.parts)
        parts.push_back(frameBodies(mesh, part, placement));
    return parts;
}

} // namespace bolster
