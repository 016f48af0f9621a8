// A stretch of an outline under the pointer, for tools that work on one.
#pragma once

#include "PatternTool.h"
#include "Stretch.h"

#include <optional>

class QColor;
class QPainter;

namespace bolster {

/// What is selected if the pointer is on it, else the seam or fixed stretch there, else the edge between two
/// corners.
std::optional<Stretch> stretchUnder(PatternToolContext& context, QPointF pixel);
/// A bold line with its ends.
void paintStretch(QPainter& painter, const PatternToolContext& context, const Stretch& stretch,
                  const QColor& color);
/// The same on an outline that need not be the shown one.
void paintStretch(QPainter& painter, const PatternToolContext& context, const Patch& on, const Stretch& stretch,
                  const QColor& color);
/// Its length beside the middle of it, outside the patch.
void paintEdgeLength(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     const Stretch& stretch);
void paintEdgeLength(QPainter& painter, const ViewColors& colors, const PatternToolContext& context,
                     const Patch& patch, const Stretch& stretch);

/// In a small frame, from a place (pixels) in this direction; `out` need not be of length 1.
void paintLengthBeside(QPainter& painter, const ViewColors& colors, QPointF on, QPointF out, const QString& text);

} // namespace bolster
