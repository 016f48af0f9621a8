#include "MeasurePicture.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>

namespace bolster {

namespace {

// Pixels.
constexpr double tick = 5;    // to each side of an end
constexpr double padding = 3; // around the text

constexpr double textAt = 0.3; // of the line: names of patches are in their middles

} // namespace

void paintMeasure(QPainter& painter, const MeasurePicture& picture, const QColor& color, const QColor& ground)
{
    const QLineF line(picture.from, picture.to);
    const QLineF across = line.normalVector().unitVector();
    const QPointF side = tick * (across.p2() - across.p1());
    const auto stroke = [&](const QColor& with, double width) {
        QPen pen(with, width, Qt::SolidLine, Qt::FlatCap);
        painter.setPen(pen);
        for (const QPointF& end : {picture.from, picture.to})
            painter.drawLine(end - side, end + side);
        if (picture.text.isEmpty())
            pen.setDashPattern({4, 4});
        painter.setPen(pen);
        painter.drawLine(line);
    };
    QColor halo = ground;
    halo.setAlphaF(0.75F);
    stroke(halo, 4.5);
    stroke(color, picture.strong ? 2.2 : 1.3);

    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(picture.text) + 2 * padding, metrics.height());
    if (picture.text.isEmpty() || (line.length() < size.width() && !picture.strong))
        return;
    QRectF box(QPointF(), size);
    box.moveCenter(line.pointAt(textAt));
    halo.setAlphaF(0.9F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(halo);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(color);
    painter.drawText(box, Qt::AlignCenter, picture.text);
}

} // namespace bolster
