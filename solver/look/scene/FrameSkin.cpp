#include "FrameSkin.h"

#include "HalfEdges.h"
#include "MeshShape.h"

#include <algorithm>
#include <map>
#include <utility>

namespace bolster {

namespace {

using Vec3f = Eigen::Vector3f;

constexpr float foamGives = 120;      ///< mm: how far a cover presses a frame down at most
constexpr float steepest = 1.2F;      ///< how fast that grows from where the cover ends
constexpr float straightAbove = 0.8F; ///< cosine between the cover and the way to what it presses
constexpr float notOpposite = -0.8F;  ///< the same beside a ridge, where a frame's lip may look down on the cover
constexpr float onEdge = 0.01F;       ///< mm: what is nearer to an edge lies on it
constexpr float facesAlike = 0.35F;   ///< cosine between a frame and the cover that lies on it
constexpr double longestEdge = 12;    ///< mm of triangles that bend with the cover
constexpr std::size_t mostSkinTriangles = 300000;

/// The frame's triangles, halved until they can follow the cover. Neighbours share their points: nothing gapes.
struct SkinMesh {
    struct Corner {
        std::uint32_t point;
        Vec3f normal;
    };
    using Triangle = std::array<Corner, 3>;
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<Vec3> points; ///< placed, mm
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> origin; ///< the triangle of the file
    std::map<Edge, std::uint32_t> middles;

    std::uint32_t middle(const Edge& edge)
    {
        const auto [at, isNew] =
            middles.try_emplace(std::minmax(edge.first, edge.second), static_cast<std::uint32_t>(points.size()));
        if (isNew)
            points.emplace_back((points[edge.first] + points[edge.second]) / 2);
        return at->second;
    }
    bool isLong(const Edge& edge, const Eigen::AlignedBox3f& near) const
    {
        const Vec3 &a = points[edge.first], &b = points[edge.second];
        return (a - b).squaredNorm() > longestEdge * longestEdge &&
               near.intersects(Eigen::AlignedBox3f(a.cwiseMin(b).cast<float>(), a.cwiseMax(b).cast<float>()));
    }
    /// Halves the longest edge of a triangle, if that is long.
    void halve(std::size_t t, std::size_t longest)
    {
        const Triangle now = triangles[t];
        const Corner &a = now[longest], &b = now[(longest + 1) % 3], &c = now[(longest + 2) % 3];
        const Corner half{middle({a.point, b.point}), Vec3f((a.normal + b.normal).normalized())};
        triangles[t] = {a, half, c};
        triangles.push_back({half, b, c});
        origin.push_back(origin[t]);
    }
};

/// Which of the triangle's edges is the longest; of equal ones the same for both neighbours.
std::size_t longestEdgeOf(const SkinMesh& mesh, const SkinMesh::Triangle& t)
{
    const auto key = [&](std::size_t i) {
        const std::uint32_t a = t[i].point, b = t[(i + 1) % 3].point;
        return std::tuple((mesh.points[a] - mesh.points[b]).squaredNorm(), std::min(a, b), std::max(a, b));
    };
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (key(i) > key(longest))
            longest = i;
    return longest;
}

/// Bisects the longest edges until none is long; then those that a neighbour has halved, so that no point lies on
/// somebody's edge.
void refineNear(SkinMesh& mesh, const Eigen::AlignedBox3f& near, const std::stop_token& stop)
{
    for (std::size_t t = 0; t < mesh.triangles.size() && !stop.stop_requested();) {
        const SkinMesh::Triangle& now = mesh.triangles[t];
        const std::size_t longest = longestEdgeOf(mesh, now);
        const SkinMesh::Edge edge{now[longest].point, now[(longest + 1) % 3].point};
        if (mesh.triangles.size() < mostSkinTriangles && mesh.isLong(edge, near))
            mesh.halve(t, longest);
        else
            ++t;
    }
    for (std::size_t t = 0; t < mesh.triangles.size() && !stop.stop_requested();) {
        const SkinMesh::Triangle& now = mesh.triangles[t];
        std::size_t split = 3;
        for (std::size_t i = 0; i < 3 && split == 3; ++i)
            if (mesh.middles.contains(std::minmax(now[i].point, now[(i + 1) % 3].point)))
                split = i;
        if (split < 3)
            mesh.halve(t, split);
        else
            ++t;
    }
}

/// The first of the points at the same place, for each: files have several where materials or creases meet.
std::vector<std::uint32_t> weldedPoints(const std::vector<Vec3>& points)
{
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::map<Vec3, std::uint32_t, decltype(before)> places(before);
    std::vector<std::uint32_t> first;
    for (const Vec3& p : points) {
        const auto index = static_cast<std::uint32_t>(first.size());
        first.push_back(p.allFinite() ? places.try_emplace(p, index).first->second : index);
    }
    return first;
}

SkinMesh placedMesh(const TriangleMesh& mesh, const Placement& placement)
{
    SkinMesh placed;
    for (const Vec3& p : mesh.points)
        placed.points.push_back(placement.placed(p));
    const auto normals = cornerNormals(placed.points, mesh.triangles);
    const std::vector<std::uint32_t> welded = weldedPoints(mesh.points);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& ids = mesh.triangles[t];
        if (std::ranges::any_of(ids, [&](std::uint32_t p) { return p >= placed.points.size(); }))
            continue;
        placed.triangles.push_back({SkinMesh::Corner{welded[ids[0]], normals[t][0]},
                                    SkinMesh::Corner{welded[ids[1]], normals[t][1]},
                                    SkinMesh::Corner{welded[ids[2]], normals[t][2]}});
        placed.origin.push_back(t);
    }
    return placed;
}

/// Of each point, outwards; inwards where a file has its triangles the other way round.
std::vector<Vec3f> outwardNormals(const SkinMesh& mesh)
{
    std::vector<Vec3> sums(mesh.points.size(), Vec3::Zero());
    double volume = 0;
    const Vec3 origin = mesh.points.empty() ? Vec3(Vec3::Zero()) : mesh.points.front();
    for (const SkinMesh::Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.points[t[0].point], b = mesh.points[t[1].point], c = mesh.points[t[2].point];
        const Vec3 normal = (b - a).cross(c - a);
        if (!normal.allFinite())
            continue;
        volume += normal.dot(a - origin);
        for (const SkinMesh::Corner& corner : t)
            sums[corner.point] += normal;
    }
    std::vector<Vec3f> normals;
    for (const Vec3& sum : sums)
        normals.emplace_back((sum.norm() > 0 ? Vec3(sum.normalized()) : sum).cast<float>() *
                             (volume < 0 ? -1.F : 1.F));
    return normals;
}

/// The longest side of each triangle's part in the file: there the grain runs.
std::vector<std::uint8_t> grainAxes(const TriangleMesh& mesh)
{
    std::vector<std::uint8_t> axes(mesh.triangles.size(), 2);
    for (const TriangleMesh::Part& part : mesh.parts) {
        Box3 box;
        const std::size_t end =
            std::min<std::size_t>(mesh.triangles.size(), part.firstTriangle + part.triangleCount);
        for (std::size_t t = part.firstTriangle; t < end; ++t)
            for (const std::uint32_t p : mesh.triangles[t])
                if (p < mesh.points.size())
                    box.extend(mesh.points[p]);
        if (box.isEmpty())
            continue;
        Eigen::Index longest = 2;
        box.sizes().maxCoeff(&longest);
        std::fill(axes.begin() + part.firstTriangle, axes.begin() + static_cast<std::ptrdiff_t>(end),
                  static_cast<std::uint8_t>(longest));
    }
    return axes;
}

/// Which edges of each triangle no other one has, beginning with that from its first corner.
std::vector<std::array<bool, 3>> rimsOf(const std::vector<TriangleRays::Triangle>& triangles)
{
    std::vector<std::array<bool, 3>> rims(triangles.size());
    eachEdge(halfEdges(triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 1)
            rims[first->triangle][first->side] = true;
    });
    return rims;
}

} // namespace

FrameSkins::FrameSkins(const SurfaceMesh* cover)
{
    if (!cover)
        return;
    const std::vector<std::uint32_t> sewn = weldedPoints(cover->positions);
    for (const Vec3& p : cover->positions)
        m_points.emplace_back(p.cast<float>());
    m_normals.assign(m_points.size(), Vec3f::Zero());
    for (const auto& t : cover->topology->triangles) {
        m_triangles.push_back({sewn[t[0]], sewn[t[1]], sewn[t[2]]});
        const Vec3f normal = (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]);
        m_faces.push_back(normal.normalized());
        for (const std::uint32_t corner : m_triangles.back()) {
            m_normals[corner] += normal;
            if (m_points[corner].allFinite())
                m_box.extend(m_points[corner]);
        }
    }
    if (m_box.isEmpty())
        return;
    for (Vec3f& normal : m_normals)
        normal.normalize();
    m_depth = std::min(4.F, 0.01F * m_box.diagonal().norm());
    m_rims = rimsOf(m_triangles);
    std::vector<TriangleRays::Triangle> edges; // nearest points need no area
    for (std::size_t t = 0; t < m_triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            if (const std::uint32_t from = m_triangles[t][i], to = m_triangles[t][(i + 1) % 3]; m_rims[t][i])
                edges.push_back({from, to, to});
    m_rim.build(m_points, std::move(edges));
    m_rays.build(m_points, m_triangles);
    m_box.extend(Vec3f(m_box.min() - Vec3f::Constant(foamGives)));
    m_box.extend(Vec3f(m_box.max() + Vec3f::Constant(foamGives)));
}

/// Where the cover ends it lies on the frame or in it, and foam is pressed more and more from there on. Whatever
/// else stands out of the cover is no foam, or the cover does lie in it.
FrameSkins::Vec3f FrameSkins::pressed(const Vec3f& point, const Vec3f& outward) const
{
    const std::optional<Foot> foot = footOf(point, outward);
    if (!foot)
        return point;
    const Vec3f way = foot->at - m_depth * foot->normal - point;
    const auto rim = m_rim.nearest(foot->at, foamGives);
    const float most = rim ? 2 * m_depth + steepest * (rim->point - foot->at).norm() : foamGives + m_depth;
    const float length = way.norm();
    return length <= most ? Vec3f(point + way) : Vec3f(point + most / length * way);
}

/// What of the cover lies under a point of the frame.
std::optional<FrameSkins::Foot> FrameSkins::footOf(const Vec3f& point, const Vec3f& outward) const
{
    constexpr int mostLayers = 4; // of cover that a ray crosses before the one that lies here
    float gone = -m_depth;
    for (int layer = 0; layer < mostLayers; ++layer) {
        const auto hit = m_rays.first(point - gone * outward, -outward);
        if (!hit || gone + hit->distance > foamGives)
            break;
        gone += hit->distance;
        if (m_faces[hit->triangle].dot(outward) > facesAlike)
            return Foot{point - gone * outward, m_faces[hit->triangle]};
        gone += 0.01F;
    }
    // Beside a ridge no ray along the normal meets the cover.
    const auto near = m_rays.nearest(point, foamGives);
    if (!near)
        return std::nullopt;
    const Vec3f& face = m_faces[near->triangle];
    const Vec3f away = point - near->point, normal = normalAt(*near);
    const bool above = onRim(*near) ? face.dot(away) > straightAbove * away.norm() : normal.dot(away) > 0;
    if (!above || normal.dot(outward) <= notOpposite)
        return std::nullopt;
    return Foot{near->point, normal};
}

/// On a ridge between the normals of both sides.
FrameSkins::Vec3f FrameSkins::normalAt(const TriangleRays::Nearest& near) const
{
    const auto corners = cornersOf(near.triangle);
    const auto area = [&](std::size_t i) {
        return (corners[(i + 1) % 3] - near.point).cross(corners[(i + 2) % 3] - near.point).norm();
    };
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        sum += area(i) * m_normals[m_triangles[near.triangle][i]];
    return sum.squaredNorm() > 0 ? Vec3f(sum.normalized()) : m_faces[near.triangle];
}

/// Whether the cover ends there: what is nearest to its rim may lie beside it as well as above.
bool FrameSkins::onRim(const TriangleRays::Nearest& near) const
{
    const auto corners = cornersOf(near.triangle);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f along = corners[(i + 1) % 3] - corners[i], to = near.point - corners[i];
        if (m_rims[near.triangle][i] && to.cross(along).norm() < onEdge * along.norm())
            return true;
    }
    return false;
}

std::array<FrameSkins::Vec3f, 3> FrameSkins::cornersOf(std::uint32_t triangle) const
{
    const auto& t = m_triangles[triangle];
    return {m_points[t[0]], m_points[t[1]], m_points[t[2]]};
}

FrameSkinPtr FrameSkins::skin(const TriangleMesh& mesh, const Placement& placement,
                              const std::stop_token& stop) const
{
    SkinMesh fine = placedMesh(mesh, placement);
    std::vector<Vec3f> points;
    if (!m_box.isEmpty()) {
        refineNear(fine, m_box, stop);
        const std::vector<Vec3f> outward = outwardNormals(fine);
        for (std::size_t i = 0; i < fine.points.size() && !stop.stop_requested(); ++i) {
            const Vec3f p = fine.points[i].cast<float>();
            points.push_back(m_box.contains(p) && outward[i].squaredNorm() > 0.5F ? pressed(p, outward[i]) : p);
        }
    } else {
        for (const Vec3& p : fine.points)
            points.emplace_back(p.cast<float>());
    }
    if (stop.stop_requested())
        return nullptr;
    const std::vector<std::uint8_t> axes = grainAxes(mesh);
    auto skin = std::make_shared<FrameSkin>();
    skin->placement = placement;
    skin->corners.reserve(3 * fine.triangles.size());
    for (std::size_t t = 0; t < fine.triangles.size(); ++t)
        for (const SkinMesh::Corner& corner : fine.triangles[t]) {
            const Vec3 inFile = placement.scale * placement.filePoint(fine.points[corner.point]);
            const Vec3f file = inFile.cast<float>();
            const auto axis = axes[fine.origin[t]];
            const Vec3f grain(file[(axis + 1) % 3], file[(axis + 2) % 3], file[axis]);
            skin->corners.push_back({points[corner.point], corner.normal, grain});
        }
    return skin;
}

} // namespace bolster
