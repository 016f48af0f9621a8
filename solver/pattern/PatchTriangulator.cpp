#include "PatchTriangulator.h"

#include "SegmentGrid.h"

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

constexpr double seedGap = 0.55; // seeds keep this many edge lengths away from the outline and inner lines
constexpr int smoothingRounds = 3;

/// For each of these heights, increasing: where a horizontal line enters and leaves the outline, increasing.
std::vector<std::vector<double>> crossings(const std::vector<Vec2>& boundary, const std::vector<double>& heights)
{
    std::vector<std::vector<double>> crossings(heights.size());
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const Vec2& p = boundary[i];
        const Vec2& q = boundary[(i + 1) % boundary.size()];
        const auto [low, high] = std::minmax(p.y(), q.y());
        for (auto y = std::ranges::lower_bound(heights, low); y != heights.end() && *y < high; ++y)
            crossings[y - heights.begin()].push_back(p.x() + (*y - p.y()) / (q.y() - p.y()) * (q.x() - p.x()));
    }
    for (std::vector<double>& xs : crossings)
        std::sort(xs.begin(), xs.end());
    return crossings;
}

std::vector<Vec2> seeds(const std::vector<Vec2>& boundary, const std::vector<InnerLine>& lines, double edge)
{
    Box2 box;
    for (const Vec2& p : boundary)
        box.extend(p);
    SegmentGrid grid(box, edge);
    grid.addPolyline(boundary, true);
    for (const InnerLine& line : lines)
        grid.addPolyline(line.points, line.closed);
    const double height = edge * std::sqrt(3.0) / 2;
    // The rows are centred, so that a symmetric patch gets a symmetric mesh as far as rows can be.
    const int rows = static_cast<int>(box.sizes().y() / height);
    const double firstY = box.center().y() - 0.5 * rows * height;
    std::vector<double> heights;
    for (int row = 0; row <= rows; ++row)
        heights.push_back(firstY + row * height);
    const std::vector<std::vector<double>> crossed = crossings(boundary, heights);
    std::vector<Vec2> points;
    for (int row = 0; row <= rows; ++row) {
        const double y = heights[row];
        const double shift = box.center().x() + (row % 2 ? 0.5 * edge : 0);
        const std::vector<double>& xs = crossed[row];
        for (std::size_t k = 0; k + 1 < xs.size(); k += 2)
            for (double i = std::ceil((xs[k] - shift) / edge); shift + i * edge < xs[k + 1]; ++i) {
                const Vec2 p(shift + i * edge, y);
                if (!grid.nearerThan(p, seedGap * edge))
                    points.push_back(p);
            }
    }
    return points;
}

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

/// False when constraints cross or touch: CGAL makes vertices of its own then, or splits edges.
bool triangulate(PatchMesh& mesh, const Edges& constraints)
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
    for (const auto& [a, b] : constraints)
        triangulation.insert_constraint(vertices[a], vertices[b]);
    if (triangulation.number_of_vertices() != mesh.points.size())
        return false;
    for (const auto& [a, b] : constraints) // an edge through another vertex has been split there
        if (!triangulation.is_edge(vertices[a], vertices[b]))
            return false;
    markSides(triangulation, mesh.boundaryCount);
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

/// Moves the vertices from `first` on.
void smooth(PatchMesh& mesh, std::size_t first)
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
    for (std::size_t i = first; i < mesh.points.size(); ++i)
        if (weight[i] > 0)
            mesh.points[i] = sum[i] / weight[i];
}

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
    const std::size_t keptCount = mesh.points.size();
    const Edges constraints = constraintsOf(mesh);
    const std::vector<Vec2> inner = seeds(boundary, lines, edgeLength);
    mesh.points.insert(mesh.points.end(), inner.begin(), inner.end());
    if (!triangulate(mesh, constraints)) {
        mesh.triangles.clear();
        return mesh;
    }
    for (int round = 0; round < smoothingRounds; ++round) {
        smooth(mesh, keptCount);
        if (round + 1 == smoothingRounds)
            triangulate(mesh, constraints);
    }
    return mesh;
}

} // namespace bolster
