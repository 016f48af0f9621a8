#include "HitFrame.h"

#include <cmath>

namespace bolster {

std::optional<TriangleFrame> TriangleFrame::of(const std::array<Vec3f, 3>& corners, const RayHit& hit,
                                               const Vec3f& direction, const Footprint& pixel)
{
    const Vec3f e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const Vec3f across = e1.cross(e2);
    const float area2 = across.squaredNorm(), facing = direction.dot(hit.normal);
    const auto onSurface = [&](const Vec3f& step) { // where the neighbouring pixel's ray meets the plane
        return Vec3f(step - direction * (step.dot(hit.normal) / (std::abs(facing) > 0.05f ? facing : 0.05f)));
    };
    const TriangleFrame frame{e1,
                              e2,
                              e2.cross(across) / area2, // dual to the edges
                              across.cross(e1) / area2,
                              onSurface(pixel.right),
                              onSurface(pixel.up)};
    const bool finite = area2 > 0 && frame.toSecond.allFinite() && frame.toThird.allFinite() &&
                        frame.right.allFinite() && frame.up.allFinite();
    return finite ? std::optional(frame) : std::nullopt;
}

std::optional<ClothFrame> ClothFrame::of(const TriangleFrame& triangle,
                                         const std::array<Eigen::Vector2f, 3>& coordinates, const RayHit& hit)
{
    const Eigen::Vector2f d1 = coordinates[1] - coordinates[0], d2 = coordinates[2] - coordinates[0];
    const float turned = d1.x() * d2.y() - d1.y() * d2.x();
    if (turned == 0)
        return std::nullopt;
    const auto inCloth = [&](const Vec3f& step) {
        return Eigen::Vector2f(triangle.toSecond.dot(step) * d1 + triangle.toThird.dot(step) * d2);
    };
    const ClothFrame frame{coordinates[0] + hit.u * d1 + hit.v * d2, inCloth(triangle.right), inCloth(triangle.up),
                           ((d2.y() * triangle.second - d1.y() * triangle.third) / turned).normalized(),
                           ((d1.x() * triangle.third - d2.x() * triangle.second) / turned).normalized()};
    const bool finite = frame.at.allFinite() && frame.right.allFinite() && frame.up.allFinite() &&
                        frame.x.allFinite() && frame.y.allFinite();
    return finite ? std::optional(frame) : std::nullopt;
}

} // namespace bolster
