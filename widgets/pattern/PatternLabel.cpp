#include "PatternLabel.h"

#include "PatternMarks.h"
#include "Units.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Pixels that stay free between text and outline, where seams have their colour.
constexpr double marginAlong = 10;
constexpr double marginAcross = 5;

} // namespace

PatternLabel::PatternLabel(const PatternPatch& patch, const PatternTransform& transform, const QFont& font)
    : m_nameFont(font)
    , m_sizeFont(font)
{
    const QFontMetricsF sizeMetrics(m_sizeFont);
    const double scale = transform.scale();
    const auto place = [&](const QSizeF& pixels) {
        return patch.label().place(QSizeF(pixels.width() + 2 * marginAlong, pixels.height() + 2 * marginAcross) /
                                   scale);
    };

    const QSizeF nameSize = setName(patch, transform);
    const auto spot = empty() ? std::nullopt : place(nameSize);
    if (!spot) {
        m_name.clear();
        return;
    }
    m_angle = spot->angle;
    m_centre = transform.toPixels(spot->centre);

    const Vec2 size = patch.box.sizes();
    const QString sizeLine = sizeText(size.x(), size.y());
    const QSizeF both(std::max(nameSize.width(), sizeMetrics.horizontalAdvance(sizeLine)),
                      nameSize.height() + sizeMetrics.height());
    const auto roomy = place(both);
    if (!roomy || roomy->angle != m_angle)
        return;
    m_size = sizeLine;
    m_extent = both;
    m_centre = transform.toPixels(roomy->centre);

    const double below = both.height() / 2;
    const double length = std::min(0.55 * (roomy->room * scale - below), 44.0);
    if (m_angle != 0 || length < 16)
        return;
    m_grainCentre = m_centre + QPointF(0, below + 10 + length / 2);
    // Degrees counter-clockwise in the layout; pixels run downwards.
    const double angle = -(patch.patch().grain + patch.patch().rotation) * M_PI / 180;
    m_grainHalf = QPointF(std::cos(angle), std::sin(angle)) * length / 2;
}

PatternLabel::PatternLabel(const PatternPatch& patch, const PatternTransform& transform, const QFont& font,
                           const QPointF& centre, double angle)
    : m_nameFont(font)
    , m_sizeFont(font)
    , m_centre(centre)
    , m_angle(angle)
{
    setName(patch, transform);
}

/// Returns the size of the name, pixels; there is none where it is longer than the patch.
QSizeF PatternLabel::setName(const PatternPatch& patch, const PatternTransform& transform)
{
    m_nameFont.setWeight(QFont::DemiBold);
    const QFontMetricsF metrics(m_nameFont);
    m_name = QString::fromStdString(patch.patch().name);
    m_extent = {metrics.horizontalAdvance(m_name), metrics.height()};
    if (m_extent.width() > patch.box.diagonal().norm() * transform.scale())
        m_name.clear();
    return m_extent;
}

QPolygonF PatternLabel::frame() const
{
    if (empty())
        return {};
    QTransform turn;
    turn.translate(m_centre.x(), m_centre.y()).rotateRadians(-m_angle); // pixels run downwards
    return turn.map(QPolygonF(QRectF(QPointF(-m_extent.width(), -m_extent.height()) / 2, m_extent)));
}

/// With a rim where the ground may have any colour.
void PatternLabel::write(QPainter& painter, const QFont& font, double top, const QString& text, const QColor& ink,
                         const QColor& rim)
{
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    if (rim.isValid()) {
        QPainterPath letters;
        letters.addText(-metrics.horizontalAdvance(text) / 2, top + metrics.ascent(), font, text);
        QColor soft = rim;
        soft.setAlphaF(0.85F);
        painter.strokePath(letters, QPen(soft, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
    painter.setPen(ink);
    painter.drawText(QRectF(-500, top, 1000, metrics.height()), Qt::AlignCenter, text);
}

void PatternLabel::paint(QPainter& painter, const Colors& colors, bool grain) const
{
    if (empty())
        return;
    painter.save();
    painter.translate(m_centre);
    painter.rotate(-m_angle * 180 / M_PI);
    const double line = QFontMetricsF(m_nameFont).height();
    const double top = -m_extent.height() / 2;
    write(painter, m_nameFont, top, m_name, colors.name, colors.rim);
    if (!m_size.isEmpty())
        write(painter, m_sizeFont, top + line, m_size, colors.rest, colors.rim);
    painter.restore();
    if (grain && !m_grainHalf.isNull())
        paintGrainArrow(painter, m_grainCentre, m_grainHalf, colors.rest);
}

} // namespace bolster
