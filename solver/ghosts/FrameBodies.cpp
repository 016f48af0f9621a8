#include "FrameBodies.h"

#include "UnionFind.h"
#include "WeldedFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

/// Triangles that hang together across edges of exactly two.
class Shells {
public:
    explicit Shells(WeldedFrame& welded)
        : m_welded(welded)
        , m_neighbours(welded.triangles.size())
    {
        UnionFind joined(static_cast<int>(welded.triangles.size()));
        std::vector<int> open;
        eachEdge(halfEdges(welded.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
            if ((last - first) % 2 == 1)
                for (const HalfEdge* half = first; half != last; ++half)
                    open.push_back(half->triangle);
            if (last - first != 2)
                return;
            const HalfEdge &a = first[0], &b = first[1];
            joined.join(a.triangle, b.triangle);
            m_neighbours[a.triangle].push_back({b.triangle, a.forward == b.forward});
            m_neighbours[b.triangle].push_back({a.triangle, a.forward == b.forward});
        });
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

    WeldedFrame& m_welded;
    std::vector<std::vector<Neighbour>> m_neighbours;
    std::vector<char> m_seen;
};

Vec3 middleOf(const WeldedFrame& welded, const std::vector<int>& triangles)
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

double thickness(const WeldedFrame& welded, const std::vector<int>& triangles)
{
    double sixVolumes = 0, doubleArea = 0;
    const Vec3 middle = middleOf(welded, triangles);
    for (const int t : triangles) {
        sixVolumes += welded.doubleArea(t).dot(welded.middle(t) - middle);
        doubleArea += welded.doubleArea(t).norm();
    }
    return doubleArea > 0 ? 2.0 / 3 * std::abs(sixVolumes) / doubleArea : 0;
}

FrameBody body(const WeldedFrame& welded, const std::vector<int>& triangles, bool closed)
{
    std::vector<TriangleTree::Triangle> list;
    for (int t : triangles) {
        const auto& [a, b, c] = welded.triangles[t];
        list.push_back({welded.points[a], welded.points[b], welded.points[c]});
    }
    return {TriangleTree(std::move(list)), closed,
            closed ? std::optional(thickness(welded, triangles)) : std::nullopt};
}

} // namespace

std::vector<FrameBody> frameBodies(const TriangleMesh& mesh, const TriangleMesh::Part& part,
                                   const Placement& placement)
{
    WeldedFrame welded = weldFrame(mesh, part, placement);
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
