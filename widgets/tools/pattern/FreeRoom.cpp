#include "FreeRoom.h"

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

constexpr double noTouch = 0.05;  // mm
constexpr double roomAround = 20; // mm

bool liesOn(const PatternPatch& patch, const Box2& shape)
{
    const Vec2 inset = Vec2::Constant(noTouch).cwiseMin(0.25 * shape.sizes());
    const Box2 inner(shape.min() + inset, shape.max() - inset);
    if (!inner.intersects(patch.box))
        return false;
    return patch.path.intersects(
        QRectF(QPointF(inner.min().x(), inner.min().y()), QPointF(inner.max().x(), inner.max().y())));
}

bool isFree(const PatternScene& scene, const Box2& shape)
{
    return std::ranges::none_of(scene.patches(), [&](const auto& entry) { return liesOn(entry.second, shape); });
}

} // namespace

QStringList patchesUnder(const PatternScene& scene, const Box2& shape)
{
    QStringList names;
    for (const auto& [id, patch] : scene.patches())
        if (liesOn(patch, shape))
            names += QString::fromStdString(patch.patch().name);
    return names;
}

std::optional<Vec2> freeQuadrant(const PatternScene& scene, const Vec2& corner, const Vec2& size)
{
    for (const Vec2& way : {Vec2(1, 1), Vec2(1, -1), Vec2(-1, 1), Vec2(-1, -1)}) {
        Box2 box(corner);
        box.extend(corner + size.cwiseProduct(way));
        if (isFree(scene, box))
            return corner + size.cwiseProduct(way);
    }
    return std::nullopt;
}

Box2 freeBox(const PatternScene& scene, const Vec2& at, const Vec2& size)
{
    // Somewhere beside or in a row with the edges of other patches; the far right is always free.
    std::vector<double> x{at.x(), at.x() - size.x()}, y{at.y(), at.y() - size.y()};
    for (const auto& [id, patch] : scene.patches()) {
        x.insert(x.end(), {patch.box.max().x() + roomAround, patch.box.min().x() - roomAround - size.x()});
        y.insert(y.end(), {patch.box.max().y() + roomAround, patch.box.min().y() - roomAround - size.y()});
    }
    Box2 best;
    double least = std::numeric_limits<double>::infinity();
    for (const double left : x)
        for (const double bottom : y) {
            const Box2 box(Vec2(left, bottom), Vec2(left, bottom) + size);
            const double away = (box.center() - at).norm();
            if (away < least && isFree(scene, box)) {
                least = away;
                best = box;
            }
        }
    return best;
}

} // namespace bolster
