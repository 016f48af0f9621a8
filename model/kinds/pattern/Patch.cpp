#include "Patch.h"

#include <numbers>

namespace bolster {

namespace {

Eigen::Rotation2Dd layoutRotation(const Patch& patch)
{
    return Eigen::Rotation2Dd(patch.rotation * std::numbers::pi / 180);
}

} // namespace

Vec2 toLayout(const Patch& patch, const Vec2& outlinePoint)
{
    return layoutRotation(patch) * outlinePoint + patch.position;
}

Vec2 fromLayout(const Patch& patch, const Vec2& layoutPoint)
{
    return layoutRotation(patch).inverse() * (layoutPoint - patch.position);
}

} // namespace bolster
