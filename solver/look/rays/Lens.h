// Rays of a view through the pixels of a picture.
#pragma once

#include "CoverHits.h"

namespace bolster {

/// In the scene's coordinates: `origin` is subtracted from all points.
class Lens {
public:
    struct Ray {
        Vec3f origin, direction; ///< unit
    };

    Lens(const RayCamera& view, int width, int height, const Vec3& origin);

    /// In pixels, from the left and from the top.
    Ray through(float x, float y) const;
    /// Along the view direction, from the eye, mm.
    float depth(const Vec3f& point) const { return (m_eye - point).dot(m_backward); }
    /// mm per pixel there.
    float pixelSize(const Vec3f& at) const;
    Footprint footprint(const Vec3f& at, float pixels) const;

private:
    float m_centerX, m_centerY;
    bool m_perspective;
    Vec3f m_eye, m_right, m_up, m_backward;
    float m_distance;
    float m_step; ///< of a pixel at distance 1
};

} // namespace bolster
