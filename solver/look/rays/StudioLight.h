// Where the lights of the studio stand (studio.glsl says what they do), and rays that look for what shades them.
#pragma once

#include "CoverHits.h"

namespace bolster {

/// The light that a place sends to the eye, by where it comes from, so that shadows can be put in afterwards.
struct Shade {
    Vec3f direct = Vec3f::Zero();  ///< from the key light
    Vec3f ambient = Vec3f::Zero(); ///< from all around
};

class StudioLight {
public:
    /// The key light stands to the right of this viewer: what he looks at is lit.
    explicit StudioLight(const RayCamera& view);

    /// `toEye` is unit.
    Shade shade(const ShadedPoint& point, const Vec3f& toEye) const;
    /// A direction to the key light, unit; `u`, `v` in [0, 1) choose a place on it.
    Vec3f towardsKey(float u, float v) const;

private:
    Vec3f m_key, m_keyRight, m_keyUp;
    Vec3f m_rim;
};

/// A direction on the side of `normal`, more often along it (cosine); `u`, `v` in [0, 1).
Vec3f towardsSky(const Vec3f& normal, float u, float v);

} // namespace bolster
