#include "PatchTriangulator.h"

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

constexpr double boundaryGap = 0.55; // seeds keep this many edge lengths away from the outline
constexpr int smoothingRounds = 3;

/// Distance queries to the outline's edges through a grid of cells of one edge length.
class BoundaryGrid {
public:
    BoundaryGrid(const std::vector<Vec2>& boundary, double cell)
        : m_boundary(boundary)
        , m_cell(cell)
    {
        for (const Vec2& p : boundary)
            m_box.extend(p);
        m_columns = static_cast<int>(m_box.sizes().x() / cell) + 1;
        m_rows = static_cast<int>(m_box.sizes().y() / cell) + 1;
        m_cells.resize(static_cast<std::size_t>(m_columns) * m_rows);
        for (int i = 0; i < std::ssize(boundary); ++i)
            addSegment(i);
    }

    bool nearerThan(const Vec2& p, double distance) const
    {
        const auto [c0, r0] = cellOf(p - Vec2::Constant(distance));
        const auto [c1, r1] = cellOf(p + Vec2::Constant(distance));
        for (int r = r0; r <= r1; ++r)
            for (int c = c0; c <= c1; ++c)
                for (int i : m_cells[static_cast<std::size_t>(r) * m_columns + c])
                    if (squaredDistance(p, i) < distance * distance)
                        return true;
        return false;
    }

private:
    std::pair<int, int> cellOf(const Vec2& p) const
    {
        const Vec2 q = (p - m_box.min()) / m_cell;
        return {std::clamp(static_cast<int>(q.x()), 0, m_columns - 1),
                std::clamp(static_cast<int>(q.y()), 0, m_rows - 1)};
    }

    const Vec2& end(int i) const { return m_boundary[(i + 1) % m_boundary.size()]; }

    void addSegment(int i)
    {
        const auto [c0, r0] = cellOf(m_boundary[i].cwiseMin(end(i)));
        const auto [c1, r1] = cellOf(m_boundary[i].cwiseMax(end(i)));
        for (int r = r0; r <= r1; ++r)
            for (int c = c0; c <= c1; ++c)
                m_cells[static_cast<std::size_t>(r) * m_columns + c].push_back(i);
    }

    double squaredDistance(const Vec2& p, int i) const
    {
        const Vec2 edge = end(i) - m_boundary[i];
        const double t = std::clamp((p - m_boundary[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        return (m_boundary[i] + t * edge - p).squaredNorm();
    }

    const std::vector<Vec2>& m_boundary;
    double m_cell;
    Box2 m_box;
    int m_columns = 0, m_rows = 0;
    std::vector<std::vector<int>> m_cells;
};

/// Where a horizontal line enters and leaves the outline, increasing.
std::vector<double> crossings(const std::vector<Vec2>& boundary, double y)
{
    std::vector<double> xs;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const Vec2& p = boundary[i];
        const Vec2& q = boundary[(i + 1) % boundary.size()];
        if ((p.y() <= y) != (q.y() <= y))
            xs.push_back(p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
    }
    std::sort(xs.begin(), xs.end());
    return xs;
}

std::vector<Vec2> seeds(const std::vector<Vec2>& boundary, double edge)
{
    const BoundaryGrid grid(boundary, edge);
    Box2 box;
    for (const Vec2& p : boundary)
        box.extend(p);
    const double height = edge * std::sqrt(3.0) / 2;
    // The rows are centred, so that a symmetric patch gets a symmetric mesh as far as rows can be.
    const int rows = static_cast<int>(box.sizes().y() / height);
    const double firstY = box.center().y() - 0.5 * rows * height;
    std::vector<Vec2> points;
    for (int row = 0; row <= rows; ++row) {
        const double y = firstY + row * height;
        const double shift = box.center().x() + (row % 2 ? 0.5 * edge : 0);
        const std::vector<double> xs = crossings(boundary, y);
        for (std::size_t k = 0; k + 1 < xs.size(); k += 2)
            for (double i = std::ceil((xs[k] - shift) / edge); shift + i * edge < xs[k + 1]; ++i) {
                const Vec2 p(shift + i * edge, y);
                if (!grid.nearerThan(p, boundaryGap * edge))
                    points.push_back(p);
            }
    }
    return points;
}

/// Marks every face as inside or outside by walking from the infinite face across the outline.
void markSides(Triangulation& triangulation)
{
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
            open.emplace_back(face->neighbor(i), face->is_constrained(i) ? 1 - side : side);
    }
}

Kernel::Point_2 toCgal(const Vec2& p)
{
    return {p.x(), p.y()};
}

/// False when edges of the boundary cross or touch: CGAL makes vertices of its own then, or splits edges.
bool triangulate(PatchMesh& mesh)
{
    std::vector<std::pair<Kernel::Point_2, int>> points;
    points.reserve(mesh.points.size());
    for (int i = 0; i < std::ssize(mesh.points); ++i)
        points.emplace_back(toCgal(mesh.points[i]), i);
    Triangulation triangulation;
    triangulation.insert(points.begin(), points.end());
    std::vector<Triangulation::Vertex_handle> vertices(mesh.points.size());
    if (triangulation.number_of_vertices() != mesh.points.size())
        return false;
    for (auto vertex : triangulation.finite_vertex_handles())
        vertices[vertex->info()] = vertex;
    for (int i = 0; i < mesh.boundaryCount; ++i)
        triangulation.insert_constraint(vertices[i], vertices[(i + 1) % mesh.boundaryCount]);
    if (triangulation.number_of_vertices() != mesh.points.size())
        return false;
    for (int i = 0; i < mesh.boundaryCount; ++i) // an edge through another vertex has been split there
        if (!triangulation.is_edge(vertices[i], vertices[(i + 1) % mesh.boundaryCount]))
            return false;
    markSides(triangulation);
    mesh.triangles.clear();
    for (auto face : triangulation.finite_face_handles())
        if (face->side == 1)
            mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    // The order of CGAL's faces depends on the history of insertion; ours must not.
    for (auto& t : mesh.triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(mesh.triangles.begin(), mesh.triangles.end());
    return true;
}

void smooth(PatchMesh& mesh)
{
    std::vector<Vec2> sum(mesh.points.size(), Vec2::Zero());
    std::vector<double> weight(mesh.points.size(), 0);
    // Each vertex moves to the area-weighted centre of its triangles, which evens out sizes near the outline.
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec2 u = mesh.points[b] - mesh.points[a], v = mesh.points[c] - mesh.points[a];
        const double area = std::abs(u.x() * v.y() - u.y() * v.x());
        const Vec2 centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
        for (int i : {a, b, c}) {
            sum[i] += area * centre;
            weight[i] += area;
        }
    }
    for (std::size_t i = mesh.boundaryCount; i < mesh.points.size(); ++i)
        if (weight[i] > 0)
            mesh.points[i] = sum[i] / weight[i];
}

} // namespace

PatchMesh triangulatePatch(const std::vector<Vec2>& boundary, double edgeLength)
{
    PatchMesh mesh;
    mesh.points = boundary;
    mesh.boundaryCount = static_cast<int>(boundary.size());
    const std::vector<Vec2> inner = seeds(boundary, edgeLength);
    mesh.points.insert(mesh.points.end(), inner.begin(), inner.end());
    if (!triangulate(mesh)) {
        mesh.triangles.clear();
        return mesh;
    }
    for (int round = 0; round < smoothingRounds; ++round) {
        smooth(mesh);
        if (round + 1 == smoothingRounds)
            triangulate(mesh);
    }
    return mesh;
}

} // namespace bolster
