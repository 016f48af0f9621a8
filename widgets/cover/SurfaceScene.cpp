#include "SurfaceScene.h"

#include <algorithm>

namespace bolster {

QColor SurfaceScene::PointsLook::colorOf(std::size_t point) const
{
    if (!own)
        return color;
    QColor shade = QColor::fromRgb((*own)[point]);
    shade.setAlphaF(color.alphaF());
    return shade;
}

const SurfaceScene::PatchLook* SurfaceScene::look(ElementId patch) const
{
    const auto found = std::find_if(patches.begin(), patches.end(),
                                    [patch](const PatchLook& look) { return look.patch == patch; });
    return found != patches.end() ? &*found : nullptr;
}

QColor SurfaceScene::backgroundTop() const
{
    return colors.dark ? QColor(0x43, 0x48, 0x50) : QColor(0xd8, 0xdd, 0xe3);
}

QColor SurfaceScene::backgroundBottom() const
{
    return colors.dark ? QColor(0x26, 0x29, 0x2e) : QColor(0xf6, 0xf7, 0xf8);
}

std::vector<Vec3> placedPoints(const SurfaceScene::FrameLook& frame)
{
    std::vector<Vec3> points;
    if (frame.mesh)
        for (const Vec3& p : frame.mesh->points)
            points.push_back(frame.placement.placed(p));
    return points;
}

} // namespace bolster
