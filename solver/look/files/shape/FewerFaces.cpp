#include "FewerFaces.h"

#include "TriangleTree.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

namespace collapse = CGAL::Surface_mesh_simplification;
namespace processing = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double flattest = -0.9999; // cosine of the largest corner of what is no triangle any more
constexpr double thinnest = 1e4;     // times as long as broad
constexpr double shortEdge = 0.01;   // mm: only such ones are taken out of needles
constexpr double farthestOff = 20;   // mm: nobody wants to know more
constexpr double most = 0.99;        // of the points; the others lie where the body ends as thin as a blade

struct NoLongerWanted {};

struct StopVisitor : collapse::Edge_collapse_visitor_base<Mesh> {
    explicit StopVisitor(const std::stop_token& token)
        : stop(&token)
    {}
    template <class Profile, class Cost>
    void OnSelected(const Profile&, const Cost&, std::size_t, std::size_t) const
    {
        if (stop->stop_requested())
            throw NoLongerWanted();
    }
    const std::stop_token* stop;
};

/// Points where several parts touch become one of each.
Mesh meshOfSolid(const TriangleMesh& solid)
{
    std::vector<Kernel::Point_3> points;
    for (const Vec3& p : solid.points)
        points.emplace_back(p.x(), p.y(), p.z());
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const auto& [a, b, c] : solid.triangles)
        triangles.push_back({a, b, c});
    processing::orient_polygon_soup(points, triangles);
    Mesh mesh;
    processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
}

TriangleMesh solidOf(const Mesh& mesh, const std::string& name)
{
    TriangleMesh solid;
    std::vector<std::uint32_t> numbers(mesh.num_vertices() + mesh.number_of_removed_vertices());
    for (const Mesh::Vertex_index vertex : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(vertex);
        numbers[vertex] = static_cast<std::uint32_t>(solid.points.size());
        solid.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const Mesh::Face_index face : mesh.faces()) {
        std::array<std::uint32_t, 3> corners{};
        std::size_t k = 0;
        for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            corners[k++] = numbers[vertex];
        solid.triangles.push_back(corners);
    }
    solid.parts = {{name, 0, static_cast<std::uint32_t>(solid.triangles.size())}};
    return solid;
}

/// How far most of the points are from it, mm.
double farFrom(const TriangleMesh& solid, const std::vector<Vec3>& points, const std::stop_token& stop)
{
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& [a, b, c] : solid.triangles)
        triangles.push_back({solid.points[a], solid.points[b], solid.points[c]});
    const TriangleTree tree(triangles, stop);
    std::vector<double> distances;
    for (const Vec3& point : points)
        if (!stop.stop_requested())
            distances.push_back(tree.distance(point, farthestOff));
    if (distances.empty())
        return 0;
    const auto rank =
        distances.begin() + static_cast<std::ptrdiff_t>(most * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), rank, distances.end());
    return *rank;
}

} // namespace

FewerFaces withFewerFaces(const TriangleMesh& solid, std::size_t faces, const std::stop_token& stop)
{
    if (solid.triangles.size() <= faces)
        return {solid, 0};
    Mesh mesh = meshOfSolid(solid);
    try {
        collapse::edge_collapse(
            mesh, collapse::Count_stop_predicate<Mesh>(faces * 3 / 2),
            CGAL::parameters::filter(collapse::Bounded_normal_change_filter<>()).visitor(StopVisitor(stop)));
    } catch (const NoLongerWanted&) {
        return {};
    }
    processing::experimental::remove_almost_degenerate_faces(mesh, flattest, thinnest, shortEdge);
    FewerFaces fewer{solidOf(mesh, solid.parts.empty() ? std::string() : solid.parts.front().name), 0};
    fewer.off = farFrom(fewer.mesh, solid.points, stop);
    return stop.stop_requested() ? FewerFaces() : fewer;
}

} // namespace bolster
