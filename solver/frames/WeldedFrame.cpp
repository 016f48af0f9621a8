#include "WeldedFrame.h"

#include "SortUnlessStopped.h"
#include "UnionFind.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace bolster {

namespace {

using Corners = WeldedFrame::Corners;

/// Numbers for the points of a mesh, the same for points in the same place.
std::vector<int> placesOf(const std::vector<Vec3>& points, const std::stop_token& stop)
{
    // The places lie beside their numbers: to look each up in the mesh would take most of the time.
    std::vector<std::pair<std::array<double, 3>, std::uint32_t>> order;
    order.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        order.push_back({{points[i].x(), points[i].y(), points[i].z()}, i});
    sortUnlessStopped(
        order, [](const auto& x, const auto& y) { return x.first < y.first; }, stop);
    std::vector<int> places(points.size());
    int count = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        count += k > 0 && order[k - 1].first != order[k].first ? 1 : 0;
        places[order[k].second] = count;
    }
    return places;
}

/// Faces that are there more than once, whichever way round.
class DoubleFaces {
public:
    DoubleFaces(std::vector<Corners>& triangles, const std::stop_token& stop)
        : m_stop(stop)
        , m_triangles(triangles)
    {
        std::vector<std::pair<Corners, int>> faces;
        faces.reserve(triangles.size());
        for (int t = 0; t < std::ssize(triangles); ++t) {
            faces.emplace_back(triangles[t], t);
            std::ranges::sort(faces.back().first);
        }
        sortUnlessStopped(faces, std::less<>(), stop);
        if (stop.stop_requested())
            return;
        for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
            while (end < faces.size() && faces[end].first == faces[i].first)
                ++end;
            if (end - i > 1)
                m_copies.push_back({faces[i].second, static_cast<int>(end - i)});
            for (std::size_t k = i + 1; k < end; ++k)
                m_again.push_back(faces[k].second);
        }
    }

    void remove()
    {
        if (m_copies.empty())
            return;
        drop(m_again);
        dropWalls();
        std::erase(m_triangles, Corners{-1, -1, -1});
    }

private:
    struct Copies {
        int triangle = 0; ///< the first one
        int count = 0;
    };

    void drop(const std::vector<int>& triangles)
    {
        for (const int t : triangles)
            m_triangles[t] = {-1, -1, -1};
    }

    /// Where faces that were double meet exactly one other face, they close a surface. Where they meet two, these
    /// close it without them. What hangs together decides by the majority of its rim.
    void dropWalls()
    {
        std::vector<int> number(m_triangles.size(), -1);
        for (int i = 0; i < std::ssize(m_copies); ++i)
            number[m_copies[i].triangle] = i;
        UnionFind joined(static_cast<int>(m_copies.size()));
        std::vector<std::pair<int, int>> votes; // of a double face; positive: it is needed
        eachEdge(halfEdges(m_triangles, m_stop), [&](const HalfEdge* first, const HalfEdge* last) {
            int any = -1, others = 0;
            for (const HalfEdge* half = first; half != last; ++half) {
                const int copies = half->low < 0 ? -1 : number[half->triangle];
                others += copies < 0 ? 1 : 0;
                if (copies >= 0 && any >= 0)
                    joined.join(any, copies);
                any = std::max(any, copies);
            }
            if (any >= 0 && others > 0)
                votes.emplace_back(any, others % 2 == 1 ? 1 : -1);
        });
        std::vector<int> needed(m_copies.size(), 0);
        for (const auto& [copies, vote] : votes)
            needed[joined.root(copies)] += vote;
        std::vector<int> walls;
        for (int i = 0; i < std::ssize(m_copies); ++i)
            if (needed[joined.root(i)] < 0 && m_copies[i].count % 2 == 0)
                walls.push_back(m_copies[i].triangle);
        drop(walls);
    }

    const std::stop_token& m_stop;
    std::vector<Corners>& m_triangles; // those that are dropped have corners of -1 for a while
    std::vector<Copies> m_copies;
    std::vector<int> m_again; // all but the first of each
};

} // namespace

FrameWelder::FrameWelder(const TriangleMesh& mesh, const Placement& placement, const std::stop_token& stop)
    : m_mesh(mesh)
    , m_placement(placement)
    , m_stop(stop)
    , m_places(placesOf(mesh.points, stop))
    , m_numbers(mesh.points.size(), -1)
{}

WeldedFrame FrameWelder::weld(const TriangleMesh::Part& part)
{
    WeldedFrame welded;
    std::vector<int> used; // places
    welded.triangles.reserve(part.triangleCount);
    const std::uint32_t end = part.firstTriangle + part.triangleCount;
    for (std::uint32_t t = part.firstTriangle; t < end && !m_stop.stop_requested(); ++t) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = m_mesh.triangles[t][k];
            int& number = m_numbers[m_places[point]];
            if (number < 0) {
                number = static_cast<int>(welded.points.size());
                used.push_back(m_places[point]);
                welded.points.push_back(m_placement.placed(m_mesh.points[point]));
            }
            corners[k] = number;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            welded.triangles.push_back(corners);
    }
    for (const int place : used)
        m_numbers[place] = -1;
    DoubleFaces(welded.triangles, m_stop).remove();
    return welded;
}

} // namespace bolster
