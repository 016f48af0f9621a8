#include "PatchTriangulator.h"

#include "SeedLattice.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;

/// Remembers the side of the outline on which a face lies.
template <class Base = CGAL::Constrained_triangulation_face_base_2<Kernel>>
class SidedFace : public Base {
public:
    template <class Tds>
    struct Rebind_TDS {
        using Other = SidedFace<typename Base::template Rebind_TDS<Tds>::Other>;
    };
    using Base::Base;
    int side = -1; // 0 outside, 1 inside
};

using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, SidedFace<>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure, CGAL::Exact_predicates_tag>;

constexpr int smoothingRounds = 3; // each reaches one ring farther inside

/// Marks every face as inside or outside by walking from the infinite face across the outline.
void markSides(Triangulation& triangulation, int boundaryCount)
{
    const auto onOutline = [&](const Triangulation::Face_handle& face, int i) {
        if (!face->is_constrained(i))
            return false;
        const auto [a, b] =
            std::minmax(face->vertex(Triangulation::cw(i))->info(), face->vertex(Triangulation::ccw(i))->info());
        return b < boundaryCount && (b - a == 1 || (a == 0 && b == boundaryCount - 1));
    };
    for (auto face : triangulation.all_face_handles())
        face->side = -1;
    std::vector<std::pair<Triangulation::Face_handle, int>> open{{triangulation.infinite_face(), 0}};
    while (!open.empty()) {
        const auto [face, side] = open.back();
        open.pop_back();
        if (face->side >= 0)
            continue;
        face->side = side;
        for (int i = 0; i < 3; ++i)
            open.emplace_back(face->neighbor(i), onOutline(face, i) ? 1 - side : side);
    }
}

Kernel::Point_2 toCgal(const Vec2& p)
{
    return {p.x(), p.y()};
}

using Edges = std::vector<std::pair<int, int>>;

/// What the triangles must keep: the outline and the inner lines.
Edges constraintsOf(const PatchMesh& mesh)
{
    Edges edges;
    for (int i = 0; i < mesh.boundaryCount; ++i)
        edges.emplace_back(i, (i + 1) % mesh.boundaryCount);
    for (const std::vector<int>& line : mesh.lines)
        for (std::size_t k = 0; k + 1 < line.size(); ++k)
            edges.emplace_back(line[k], line[k + 1]);
    return edges;
}

/// The order of triangles must not depend on how they were found.
void sortTriangles(std::vector<std::array<int, 3>>& triangles)
{
    for (auto& t : triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
}

/// What is far from the outline and the lines is the lattice as it is: only what lies around it is left to CGAL.
class Filling {
public:
    /// Of a mesh that has its outline and its lines.
    Filling(PatchMesh& mesh, const SeedLattice& lattice)
        : m_mesh(mesh)
        , m_lattice(lattice)
        , m_constraints(constraintsOf(mesh))
        , m_firstSeed(static_cast<int>(mesh.points.size()))
    {
        mesh.points.insert(mesh.points.end(), lattice.points().begin(), lattice.points().end());
    }

    /// False when constraints cross or touch.
    bool fill()
    {
        if (!triangulateBorder())
            return false;
        for (int round = 0; round < smoothingRounds; ++round)
            smooth();
        triangulateBorder();
        for (std::array<int, 3> triangle : m_lattice.insideTriangles()) {
            for (int& corner : triangle)
                corner += m_firstSeed;
            m_mesh.triangles.push_back(triangle);
        }
        sortTriangles(m_mesh.triangles);
        return true;
    }

private:
    bool isSeed(int vertex) const { return vertex >= m_firstSeed; }
    bool isInside(int vertex) const { return isSeed(vertex) && m_lattice.isInside(vertex - m_firstSeed); }
    bool isWithin(int vertex) const { return isSeed(vertex) && m_lattice.isWithin(vertex - m_firstSeed); }

    /// All triangles but those between seeds that are inside. False when constraints cross or touch: CGAL makes
    /// vertices of its own then, or splits edges.
    bool triangulateBorder()
    {
        std::vector<std::pair<Kernel::Point_2, int>> points;
        for (int i = 0; i < std::ssize(m_mesh.points); ++i)
            if (!isWithin(i))
                points.emplace_back(toCgal(m_mesh.points[i]), i);
        Triangulation triangulation;
        triangulation.insert(points.begin(), points.end());
        if (triangulation.number_of_vertices() != points.size())
            return false;
        std::vector<Triangulation::Vertex_handle> vertices(static_cast<std::size_t>(m_firstSeed));
        for (auto vertex : triangulation.finite_vertex_handles())
            if (!isSeed(vertex->info()))
                vertices[vertex->info()] = vertex;
        for (const auto& [a, b] : m_constraints)
            triangulation.insert_constraint(vertices[a], vertices[b]);
        if (triangulation.number_of_vertices() != points.size())
            return false;
        for (const auto& [a, b] : m_constraints) // an edge through another vertex has been split there
            if (!triangulation.is_edge(vertices[a], vertices[b]))
                return false;
        markSides(triangulation, m_mesh.boundaryCount);
        m_mesh.triangles.clear();
        for (auto face : triangulation.finite_face_handles()) {
            const std::array corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
            if (face->side == 1 && !std::ranges::all_of(corners, [&](int v) { return isInside(v); }))
                m_mesh.triangles.push_back(corners);
        }
        sortTriangles(m_mesh.triangles);
        return true;
    }

    /// Each seed moves to the area-weighted centre of its triangles, which evens out sizes near the outline; those
    /// inside are in the centre of theirs.
    void smooth()
    {
        std::vector<Vec2> sum(m_mesh.points.size(), Vec2::Zero());
        std::vector<double> weight(m_mesh.points.size(), 0);
        for (const auto& [a, b, c] : m_mesh.triangles) {
            const Vec2 u = m_mesh.points[b] - m_mesh.points[a], v = m_mesh.points[c] - m_mesh.points[a];
            const double area = std::abs(u.x() * v.y() - u.y() * v.x());
            const Vec2 centre = (m_mesh.points[a] + m_mesh.points[b] + m_mesh.points[c]) / 3;
            for (int i : {a, b, c}) {
                sum[i] += area * centre;
                weight[i] += area;
            }
        }
        for (int i = m_firstSeed; i < std::ssize(m_mesh.points); ++i)
            if (weight[i] > 0 && !isInside(i))
                m_mesh.points[i] = sum[i] / weight[i];
    }

    PatchMesh& m_mesh;
    const SeedLattice& m_lattice;
    Edges m_constraints;
    int m_firstSeed;
};

/// Appends a line's points that are not samples of the outline.
void addLine(PatchMesh& mesh, const InnerLine& line)
{
    std::vector<int>& vertices = mesh.lines.emplace_back();
    const int last = static_cast<int>(line.points.size()) - 1;
    for (int k = 0; k <= last; ++k) {
        const int sample = k == 0 ? line.startSample : k == last ? line.endSample : -1;
        vertices.push_back(sample >= 0 ? sample : static_cast<int>(mesh.points.size()));
        if (sample < 0)
            mesh.points.push_back(line.points[k]);
    }
    if (line.closed)
        vertices.push_back(vertices.front());
}

} // namespace

PatchMesh triangulatePatch(const std::vector<Vec2>& boundary, double edgeLength,
                           const std::vector<InnerLine>& lines)
{
    PatchMesh mesh;
    mesh.points = boundary;
    mesh.boundaryCount = static_cast<int>(boundary.size());
    for (const InnerLine& line : lines)
        addLine(mesh, line);
    const SeedLattice lattice(boundary, lines, edgeLength);
    if (!Filling(mesh, lattice).fill())
        mesh.triangles.clear();
    return mesh;
}

} // namespace bolster
