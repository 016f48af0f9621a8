// How what is known at a triangle's corners changes around a hit, and how much of it a pixel covers.
#pragma once

#include "RayScene.h"

#include <span>

namespace bolster {

/// The size of a pixel at a hit: what one step to the right or up in the picture moves there, mm.
struct Footprint {
    Vec3f right = Vec3f::Zero();
    Vec3f up = Vec3f::Zero();
};

struct TriangleFrame {
    Vec3f second, third;     ///< edges from the first corner, mm
    Vec3f toSecond, toThird; ///< what the shares of the corners gain with a step, per mm
    Vec3f right, up;         ///< of the pixel, on the triangle's plane, mm

    /// Nothing where the triangle is none. `direction` of the ray, unit.
    static std::optional<TriangleFrame> of(const std::array<Vec3f, 3>& corners, const RayHit& hit,
                                           const Vec3f& direction, const Footprint& pixel);
};

/// How flat coordinates lie on a triangle.
struct ClothFrame {
    Eigen::Vector2f at, right, up; ///< mm; what the pixel covers
    Vec3f x, y;                    ///< what the coordinates' directions are on the surface, unit

    /// `coordinates` of the corners, mm. Nothing where they are on one line.
    static std::optional<ClothFrame> of(const TriangleFrame& triangle,
                                        const std::array<Eigen::Vector2f, 3>& coordinates, const RayHit& hit);
};

} // namespace bolster
