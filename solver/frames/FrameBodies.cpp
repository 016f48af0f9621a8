#include "FrameBodies.h"

#include "UnionFind.h"
#include "WeldedFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

/// Triangles that hang together across edges of exactly two.
class Shells {
public:
    Shells(WeldedFrame& welded, const std::stop_token& stop)
        : m_welded(welded)
        , m_stop(stop)
        , m_neighbours(welded.triangles.size())
    {
        UnionFind joined(static_cast<int>(welded.triangles.size()));
        std::vector<int> open;
        const std::vector<HalfEdge> halves = halfEdges(welded.triangles, stop);
        if (stop.stop_requested())
            return;
        eachEdge(halves, [&](const HalfEdge* first, const HalfEdge* last) {
            if ((last - first) % 2 == 1)
                for (const HalfEdge* half = first; half != last; ++half)
                    open.push_back(half->triangle);
            if (last - first != 2)
                return;
            const HalfEdge &a = first[0], &b = first[1];
            joined.join(a.triangle, b.triangle);
            m_neighbours[a.triangle].add({b.triangle, a.forward == b.forward});
            m_neighbours[b.triangle].add({a.triangle, a.forward == b.forward});
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
    /// Across each edge of a triangle one at most.
    struct Neighbours {
        std::array<Neighbour, 3> list;
        int count = 0;

        void add(Neighbour neighbour) { list[count++] = neighbour; }
        auto begin() const { return list.begin(); }
        auto end() const { return list.begin() + count; }
    };

    /// Gives all of a shell the orientation of its first triangle.
    void orient(int first)
    {
        m_seen.resize(m_neighbours.size(), 0);
        std::vector<std::pair<int, bool>> waiting = {{first, false}};
        m_seen[first] = 1;
        while (!waiting.empty() && !m_stop.stop_requested()) {
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
    const std::stop_token& m_stop;
    std::vector<Neighbours> m_neighbours;
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

FrameBody body(const WeldedFrame& welded, const std::vector<int>& triangles, bool closed,
               const std::stop_token& stop)
{
    std::vector<TriangleTree::Triangle> list;
    list.reserve(triangles.size());
    for (int t : triangles) {
        const auto& [a, b, c] = welded.triangles[t];
        list.push_back({welded.points[a], welded.points[b], welded.points[c]});
    }
    return {TriangleTree(list, stop), closed, closed ? std::optional(thickness(welded, triangles)) : std::nullopt};
}

/// Of one part.
std::vector<FrameBody> bodiesOf(WeldedFrame welded, const std::stop_token& stop)
{
    Shells shells(welded, stop);
    std::vector<FrameBody> bodies;
    std::vector<int> open;
    for (std::size_t s = 0; s < shells.triangles.size() && !stop.stop_requested(); ++s) {
        if (shells.closed[s]) {
            // Turned away from its middle by its volume, which does not depend on the point it is measured from.
            shells.turnAwayFrom(middleOf(welded, shells.triangles[s]), shells.triangles[s]);
            bodies.push_back(body(welded, shells.triangles[s], true, stop));
        } else {
            open.insert(open.end(), shells.triangles[s].begin(), shells.triangles[s].end());
        }
    }
    if (open.empty() || stop.stop_requested())
        return bodies;
    const Vec3 middle = middleOf(welded, open);
    for (std::size_t s = 0; s < shells.triangles.size(); ++s)
        if (!shells.closed[s])
            shells.turnAwayFrom(middle, shells.triangles[s]);
    bodies.push_back(body(welded, open, false, stop));
    return bodies;
}

} // namespace

FrameParts frameParts(const TriangleMesh& mesh, const Placement& placement, const std::stop_token& stop)
{
    FrameParts parts(mesh.parts.size());
    if (stop.stop_requested())
        return parts;
    FrameWelder welder(mesh, placement, stop);
    for (std::size_t p = 0; p < parts.size() && !stop.stop_requested(); ++p)
        parts[p] = bodiesOf(welder.weld(mesh.parts[p]), stop);
    return parts;
}

} // namespace bolster
