// Where in the layout a new patch lies on no other one.
#pragma once

#include "PatternScene.h"

#include <QStringList>

namespace bolster {

/// The names of the patches that a shape (layout mm) would lie on; touching is not lying on.
QStringList patchesUnder(const PatternScene& scene, const Box2& shape);

/// The opposite corner of a box of this size (mm, positive) that begins at `corner`: to the upper right, or where
/// else no patch lies. Nothing when all four ways are taken.
std::optional<Vec2> freeQuadrant(const PatternScene& scene, const Vec2& corner, const Vec2& size);
/// The free box of this size nearest to `at`, with some room around.
Box2 freeBox(const PatternScene& scene, const Vec2& at, const Vec2& size);

} // namespace bolster
