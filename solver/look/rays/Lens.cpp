#include "Lens.h"

#include <algorithm>
#include <cmath>

namespace bolster {

Lens::Lens(const RayCamera& view, int width, int height, const Vec3& origin)
    : m_centerX(0.5f * static_cast<float>(width))
    , m_centerY(0.5f * static_cast<float>(height))
    , m_perspective(view.perspective)
    , m_eye((view.eye() - origin).cast<float>())
    , m_distance(static_cast<float>(view.distance))
    , m_step(static_cast<float>(2 * std::tan(view.fieldOfView / 2) / height))
{
    const Vec3 backward = (view.eye() - view.target).normalized();
    const Vec3 right(std::cos(view.azimuth), std::sin(view.azimuth), 0);
    m_right = right.cast<float>();
    m_up = backward.cross(right).cast<float>();
    m_backward = backward.cast<float>();
}

Lens::Ray Lens::through(float x, float y) const
{
    const Vec3f across = m_step * ((x - m_centerX) * m_right + (m_centerY - y) * m_up);
    if (m_perspective)
        return {m_eye, (across - m_backward).normalized()};
    // Parallel rays start far behind the eye, which may stand inside the scene.
    return {m_eye + m_distance * (across + 10.f * m_backward), -m_backward};
}

float Lens::pixelSize(const Vec3f& at) const
{
    return m_step * (m_perspective ? std::max(depth(at), 1e-3f) : m_distance);
}

Footprint Lens::footprint(const Vec3f& at, float pixels) const
{
    const float size = pixels * pixelSize(at);
    return {size * m_right, size * m_up};
}

} // namespace bolster
