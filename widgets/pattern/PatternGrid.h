// What lies behind the pattern: a grid that follows the zoom, and a scale bar.
#pragma once

#include "PatternTransform.h"
#include "ViewColors.h"

#include <QRectF>
#include <QString>

class QPainter;
class QSize;

namespace bolster {

/// Spacing of the finer lines, mm: a power of ten that is at least `leastPixels` wide.
double gridStep(double pixelsPerMillimetre, double leastPixels = 9);
void paintGrid(QPainter& painter, const PatternTransform& transform, const QSize& size, const ViewColors& colors);

/// A round length (1, 2 or 5 times a power of ten, mm) that is at most `mostPixels` wide.
double scaleBarLength(double pixelsPerMillimetre, double mostPixels = 130);
inline constexpr int scaleBarRoom = 40; ///< pixels at the bottom of the view
/// With what is written on it, in a view of this size.
QRectF scaleBarPlace(const PatternTransform& transform, const QSize& size);
void paintScaleBar(QPainter& painter, const PatternTransform& transform, const QSize& size,
                   const ViewColors& colors);

} // namespace bolster
