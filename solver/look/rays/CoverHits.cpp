#include "CoverHits.h"

#include "Design.h"
#include "LinearLight.h"
#include "Shading.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

template <class T>
T mixed(const std::vector<T>& values, const std::array<std::uint32_t, 3>& corners, const RayHit& hit)
{
    return (1.f - hit.u - hit.v) * values[corners[0]] + hit.u * values[corners[1]] + hit.v * values[corners[2]];
}

/// Shadow rays that start on a flat triangle of a round surface see their own neighbours and draw the triangles'
/// edges at the border of the light. So they start where the round surface would be (after J. Hanika, "Hacking
/// the shadow terminator", Ray Tracing Gems II, 2021).
Vec3f liftedOrigin(const ShadedPoint& point, const std::array<Vec3f, 3>& corners,
                   const std::array<Vec3f, 3>& normals, const std::array<float, 3>& weights)
{
    Vec3f lift = Vec3f::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3f away = point.position - corners[i];
        lift -= weights[i] * std::min(0.f, away.dot(normals[i])) * normals[i];
    }
    return point.position + lift;
}

} // namespace

void ShadedPoint::wear(const FabricSampler& maps, const ClothFrame& cloth, const Eigen::Matrix2f& toTile,
                       const Vec3f& behind, bool relief)
{
    const FabricSampler::Sample sample = maps.at(toTile * cloth.at, toTile * cloth.right, toTile * cloth.up);
    color = sample.color + (1 - sample.opacity) * behind;
    roughness = sample.roughness;
    if (!relief)
        return;
    const Eigen::Vector2f lean = toTile.transpose() * sample.lean;
    normal = (normal + lean.x() * cloth.x + lean.y() * cloth.y).normalized();
}

shading::Cloth ShadedPoint::cloth() const
{
    return {color.array(), roughness, sheen, specular};
}

void ShadedPoint::take(const shading::Cloth& cloth)
{
    color = cloth.color.matrix();
    roughness = cloth.roughness;
    sheen = cloth.sheen;
    specular = cloth.specular;
}

CoverHits::CoverHits(const Scene& scene, const Vec3& origin)
    : m_checker(scene.checker)
    , m_checkerSize(static_cast<float>(scene.checkerSize > 0 ? scene.checkerSize : 20))
{
    if (!scene.surface || !scene.surface->topology)
        return;
    const SurfaceMesh& mesh = *scene.surface;
    const std::size_t count = mesh.topology->pattern.size();
    if (mesh.positions.size() != count || mesh.normals.size() != count)
        return;
    if (scene.cover)
        takeCover(*scene.cover, *mesh.topology, origin);
    else
        takeSurface(mesh, origin);
    if (scene.map && scene.map->fits(*mesh.topology) && scene.map->values.size() == count) {
        for (const auto& [r, g, b, a] : scene.map->colors())
            m_mapColors.push_back(Eigen::Vector4f(r, g, b, a) / 255);
        if (scene.cover)
            m_mapColors = scene.cover->topology->carriedOver(m_mapColors);
    }
    takeLooks(scene, scene.cover ? scene.cover->topology->trianglesPerCoarse() : 1);
}

void CoverHits::takeSurface(const SurfaceMesh& mesh, const Vec3& origin)
{
    const SurfaceTopology& topology = *mesh.topology;
    m_triangles = topology.triangles;
    m_normals = mesh.normals;
    for (const Vec3& p : mesh.positions)
        m_points.push_back((p - origin).cast<float>());
    for (const Vec2& p : topology.pattern)
        m_pattern.push_back(p.cast<float>());
    m_relief = seamRelief(Design(), topology);
}

void CoverHits::takeCover(const CoverMesh& cover, const SurfaceTopology& shown, const Vec3& origin)
{
    const CoverTopology& topology = *cover.topology;
    const std::size_t each = topology.trianglesPerCoarse();
    for (const SurfaceTopology::PatchRange& range : shown.patches) {
        const auto whole =
            std::ranges::find(topology.coarse->patches, range.patch, &SurfaceTopology::PatchRange::patch);
        if (whole == topology.coarse->patches.end())
            continue;
        const auto first = topology.triangles.begin() + static_cast<std::ptrdiff_t>(each * whole->firstTriangle);
        m_triangles.insert(m_triangles.end(), first,
                           first + static_cast<std::ptrdiff_t>(each * whole->triangleCount));
    }
    m_normals = cover.normals;
    m_pattern = topology.pattern;
    const Vec3f shift = origin.cast<float>();
    for (const Vec3f& p : cover.points)
        m_points.push_back(p - shift);
    const bool known = cover.relief && cover.relief->fits(topology.coarse->serial, m_pattern.size());
    m_relief = known ? cover.relief : seamRelief(Design(), topology);
}

void CoverHits::takeLooks(const Scene& scene, std::size_t trianglesPerCoarse)
{
    std::map<FabricMapsPtr, std::shared_ptr<const FabricSampler>> samplers;
    m_patchOfTriangle.assign(m_triangles.size(), 0);
    for (const SurfaceTopology::PatchRange& range : scene.surface->topology->patches) {
        const std::size_t first = trianglesPerCoarse * range.firstTriangle;
        const std::size_t end = std::min(m_triangles.size(), first + trianglesPerCoarse * range.triangleCount);
        for (std::size_t t = first; t < end; ++t)
            m_patchOfTriangle[t] = static_cast<std::uint16_t>(m_cloths.size());
        const auto look = std::ranges::find(scene.patches, range.patch, &Scene::PatchLook::patch);
        const Scene::PatchLook shown = look != scene.patches.end() ? *look : Scene::PatchLook{};
        const Light color = lightOf(shown.color);
        Cloth cloth;
        cloth.light = m_checker ? shading::lightSquare(color) : color;
        cloth.dark = m_checker ? shading::darkSquare(color) : color;
        cloth.sheen = shading::bareSheen;
        if (!m_checker && shown.maps && shown.maps->complete()) {
            auto& sampler = samplers[shown.maps];
            if (!sampler)
                sampler = std::make_shared<FabricSampler>(*shown.maps);
            cloth.maps = sampler;
            cloth.sheen = static_cast<float>(shown.maps->sheen);
            cloth.toTile = Eigen::Rotation2Df(static_cast<float>(-shown.turn)).toRotationMatrix();
        }
        m_cloths.push_back(std::move(cloth));
    }
    if (m_cloths.empty())
        m_cloths.push_back({Vec3f::Constant(0.5f), Vec3f::Constant(0.4f)});
}

ShadedPoint CoverHits::at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const
{
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const std::array<Vec3f, 3> corners{m_points[ids[0]], m_points[ids[1]], m_points[ids[2]]};
    const bool outside = hit.normal.dot(direction) < 0;
    const float side = outside ? 1.f : -1.f;

    ShadedPoint point;
    point.face = side * hit.normal;
    point.position = mixed(m_points, ids, hit);
    std::array<Vec3f, 3> normals;
    for (int i = 0; i < 3; ++i) {
        const Vec3f& n = m_normals[ids[i]];
        normals[i] = n.allFinite() && n.squaredNorm() > 0.25f ? Vec3f(side * n) : point.face;
    }
    const std::array<float, 3> weights{1.f - hit.u - hit.v, hit.u, hit.v};
    point.normal = weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2];
    point.normal = point.normal.squaredNorm() > 1e-6f ? point.normal.normalized() : point.face;
    point.smooth = point.normal;
    point.shadowOrigin = liftedOrigin(point, corners, normals, weights);

    point.roughness = shading::bareRoughness;
    point.specular = shading::clothSpecular;
    const std::optional<TriangleFrame> triangle = TriangleFrame::of(corners, hit, direction, pixel);
    const auto pattern =
        triangle ? ClothFrame::of(*triangle, {m_pattern[ids[0]], m_pattern[ids[1]], m_pattern[ids[2]]}, hit)
                 : std::nullopt;
    dress(hit, pattern, point);
    if (!outside)
        point.take(shading::lining(point.color.array()));
    else if (triangle)
        pressSeam(hit, *triangle, point);
    return point;
}

/// The fabric's colour and how it shines; its grain leans the normal, but not that of the lining.
void CoverHits::dress(const RayHit& hit, const std::optional<ClothFrame>& pattern, ShadedPoint& point) const
{
    const Cloth& cloth = m_cloths[m_patchOfTriangle[hit.triangle]];
    point.sheen = cloth.sheen;
    point.color = cloth.dark;
    if (cloth.maps && pattern) {
        point.wear(*cloth.maps, *pattern, cloth.toTile, cloth.light, point.face.dot(hit.normal) > 0);
    } else if (m_checker) {
        point.color += (pattern ? checker(*pattern) : 0.5f) * (cloth.light - cloth.dark);
    }
    if (m_mapColors.empty())
        return;
    const Eigen::Vector4f map = mixed(m_mapColors, m_triangles[hit.triangle], hit);
    point.color = (1 - map.w()) * point.color + map.w() * Vec3f(map.head<3>().array().pow(shading::mapGamma));
}

/// The share of light squares under the pixel: the checker integrated over the pixel's bounding box in the
/// outline's coordinates, so it neither flickers nor needs mip-maps.
float CoverHits::checker(const ClothFrame& pattern) const
{
    const Eigen::Vector2f at = pattern.at / m_checkerSize;
    const Eigen::Vector2f width = (pattern.right.cwiseAbs() + pattern.up.cwiseAbs()) / m_checkerSize;
    return 0.5f + 0.5f * shading::squareWave(at.x(), width.x()) * shading::squareWave(at.y(), width.y());
}

/// The thread pulls the cover in, and under it lie the allowances: the normal leans, and little light reaches the
/// bottom.
void CoverHits::pressSeam(const RayHit& hit, const TriangleFrame& triangle, ShadedPoint& point) const
{
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const auto& distances = m_relief->distances;
    const Vec3f second = distances[ids[1]] - distances[ids[0]], third = distances[ids[2]] - distances[ids[0]];
    const auto change = [&](const Vec3f& step) {
        return Vec3f((triangle.toSecond.dot(step) * second + triangle.toThird.dot(step) * third).cwiseAbs());
    };
    const Vec3f pixel = change(triangle.right).cwiseMax(change(triangle.up));
    const SeamProfile seam = SeamProfile::at(mixed(distances, ids, hit), mixed(m_relief->shapes, ids, hit), pixel);
    const Vec3f rise = seam.slope.dot(second) * triangle.toSecond + seam.slope.dot(third) * triangle.toThird;
    const Vec3f leaning = point.normal - rise;
    if (leaning.dot(point.face) > 0)
        point.normal = leaning.normalized();
    point.take(shading::inValley(point.cloth(), seam.dark));
}

} // namespace bolster
