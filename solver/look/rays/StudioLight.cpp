#include "StudioLight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr float keySpread = 0.16f; ///< tangent of half the angle under which the key light appears
const Vec3f keyColor(1.02f, 0.98f, 0.92f);
const Vec3f skyColor(0.50f, 0.52f, 0.56f);
const Vec3f floorColor(0.25f, 0.235f, 0.22f);
const Vec3f rimColor(0.30f, 0.32f, 0.37f);
const Vec3f lampColor(1.3f, 1.28f, 1.24f); ///< what hangs above shines in what is smooth
constexpr float keySize = 0.14f;           ///< what the soft box adds to a highlight's width (alpha of GGX)
constexpr float rimSize = 0.12f;

Vec3f horizontalDirection(double azimuth, double elevation)
{
    return Vec3(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                std::sin(elevation))
        .cast<float>();
}

/// Light from an area goes a little round the edge.
float wrappedLight(float cosine, float by)
{
    return std::max(0.f, cosine + by) / ((1 + by) * (1 + by));
}

/// GGX for an area light by a wider lobe (B. Karis, "Real shading in Unreal Engine 4", 2013), with the visibility
/// term of the same course.
float highlight(const SurfacePoint& point, const Vec3f& light, const Vec3f& toEye, float lightSize)
{
    const Vec3f h = (light + toEye).normalized();
    const float alpha = std::min(1.f, point.roughness * point.roughness + lightSize);
    const float nh = std::max(0.f, point.normal.dot(h)), lh = std::max(0.f, light.dot(h));
    const float a2 = alpha * alpha, d = nh * nh * (a2 - 1) + 1;
    return point.specular * std::max(0.f, point.normal.dot(light)) * a2 /
           (d * d * std::max(0.1f, lh * lh) * (4 * point.roughness + 2));
}

float smoothstep(float from, float to, float x)
{
    const float t = std::clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

/// The room in the mirror: sky over floor, and the lamp, blurred, times what GGX reflects of it (Karis' fit).
Vec3f mirrored(const SurfacePoint& point, const Vec3f& toEye, float facing)
{
    const float rough = point.roughness, blur = 0.15f + 0.85f * rough;
    const float up = 2 * point.normal.dot(toEye) * point.normal.z() - toEye.z();
    const Vec3f room = floorColor + smoothstep(-blur, blur, up) * (skyColor - floorColor) +
                       smoothstep(0.6f - blur, 0.6f + blur, up) * lampColor;
    const Eigen::Vector4f r =
        rough * Eigen::Vector4f(-1, -0.0275f, -0.572f, 0.022f) + Eigen::Vector4f(1, 0.0425f, 1.04f, -0.04f);
    const float a = std::min(r.x() * r.x(), std::exp2(-9.28f * facing)) * r.x() + r.y();
    return room * std::max(0.f, point.specular * (-1.04f * a + r.z()) + 1.04f * a + r.w()) * (point.specular > 0);
}

} // namespace

StudioLight::StudioLight(const PreviewView& view)
    : m_key(horizontalDirection(view.azimuth + 0.55, 0.8))
    , m_rim(horizontalDirection(view.azimuth - 2.2, 0.5))
{
    m_keyRight = m_key.cross(Vec3f::UnitZ()).normalized();
    m_keyUp = m_keyRight.cross(m_key);
}

Shade StudioLight::shade(const SurfacePoint& point, const Vec3f& toEye) const
{
    const Vec3f& n = point.normal;
    const float facing = std::clamp(n.dot(toEye), 0.03f, 1.f);
    const float key = n.dot(m_key), rim = n.dot(m_rim);
    const Vec3f sky = floorColor + (0.5f + 0.5f * n.z()) * (skyColor - floorColor);
    const Vec3f fuzz = point.sheen * std::pow(1.f - facing, 3.f) * (0.75f * point.color + Vec3f::Constant(0.25f));

    Shade shade;
    shade.direct = (point.color * wrappedLight(key, 0.15f) + fuzz * wrappedLight(key, 0.5f) +
                    Vec3f::Constant(highlight(point, m_key, toEye, keySize)))
                       .cwiseProduct(keyColor);
    shade.ambient = (point.color + fuzz).cwiseProduct(sky) + mirrored(point, toEye, facing) +
                    (point.color * wrappedLight(rim, 0.1f) + fuzz * wrappedLight(rim, 0.5f) +
                     Vec3f::Constant(6.f * highlight(point, m_rim, toEye, rimSize)))
                        .cwiseProduct(rimColor);
    return shade;
}

Vec3f StudioLight::towardsKey(float u, float v) const
{
    const float radius = keySpread * std::sqrt(u), angle = 2.f * std::numbers::pi_v<float> * v;
    return (m_key + radius * (std::cos(angle) * m_keyRight + std::sin(angle) * m_keyUp)).normalized();
}

Vec3f towardsSky(const Vec3f& normal, float u, float v)
{
    const float radius = std::sqrt(u), angle = 2.f * std::numbers::pi_v<float> * v;
    const Vec3f right = normal.unitOrthogonal();
    return radius * std::cos(angle) * right + radius * std::sin(angle) * normal.cross(right) +
           std::sqrt(std::max(0.f, 1.f - u)) * normal;
}

} // namespace bolster
