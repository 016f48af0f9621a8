// The signs that are drawn on outlines. Paths and points are pixels.
#pragma once

#include <QColor>
#include <QPainterPath>
#include <QRectF>

#include <vector>

class QPainter;

namespace bolster {

/// Short strokes on the outer side, as engineers draw what is held. `counterClockwise`: of the outline in the
/// layout.
void paintFixationMarks(QPainter& painter, const QPainterPath& stretch, bool counterClockwise, const QColor& color,
                        bool strong);
/// An arrow on the inner side that says which way the seam runs, with a letter behind it.
struct SeamArrow {
    QPainterPath stretch;      ///< as the seam walks it
    bool leftIsInside = false; ///< the patch lies to the left of it (in the layout, where y points up)
    bool strong = false;
    QString label = {}; ///< left out where the stretch is hardly longer
};
/// Keeps off what is `taken`, to which it is added; short stretches have no arrow. Where there is no room for the
/// letter there is only the arrow. Around both, empty where there is neither.
QRectF paintSeamArrow(QPainter& painter, const SeamArrow& arrow, const QColor& color, std::vector<QRectF>& taken);
/// Thin lines that join both stretches of a seam where they are sewn together.
void paintSeamLink(QPainter& painter, const QPainterPath& a, const QPainterPath& b, const QColor& color);
/// A fancy seam of this width: its outer lines, and stitches in the middle.
void paintFancyStrip(QPainter& painter, const QPainterPath& middle, double width, const QColor& color, bool strong);
/// Along the middle of a line, `gap` pixels beside it, where the line is much longer than its name; if `wanted`
/// also where it is hardly longer.
void paintLineName(QPainter& painter, const QPainterPath& line, const QString& name, double gap,
                   const QColor& color, bool wanted);
/// A double arrow along the warp.
void paintGrainArrow(QPainter& painter, QPointF centre, QPointF half, const QColor& color);

} // namespace bolster
