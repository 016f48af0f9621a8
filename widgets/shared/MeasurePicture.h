// A measurement as both views draw it.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

class QPainter;

namespace bolster {

/// Pixels.
struct MeasurePicture {
    QPointF from;
    QPointF to;
    QString text; ///< its length; without one the line only joins what belongs together
    bool strong = false;
};

/// A line with its ends marked, and the text on it where there is room for both.
void paintMeasure(QPainter& painter, const MeasurePicture& picture, const QColor& color, const QColor& ground);

} // namespace bolster
