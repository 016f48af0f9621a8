#include "StudioLight.h"

#include "Shading.h"

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr float keySpread = 0.16f; ///< tangent of half the angle under which the key light appears

Vec3f horizontalDirection(double azimuth, double elevation)
{
    return Vec3(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                std::sin(elevation))
        .cast<float>();
}

} // namespace

StudioLight::StudioLight(const RayCamera& view)
    : m_key(horizontalDirection(view.azimuth + shading::keyAzimuth, shading::keyElevation))
    , m_rim(horizontalDirection(view.azimuth + shading::rimAzimuth, shading::rimElevation))
{
    m_keyRight = m_key.cross(Vec3f::UnitZ()).normalized();
    m_keyUp = m_keyRight.cross(m_key);
}

Shade StudioLight::shade(const ShadedPoint& point, const Vec3f& toEye) const
{
    const shading::Studio studio{m_key.array(), m_rim.array(), shading::vec3(0, 0, 1)};
    const shading::Shade shade = shading::shaded(point.cloth(), point.normal.array(), toEye.array(), studio);
    return {shade.direct.matrix(), shade.ambient.matrix()};
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
