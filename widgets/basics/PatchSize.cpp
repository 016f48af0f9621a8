#include "PatchSize.h"

#include <cmath>
#include <numbers>

namespace bolster {

int widthAxis(const Patch& patch)
{
    const double angle = patch.rotation * std::numbers::pi / 180;
    return std::abs(std::sin(angle)) > std::abs(std::cos(angle)) + 1e-9 ? 1 : 0;
}

Vec2 patchSize(const Patch& patch)
{
    const Vec2 size = patch.outline.boundingBox().sizes();
    return widthAxis(patch) == 0 ? size : Vec2(size.reverse());
}

} // namespace bolster
