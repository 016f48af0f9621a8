// Edges where a mesh bends.
#include "FrameEdges.h"
#include "HalfEdges.h"

#include <cmath>
#include <numbers>

namespace bolster {
namespace {

const double bentBy = std::cos(30 * std::numbers::pi / 180);
const double edgeTurn = std::cos(40 * std::numbers::pi / 180);

/// A piece of an edge between two points of the mesh.
struct BentSide {
    std::uint32_t ends[2];
    int triangle = 0;
    bool walked = false;
};

class BentSides {
public:
    BentSides(const TriangleMesh& mesh, const std::stop_token& stop)
        : m_mesh(mesh)
    {
        const std::vector<HalfEdge> halves = halfEdges(mesh.triangles, stop);
        if (stop.stop_requested())
            return;
        eachEdge(halves, [this](const HalfEdge* first, const HalfEdge* last) {
            if (last - first != 2 || bends(first[0], first[1]))
                m_sides.push_back(
                    {{static_cast<std::uint32_t>(first->low), static_cast<std::uint32_t>(first->high)},
                     first->triangle});
        });
        m_at.resize(mesh.points.size());
        for (std::size_t i = 0; i < m_sides.size(); ++i)
            for (const std::uint32_t end : m_sides[i].ends)
                m_at[end].push_back(i);
        for (std::uint32_t i = 0, part = 0; i < mesh.triangles.size(); ++i) {
            while (part + 1 < mesh.parts.size() && i >= mesh.parts[part + 1].firstTriangle)
                ++part;
            m_partOf.push_back(part);
        }
    }

    std::vector<FrameEdge> rows()
    {
        std::vector<FrameEdge> rows;
        for (const bool open : {true, false}) // what is left then goes round
            for (std::size_t i = 0; i < m_sides.size(); ++i)
                for (const int end : {0, 1})
                    if (!m_sides[i].walked && (!open || isEnd(m_sides[i].ends[end])))
                        rows.push_back(walk(i, m_sides[i].ends[end]));
        return rows;
    }

private:
    Vec3 normal(int triangle) const
    {
        const auto& [a, b, c] = m_mesh.triangles[static_cast<std::size_t>(triangle)];
        return (m_mesh.points[b] - m_mesh.points[a]).cross(m_mesh.points[c] - m_mesh.points[a]).normalized();
    }

    bool bends(const HalfEdge& one, const HalfEdge& other) const
    {
        const double between = normal(one.triangle).dot(normal(other.triangle));
        return (one.forward == other.forward ? -between : between) < bentBy; // triangles may be turned around
    }

    std::uint32_t otherEnd(std::size_t side, std::uint32_t end) const
    {
        return m_sides[side].ends[m_sides[side].ends[0] == end ? 1 : 0];
    }

    bool isEnd(std::uint32_t point) const
    {
        if (m_at[point].size() != 2)
            return true;
        const Vec3& at = m_mesh.points[point];
        const Vec3 before = at - m_mesh.points[otherEnd(m_at[point][0], point)];
        const Vec3 after = m_mesh.points[otherEnd(m_at[point][1], point)] - at;
        return !(before.normalized().dot(after.normalized()) > edgeTurn);
    }

    FrameEdge walk(std::size_t side, std::uint32_t from)
    {
        FrameEdge edge;
        const std::uint32_t part = m_partOf[static_cast<std::size_t>(m_sides[side].triangle)];
        if (part < m_mesh.parts.size())
            edge.part = m_mesh.parts[part].name;
        edge.points.push_back(m_mesh.points[from]);
        for (;;) {
            m_sides[side].walked = true;
            from = otherEnd(side, from);
            edge.points.push_back(m_mesh.points[from]);
            if (isEnd(from))
                return edge;
            side = m_at[from][0] == side ? m_at[from][1] : m_at[from][0];
            if (m_sides[side].walked)
                return edge;
        }
    }

    const TriangleMesh& m_mesh;
    std::vector<BentSide> m_sides;
    std::vector<std::vector<std::size_t>> m_at; // of each point its sides
    std::vector<std::uint32_t> m_partOf;        // of each triangle
};

} // namespace

std::vector<FrameEdge> bentEdges(const TriangleMesh& mesh, const std::stop_token& stop)
{
    if (mesh.triangles.size() > mostBentTriangles)
        return {};
    return BentSides(mesh, stop).rows();
}

} // namespace bolster
