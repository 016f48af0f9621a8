// What lies behind the pattern: a grid that follows the zoom, and a scale bar.
#pragma once

#include "PatternTransform.h"
#include "ViewColors.h"

#include <QRectF>
#include <QString>

class QPainter;
class QSize;

namespace bolster {

/// Spacing of the finer lines, mm, at least `leastPixels` wide: a power of ten, or 1/8, 1, 12 ... inches where
/// lengths are shown in those.
double gridStep(double pixelsPerMillimetre, double leastPixels = 9);
/// Of the coarser lines above these: ten times as far apart, or eight or twelve times.
double coarserGridStep(double step);
/// Of the labels along a ruler, mm, at least `leastPixels` apart, and into how many parts ticks divide it.
struct RulerStep {
    double length;
    int parts;
};
RulerStep rulerStep(double pixelsPerMillimetre, double leastPixels, double leastTick);
/// A round length in full, whatever parts of an inch are shown elsewhere; without and with its unit.
QString gridFigure(double length);
QString gridLengthText(double length);
void paintGrid(QPainter& painter, const PatternTransform& transform, const QSize& size, const ViewColors& colors);

/// A round length (1, 2 or 5 times a power of ten, mm; or a round number of inches) that is at most `mostPixels`
/// wide.
double scaleBarLength(double pixelsPerMillimetre, double mostPixels = 130);
inline constexpr int scaleBarRoom = 40; ///< pixels at the bottom of the view
/// With what is written on it, in a view of this size.
QRectF scaleBarPlace(const PatternTransform& transform, const QSize& size);
void paintScaleBar(QPainter& painter, const PatternTransform& transform, const QSize& size,
                   const ViewColors& colors);

} // namespace bolster
