#include "UncutForm.h"

#include "SegmentDistance.h"

#include <limits>

namespace bolster {

namespace {

constexpr double offForm = 0.05, samePlace = 1e-6; // mm

std::vector<FormTree::Triangle> trianglesOf(const TriangleSoup& soup)
{
    std::vector<FormTree::Triangle> triangles;
    for (const auto& [a, b, c] : soup.triangles)
        triangles.push_back({soup.points[a], soup.points[b], soup.points[c]});
    return triangles;
}

} // namespace

UncutForm::UncutForm(const TriangleSoup& form, const FormCuts& cuts, const std::stop_token& stop)
    : m_cuts(cuts)
    , m_whole(m_mesh.build(form, {}, stop))
    , m_tree(trianglesOf(form), stop)
    , m_sharp(form)
{}

/// The face that is nearest to a place on the form.
std::pair<Vec3, Face> UncutForm::faceNear(const Vec3& place) const
{
    const auto [at, triangle] = m_tree.nearestTo(place);
    return {at, Face(triangle)}; // the mesh has been made of all triangles, in their order
}

LinePlace UncutForm::placeOf(const Vec3& at) const
{
    const auto [near, triangle] = m_tree.nearestTo(at);
    const auto& [a, b, c] = m_tree.triangle(triangle);
    return {near, (b - a).cross(c - a).normalized(), (at - near).norm()};
}

/// Whether a place lies beside the form, outside of its border.
bool UncutForm::isBeyond(const Vec3& at) const
{
    const auto [place, face] = faceNear(at);
    if ((place - at).norm() < offForm)
        return false;
    const Kernel::Point_3 near = toCgal(place);
    for (const auto half : m_mesh.mesh.halfedges_around_face(m_mesh.mesh.halfedge(face))) {
        const Kernel::Point_3 &a = m_mesh.mesh.point(m_mesh.mesh.source(half)),
                              &b = m_mesh.mesh.point(m_mesh.mesh.target(half));
        const bool isAtCorner = m_mesh.mesh.is_border(m_mesh.mesh.target(half)) &&
                                CGAL::squared_distance(near, b) < samePlace * samePlace;
        const bool isOnEdge = m_mesh.mesh.is_border(m_mesh.mesh.edge(half)) &&
                              CGAL::squared_distance(near, Kernel::Segment_3(a, b)) < samePlace * samePlace;
        if (isAtCorner || isOnEdge)
            return true;
    }
    return false;
}

/// Or outside of a sharp edge, where the form goes on in another direction.
bool UncutForm::isOutside(const Vec3& at) const
{
    if (isBeyond(at))
        return true;
    const Vec3 place = m_tree.nearestTo(at).at;
    const std::optional<Vec3> edge = m_sharp.nearest(place);
    return (place - at).norm() >= offForm && edge && (*edge - place).norm() < samePlace;
}

/// The place of a border, or of where it is cut anyway, that is nearest to a place on the form; none where none
/// is near.
std::optional<Vec3> UncutForm::borderNear(const Vec3& at) const
{
    const Face face = faceNear(at).second;
    std::optional<Vec3> found;
    for (const Vertex v : m_mesh.mesh.vertices_around_face(m_mesh.mesh.halfedge(face)))
        for (const auto half : m_mesh.mesh.halfedges_around_target(m_mesh.mesh.halfedge(v))) {
            if (!m_mesh.isCutAnyway(m_mesh.mesh.edge(half), m_cuts))
                continue;
            const auto [from, to] = m_mesh.endsOf(m_mesh.mesh.edge(half));
            const Vec3 place = nearestOnSegment<3>(at, from, to);
            if (!found || (place - at).norm() < (*found - at).norm())
                found = place;
        }
    return found;
}

double UncutForm::distanceFromBorder(const Vec3& at) const
{
    const std::optional<Vec3> border = borderNear(at);
    return border ? (*border - at).norm() : std::numeric_limits<double>::infinity();
}

/// The place on such an edge that is nearest to where a line's place lies on the form.
std::optional<Vec3> UncutForm::edgeNear(const Vec3& at, double within) const
{
    const Vec3 on = m_tree.nearestTo(at).at;
    std::optional<Vec3> edge = borderNear(on);
    if (const std::optional<Vec3> sharp = m_sharp.nearest(on);
        sharp && (!edge || (*sharp - on).norm() < (*edge - on).norm()))
        edge = sharp;
    return edge && (*edge - on).norm() < within ? edge : std::nullopt;
}

} // namespace bolster
