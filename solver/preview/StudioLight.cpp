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
const Vec3f rimColor(0.20f, 0.22f, 0.26f);

Vec3f horizontalDirection(double azimuth, double elevation)
{
    return Vec3(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                std::sin(elevation))
        .cast<float>();
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
    const float facing = std::max(0.f, n.dot(m_key));
    const float up = 0.5f + 0.5f * n.z();
    const float facingRim = std::max(0.f, n.dot(m_rim));
    const float grazing = std::pow(1.f - std::clamp(n.dot(toEye), 0.f, 1.f), 4.f);
    const float highlight = std::pow(std::max(0.f, n.dot((m_key + toEye).normalized())), 28.f);

    Shade shade;
    shade.direct = (point.color * facing + Vec3f::Constant(point.gloss * highlight)).cwiseProduct(keyColor);
    shade.ambient =
        point.color.cwiseProduct(up * skyColor + (1.f - up) * floorColor) +
        (point.color * facingRim + Vec3f::Constant(point.gloss * 3.f * grazing * up)).cwiseProduct(rimColor);
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
