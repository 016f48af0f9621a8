#include "RayScene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace bolster {

namespace {

constexpr float farthestPoint = 1e8f; ///< mm: beyond, single precision says nothing any more

RTCRay makeRay(const Vec3f& origin, const Vec3f& direction, float reach)
{
    RTCRay ray{};
    ray.org_x = origin.x();
    ray.org_y = origin.y();
    ray.org_z = origin.z();
    ray.dir_x = direction.x();
    ray.dir_y = direction.y();
    ray.dir_z = direction.z();
    ray.tfar = reach;
    ray.mask = ~0u;
    return ray;
}

bool usable(std::span<const Vec3f> points, const std::array<std::uint32_t, 3>& triangle)
{
    for (const std::uint32_t corner : triangle)
        if (corner >= points.size() || !(points[corner].cwiseAbs().maxCoeff() < farthestPoint))
            return false;
    return true;
}

} // namespace

// Embree's builder splits its work by threads, and with it the order in which ties are found.
RayScene::RayScene()
    : m_device(rtcNewDevice("threads=1"))
    , m_scene(nullptr)
{
    if (!m_device)
        throw std::bad_alloc();
    m_scene = rtcNewScene(m_device);
    rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
}

RayScene::~RayScene()
{
    rtcReleaseScene(m_scene);
    rtcReleaseDevice(m_device);
}

void RayScene::cutOpen(const Vec3f& normal, float offset)
{
    m_section = Section{normal, offset};
}

bool RayScene::cutAway(std::span<const Vec3f> points, const std::array<std::uint32_t, 3>& triangle) const
{
    return m_section && std::ranges::all_of(triangle, [&](std::uint32_t corner) {
               return m_section->normal.dot(points[corner]) > m_section->offset;
           });
}

/// The part of the ray that runs on the kept side, in lengths of its direction.
RayScene::Span RayScene::kept(const Vec3f& origin, const Vec3f& direction) const
{
    constexpr float infinite = std::numeric_limits<float>::infinity();
    if (!m_section)
        return {0, infinite};
    const float height = m_section->offset - m_section->normal.dot(origin);
    const float climb = m_section->normal.dot(direction);
    if (std::abs(climb) < 1e-12f)
        return height >= 0 ? Span{0, infinite} : Span{0, 0};
    const float crossing = height / climb;
    if (climb > 0) // it leaves the kept side
        return {0, std::max(0.f, crossing)};
    return {std::max(0.f, crossing), infinite};
}

void RayScene::add(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles)
{
    std::vector<std::uint32_t> kept;
    kept.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (usable(points, triangles[i]) && !cutAway(points, triangles[i]))
            kept.push_back(static_cast<std::uint32_t>(i));

    const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!kept.empty()) {
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), points.size()));
        auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), kept.size()));
        if (!vertices || !corners)
            throw std::bad_alloc();
        for (const Vec3f& p : points)
            for (int axis = 0; axis < 3; ++axis)
                *vertices++ = std::isfinite(p[axis]) ? p[axis] : 0.f;
        for (const std::uint32_t i : kept)
            for (const std::uint32_t corner : triangles[i])
                *corners++ = corner;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(m_scene, geometry, static_cast<unsigned>(m_kept.size()));
    rtcReleaseGeometry(geometry);
    m_kept.push_back(std::move(kept));
}

void RayScene::commit()
{
    rtcCommitScene(m_scene);
}

std::optional<RayHit> RayScene::first(const Vec3f& origin, const Vec3f& direction) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    const Span span = kept(origin, direction);
    query.ray = makeRay(origin, direction, span.to);
    query.ray.tnear = span.from;
    if (!(span.from < span.to))
        return std::nullopt;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(m_scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    RayHit hit;
    hit.distance = query.ray.tfar;
    hit.mesh = query.hit.geomID;
    hit.triangle = m_kept[hit.mesh][query.hit.primID];
    hit.u = query.hit.u;
    hit.v = query.hit.v;
    hit.normal = Vec3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).normalized();
    return hit;
}

bool RayScene::blocked(const Vec3f& origin, const Vec3f& direction, float reach) const
{
    const Span span = kept(origin, direction);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = makeRay(origin, direction, std::min(reach, span.to));
    ray.tnear = span.from;
    if (!(ray.tnear <= ray.tfar))
        return false;
    rtcOccluded1(m_scene, &context, &ray);
    return ray.tfar < 0;
}

} // namespace bolster
