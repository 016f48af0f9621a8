#include "CoverLook.h"

#include "Srgb.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bolster {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr float seamReach = 5.f; ///< mm: how far the valley reaches to each side
constexpr float seamLine = 0.5f; ///< mm: half the width of the dark line

constexpr float plainRoughness = 0.62f;
constexpr float plainSheen = 0.12f;

/// Mean of a square wave of period 2 (+1 on [0, 1), -1 on [1, 2)) over a window of this width.
float squareWave(float at, float width)
{
    const auto integral = [](float x) { return 1.f - std::abs(x - 2.f * std::floor(x / 2.f) - 1.f); };
    width = std::max(width, 1e-4f);
    if (width > 8.f)
        return 0.f;
    return (integral(at + width / 2) - integral(at - width / 2)) / width;
}

Vec3f nearestOnSegment(const Vec3f& p, const Vec3f& a, const Vec3f& b)
{
    const Vec3f along = b - a;
    const float length2 = along.squaredNorm();
    const float t = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.f, 1.f) : 0.f;
    return a + t * along;
}

template <class T>
T mixed(const std::vector<T>& values, const std::array<std::uint32_t, 3>& corners, const RayHit& hit)
{
    return (1.f - hit.u - hit.v) * values[corners[0]] + hit.u * values[corners[1]] + hit.v * values[corners[2]];
}

/// Shadow rays that start on a flat triangle of a round surface see their own neighbours and draw the triangles'
/// edges at the border of the light. So they start where the round surface would be (after J. Hanika, "Hacking
/// the shadow terminator", Ray Tracing Gems II, 2021).
Vec3f liftedOrigin(const SurfacePoint& point, const std::array<Vec3f, 3>& corners,
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

Vec3f linearColor(const std::string& color)
{
    const auto hex = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
    };
    if (color.size() != 7 || color[0] != '#' ||
        std::any_of(color.begin() + 1, color.end(), [&](char c) { return hex(c) < 0; }))
        return {0.5f, 0.5f, 0.5f};
    Vec3f linear;
    for (std::size_t i = 0; i < 3; ++i)
        linear[static_cast<Eigen::Index>(i)] =
            linearFromSrgb(static_cast<std::uint8_t>(16 * hex(color[1 + 2 * i]) + hex(color[2 + 2 * i])));
    return linear;
}

CoverLook::CoverLook(const PreviewScene& scene, const Vec3& origin)
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
    if (scene.vertexColors.size() == count) {
        for (const auto& [r, g, b, a] : scene.vertexColors)
            m_mapColors.push_back(Eigen::Vector4f(r, g, b, a) / 255);
        if (scene.cover)
            m_mapColors = scene.cover->topology->carriedOver(m_mapColors);
    }
    takeLooks(scene, scene.cover ? scene.cover->topology->trianglesPerCoarse() : 1);
}

void CoverLook::takeSurface(const SurfaceMesh& mesh, const Vec3& origin)
{
    const SurfaceTopology& topology = *mesh.topology;
    m_triangles = topology.triangles;
    m_normals = mesh.normals;
    for (const Vec3& p : mesh.positions)
        m_points.push_back((p - origin).cast<float>());
    for (const Vec2& p : topology.pattern)
        m_pattern.push_back(p.cast<float>());
    std::vector<std::vector<std::uint32_t>> seams;
    for (const SurfaceTopology::Chain& chain : topology.seams) {
        seams.push_back(chain.a);
        seams.push_back(chain.b);
    }
    takeSeams(seams);
}

void CoverLook::takeCover(const CoverMesh& cover, const SurfaceTopology& shown, const Vec3& origin)
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
    std::vector<std::vector<std::uint32_t>> seams;
    for (const SurfaceTopology::Chain& chain : shown.seams) {
        seams.push_back(topology.along(chain.a));
        seams.push_back(topology.along(chain.b));
    }
    takeSeams(seams);
}

/// Each vertex of a seam knows its parts of it, and so do those around it: small triangles within the seam's reach
/// do not touch it.
void CoverLook::takeSeams(const std::vector<std::vector<std::uint32_t>>& seams)
{
    m_seamParts.assign(m_points.size(), {SeamPart{none, none}, SeamPart{none, none}});
    for (const std::vector<std::uint32_t>& seam : seams)
        for (std::size_t i = 1; i < seam.size(); ++i)
            for (const std::uint32_t v : {seam[i - 1], seam[i]})
                if (v < m_seamParts.size())
                    m_seamParts[v][m_seamParts[v][0][0] == none ? 0 : 1] = {seam[i - 1], seam[i]};
    const auto parts = [&](std::uint32_t v) { return m_seamParts[v][0][0] != none; };
    for (int ring = 0; ring < 4; ++ring) {
        const auto before = m_seamParts;
        for (const auto& triangle : m_triangles)
            for (const std::uint32_t v : triangle)
                for (const std::uint32_t from : triangle)
                    if (!parts(v) && before[from][0][0] != none &&
                        (m_points[v] - m_points[before[from][0][0]]).norm() < 2 * seamReach)
                        m_seamParts[v] = before[from];
    }
}

void CoverLook::takeLooks(const PreviewScene& scene, std::size_t trianglesPerCoarse)
{
    std::map<FabricMapsPtr, std::shared_ptr<const FabricSampler>> samplers;
    m_patchOfTriangle.assign(m_triangles.size(), 0);
    for (const SurfaceTopology::PatchRange& range : scene.surface->topology->patches) {
        const std::size_t first = trianglesPerCoarse * range.firstTriangle;
        const std::size_t end = std::min(m_triangles.size(), first + trianglesPerCoarse * range.triangleCount);
        for (std::size_t t = first; t < end; ++t)
            m_patchOfTriangle[t] = static_cast<std::uint16_t>(m_cloths.size());
        const auto look = std::ranges::find(scene.looks, range.patch, &PreviewScene::PatchLook::patch);
        const PreviewScene::PatchLook shown = look != scene.looks.end() ? *look : PreviewScene::PatchLook{};
        const Vec3f color = linearColor(shown.color);
        Cloth cloth{m_checker ? Vec3f((1.6f * color.array() + 0.03f).min(1.f)) : color,
                    m_checker ? Vec3f(0.85f * color) : color};
        cloth.sheen = plainSheen;
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

SurfacePoint CoverLook::at(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const
{
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const std::array<Vec3f, 3> corners{m_points[ids[0]], m_points[ids[1]], m_points[ids[2]]};
    const bool outside = hit.normal.dot(direction) < 0;
    const float side = outside ? 1.f : -1.f;

    SurfacePoint point;
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

    point.roughness = plainRoughness;
    point.specular = 0.04f;
    dress(hit, patternFrame(hit, direction, pixel), point);
    if (!outside) { // the lining: the cover's colour, but greyed
        const float grey = point.color.dot(Vec3f(0.2126f, 0.7152f, 0.0722f));
        point.color = 0.25f * point.color + Vec3f::Constant(0.12f + 0.35f * grey);
        point.roughness = 0.9f;
        point.sheen = 0;
        point.specular = 0.02f;
    } else {
        pressSeam(hit, pixel.right.norm(), point);
    }
    return point;
}

/// The fabric's colour and how it shines; its grain leans the normal, but not that of the lining.
void CoverLook::dress(const RayHit& hit, const std::optional<PatternFrame>& pattern, SurfacePoint& point) const
{
    const Cloth& cloth = m_cloths[m_patchOfTriangle[hit.triangle]];
    point.sheen = cloth.sheen;
    point.color = cloth.dark;
    if (cloth.maps && pattern) {
        const FabricSampler::Sample sample =
            cloth.maps->at(cloth.toTile * pattern->at, cloth.toTile * pattern->right, cloth.toTile * pattern->up);
        point.color = sample.color + (1 - sample.opacity) * cloth.light;
        point.roughness = sample.roughness;
        if (point.face.dot(hit.normal) > 0) {
            const Eigen::Vector2f lean = cloth.toTile.transpose() * sample.lean;
            point.normal = (point.normal + lean.x() * pattern->x + lean.y() * pattern->y).normalized();
        }
    } else if (m_checker) {
        point.color += (pattern ? checker(*pattern) : 0.5f) * (cloth.light - cloth.dark);
    }
    if (m_mapColors.empty())
        return;
    const Eigen::Vector4f map = mixed(m_mapColors, m_triangles[hit.triangle], hit);
    point.color = (1 - map.w()) * point.color + map.w() * Vec3f(map.head<3>().array().pow(2.2f));
}

std::optional<CoverLook::PatternFrame> CoverLook::patternFrame(const RayHit& hit, const Vec3f& direction,
                                                               const Footprint& pixel) const
{
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const Vec3f e1 = m_points[ids[1]] - m_points[ids[0]], e2 = m_points[ids[2]] - m_points[ids[0]];
    const Eigen::Vector2f d1 = m_pattern[ids[1]] - m_pattern[ids[0]], d2 = m_pattern[ids[2]] - m_pattern[ids[0]];
    const Vec3f across = e1.cross(e2);
    const float area2 = across.squaredNorm(), turned = d1.x() * d2.y() - d1.y() * d2.x();
    if (!(area2 > 0) || turned == 0)
        return std::nullopt;
    const Vec3f toE1 = e2.cross(across) / area2, toE2 = across.cross(e1) / area2; // dual to e1, e2
    const float facing = direction.dot(hit.normal);
    const auto onSurface = [&](const Vec3f& step) { // where the neighbouring pixel's ray meets the plane
        return Vec3f(step - direction * (step.dot(hit.normal) / (std::abs(facing) > 0.05f ? facing : 0.05f)));
    };
    const auto inPattern = [&](const Vec3f& step) {
        return Eigen::Vector2f(toE1.dot(step) * d1 + toE2.dot(step) * d2);
    };
    PatternFrame frame{mixed(m_pattern, ids, hit), inPattern(onSurface(pixel.right)),
                       inPattern(onSurface(pixel.up)), ((d2.y() * e1 - d1.y() * e2) / turned).normalized(),
                       ((d1.x() * e2 - d2.x() * e1) / turned).normalized()};
    const bool finite = frame.at.allFinite() && frame.right.allFinite() && frame.up.allFinite() &&
                        frame.x.allFinite() && frame.y.allFinite();
    return finite ? std::optional(frame) : std::nullopt;
}

/// The share of light squares under the pixel: the checker integrated over the pixel's bounding box in the
/// outline's coordinates, so it neither flickers nor needs mip-maps.
float CoverLook::checker(const PatternFrame& pattern) const
{
    const Eigen::Vector2f at = pattern.at / m_checkerSize;
    const Eigen::Vector2f width = (pattern.right.cwiseAbs() + pattern.up.cwiseAbs()) / m_checkerSize;
    return 0.5f + 0.5f * squareWave(at.x(), width.x()) * squareWave(at.y(), width.y());
}

/// The thread pulls the cover in: the normal leans towards the seam, and a dark line remains.
void CoverLook::pressSeam(const RayHit& hit, float pixelSize, SurfacePoint& point) const
{
    float nearest2 = seamReach * seamReach;
    Vec3f towards = Vec3f::Zero();
    for (const std::uint32_t corner : m_triangles[hit.triangle])
        for (const auto& [from, to] : m_seamParts[corner]) {
            if (from == none)
                continue;
            const Vec3f away = nearestOnSegment(point.position, m_points[from], m_points[to]) - point.position;
            if (away.squaredNorm() < nearest2) {
                nearest2 = away.squaredNorm();
                towards = away;
            }
        }
    if (towards.isZero())
        return;
    const float distance = std::sqrt(nearest2);
    const float depth = 1.f - distance / seamReach;
    const Vec3f leaning = point.normal + 0.55f * depth * depth * towards / std::max(distance, 0.3f);
    point.normal = leaning.normalized();
    const float reach = std::max(seamLine, 0.6f * pixelSize);
    const float line = std::clamp((reach - distance) / std::max(pixelSize, 0.05f) + 0.5f, 0.f, 1.f);
    point.color *= (1.f - 0.35f * depth * depth) * (1.f - 0.6f * line * std::min(1.f, 2.f * seamLine / reach));
    point.specular *= 1.f - line;
}

} // namespace bolster
