#include "CoverLook.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr float seamReach = 5.f; ///< mm: how far the valley reaches to each side
constexpr float seamLine = 0.5f; ///< mm: half the width of the dark line

float toLinear(int byte)
{
    const float s = static_cast<float>(byte) / 255.f;
    return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

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

void link(std::vector<std::array<std::uint32_t, 2>>& neighbours, std::uint32_t from, std::uint32_t to)
{
    for (std::uint32_t& slot : neighbours[from])
        if (slot == none || slot == to) {
            slot = to;
            return;
        }
}

std::vector<std::array<std::uint32_t, 2>> seamNeighbours(const SurfaceTopology& topology)
{
    std::vector<std::array<std::uint32_t, 2>> neighbours(topology.vertexCount(), {none, none});
    for (const SurfaceTopology::Chain& chain : topology.seams)
        for (const auto* side : {&chain.a, &chain.b})
            for (std::size_t i = 1; i < side->size(); ++i) {
                const std::uint32_t p = (*side)[i - 1], q = (*side)[i];
                if (p >= neighbours.size() || q >= neighbours.size())
                    continue;
                link(neighbours, p, q);
                link(neighbours, q, p);
            }
    return neighbours;
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
        linear[static_cast<Eigen::Index>(i)] = toLinear(16 * hex(color[1 + 2 * i]) + hex(color[2 + 2 * i]));
    return linear;
}

CoverLook::CoverLook(const PreviewScene& scene, const Vec3& origin)
    : m_checker(scene.checker)
{
    if (!scene.surface || !scene.surface->topology)
        return;
    const SurfaceMesh& mesh = *scene.surface;
    const SurfaceTopology& topology = *mesh.topology;
    if (mesh.positions.size() != topology.pattern.size() || mesh.normals.size() != topology.pattern.size())
        return;

    m_triangles = topology.triangles;
    m_normals = mesh.normals;
    m_seamNeighbours = seamNeighbours(topology);
    for (const Vec3& p : mesh.positions)
        m_points.push_back((p - origin).cast<float>());
    const double square = scene.checkerSize > 0 ? scene.checkerSize : 20;
    for (const Vec2& p : topology.pattern)
        m_pattern.push_back((p / square).cast<float>());

    if (scene.vertexColors.size() == topology.pattern.size())
        for (const auto& [r, g, b, a] : scene.vertexColors)
            m_mapColors.push_back(Eigen::Vector4f(r, g, b, a) / 255);

    m_patchOfTriangle.assign(m_triangles.size(), 0);
    for (const SurfaceTopology::PatchRange& range : topology.patches) {
        const auto look = std::find_if(scene.looks.begin(), scene.looks.end(),
                                       [&](const auto& one) { return one.patch == range.patch; });
        const Vec3f color = linearColor(look != scene.looks.end() ? look->color : PreviewScene::PatchLook{}.color);
        const std::size_t end =
            std::min<std::size_t>(m_triangles.size(), range.firstTriangle + range.triangleCount);
        for (std::size_t t = range.firstTriangle; t < end; ++t)
            m_patchOfTriangle[t] = static_cast<std::uint16_t>(m_tones.size());
        m_tones.push_back({(1.6f * color.array() + 0.03f).min(1.f), 0.85f * color});
    }
    if (m_tones.empty())
        m_tones.push_back({Vec3f::Constant(0.5f), Vec3f::Constant(0.4f)});
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
    point.shadowOrigin = liftedOrigin(point, corners, normals, weights);

    point.color = outsideColor(hit, direction, pixel);
    point.gloss = outside ? 0.09f : 0.f;
    if (!outside) { // the lining: the cover's colour, but greyed
        const float grey = point.color.dot(Vec3f(0.2126f, 0.7152f, 0.0722f));
        point.color = 0.25f * point.color + Vec3f::Constant(0.12f + 0.35f * grey);
    } else {
        pressSeam(hit, pixel.right.norm(), point);
    }
    return point;
}

Vec3f CoverLook::outsideColor(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const
{
    const Tone& tone = m_tones[m_patchOfTriangle[hit.triangle]];
    const float light = m_checker ? checker(hit, direction, pixel) : 0;
    const Vec3f cloth = tone.dark + light * (tone.light - tone.dark);
    if (m_mapColors.empty())
        return cloth;
    const Eigen::Vector4f map = mixed(m_mapColors, m_triangles[hit.triangle], hit);
    return (1 - map.w()) * cloth + map.w() * Vec3f(map.head<3>().array().pow(2.2f));
}

/// The share of light squares under the pixel: the checker integrated over the pixel's bounding box in the
/// outline's coordinates, so it neither flickers nor needs mip-maps.
float CoverLook::checker(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const
{
    const std::array<std::uint32_t, 3>& ids = m_triangles[hit.triangle];
    const Vec3f e1 = m_points[ids[1]] - m_points[ids[0]], e2 = m_points[ids[2]] - m_points[ids[0]];
    const Eigen::Vector2f d1 = m_pattern[ids[1]] - m_pattern[ids[0]], d2 = m_pattern[ids[2]] - m_pattern[ids[0]];
    const Vec3f across = e1.cross(e2);
    const float area2 = across.squaredNorm();
    if (!(area2 > 0))
        return 0.5f;
    const Vec3f toE1 = e2.cross(across) / area2, toE2 = across.cross(e1) / area2; // dual to e1, e2
    const float facing = direction.dot(hit.normal);
    const auto onSurface = [&](const Vec3f& step) { // where the neighbouring pixel's ray meets the plane
        return Vec3f(step - direction * (step.dot(hit.normal) / (std::abs(facing) > 0.05f ? facing : 0.05f)));
    };
    const auto inPattern = [&](const Vec3f& step) {
        return Eigen::Vector2f(toE1.dot(step) * d1 + toE2.dot(step) * d2);
    };
    const Eigen::Vector2f width =
        inPattern(onSurface(pixel.right)).cwiseAbs() + inPattern(onSurface(pixel.up)).cwiseAbs();
    const Eigen::Vector2f at = mixed(m_pattern, ids, hit);
    if (!at.allFinite() || !width.allFinite())
        return 0.5f;
    return 0.5f + 0.5f * squareWave(at.x(), width.x()) * squareWave(at.y(), width.y());
}

/// The thread pulls the cover in: the normal leans towards the seam, and a dark line remains.
void CoverLook::pressSeam(const RayHit& hit, float pixelSize, SurfacePoint& point) const
{
    float nearest2 = seamReach * seamReach;
    Vec3f towards = Vec3f::Zero();
    for (const std::uint32_t corner : m_triangles[hit.triangle])
        for (const std::uint32_t neighbour : m_seamNeighbours[corner]) {
            if (neighbour == none)
                continue;
            const Vec3f away =
                nearestOnSegment(point.position, m_points[corner], m_points[neighbour]) - point.position;
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
    point.gloss *= 1.f - line;
}

} // namespace bolster
