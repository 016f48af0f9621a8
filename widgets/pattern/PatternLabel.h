// What is written inside a patch, as far as there is room.
#pragma once

#include "PatternScene.h"
#include "PatternTransform.h"

#include <QFont>
#include <QPolygonF>
#include <QRectF>

class QPainter;

namespace bolster {

struct ViewColors;

/// Name, size and grain, laid out for one zoom.
class PatternLabel {
public:
    /// An empty one where there is no room even for the name.
    PatternLabel(const PatternPatch& patch, const PatternTransform& transform, const QFont& font);
    /// The name alone, at a place (pixels) and an angle (radians, counter-clockwise) that somebody chose; empty
    /// where it is longer than the patch.
    PatternLabel(const PatternPatch& patch, const PatternTransform& transform, const QFont& font,
                 const QPointF& centre, double angle);

    bool empty() const { return m_name.isEmpty(); }
    /// Around the text, in pixels; empty when nothing is written.
    QRectF box() const { return frame().boundingRect(); }
    /// The same, turned as the text is.
    QPolygonF frame() const;

    struct Colors {
        QColor name;
        QColor rest; ///< of size and grain
        QColor rim;  ///< around the letters, where the ground may have any colour; not valid: none
    };
    /// `grain`: with the little arrow along the grain.
    void paint(QPainter& painter, const Colors& colors, bool grain) const;

private:
    QSizeF setName(const PatternPatch& patch, const PatternTransform& transform);
    static void write(QPainter& painter, const QFont& font, double top, const QString& text, const QColor& ink,
                      const QColor& rim);

    QString m_name;
    QString m_size; ///< "" without room for it
    QFont m_nameFont;
    QFont m_sizeFont;
    QPointF m_centre;
    QSizeF m_extent;    ///< of the text, along its lines first
    double m_angle = 0; ///< of the lines, radians counter-clockwise
    QPointF m_grainCentre;
    QPointF m_grainHalf; ///< zero without room for it
};

} // namespace bolster
