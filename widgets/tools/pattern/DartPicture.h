// A dart as it is drawn while it is made or dragged: the wedge, how long its legs are, what makes both equal.
#pragma once

#include "DartEdits.h"
#include "PatternTool.h"

#include <QStringList>

namespace bolster {

/// Whether the legs are equally long, as far as anybody could sew.
bool hasEqualLegs(const Patch& patch, const edits::DartShape& dart);
/// The tip on the axis of the mouth if it is near to it (pixels), or always; with whole millimetres of depth.
Vec2 snappedTip(const PatternToolContext& context, const Patch& patch, const edits::DartShape& dart,
                bool always = false);
/// "Mouth 20 mm", "Depth 60 mm", "Equal legs".
QStringList dartFigures(const Patch& patch, const edits::DartShape& dart);

/// `good`: it can be cut so.
void paintDart(QPainter& painter, const ViewColors& colors, const PatternToolContext& context, const Patch& patch,
               const edits::DartShape& dart, bool good);

} // namespace bolster
