// Draws why a point is where it is, and small notes at the pointer.
#pragma once

#include "Snapper.h"
#include "ViewColors.h"

#include <QStringList>

class QPainter;

namespace bolster {

/// Guide lines and a sign for each hint.
void paintSnapHints(QPainter& painter, const ViewColors& colors, const PatternTransform& transform,
                    const std::vector<SnapHint>& hints);
/// What the hints say in words: "Midpoint", "Perpendicular", "As long: 240 mm".
QString snapText(const std::vector<SnapHint>& hints);
/// Lines of text in a box beside a place (pixels), inside the painter's window; empty lines are left out.
void paintNote(QPainter& painter, const ViewColors& colors, QPointF beside, QStringList lines);

} // namespace bolster
