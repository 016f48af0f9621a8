// The light of the studio and how surfaces answer to it, for C++: studio.glsl,
// materials.glsl and seams.glsl, which OpenGL's shaders read, too.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

/// The part of GLSL that these files are written in. Vectors are multiplied
/// component by component, as there.
namespace bolster::shading {

using vec3 = Eigen::Array3f;

using std::abs;
using std::clamp;
using std::exp;
using std::exp2;
using std::floor;
using std::hypot;
using std::max;
using std::min;
using std::pow;
using std::sin;

inline float dot(const vec3& a, const vec3& b)
{
    return a.matrix().dot(b.matrix());
}

inline vec3 min(const vec3& a, const vec3& b)
{
    return a.min(b);
}

inline vec3 normalize(const vec3& a)
{
    return a.matrix().normalized().array();
}

inline float fract(float x)
{
    return x - floor(x);
}

inline float smoothstep(float from, float to, float x)
{
    const float t = clamp((x - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

#define SHARED inline
#include "studio.glsl"

#include "materials.glsl"
#include "seams.glsl"
#undef SHARED

} // namespace bolster::shading
