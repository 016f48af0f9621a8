#include "SewPicture.h"

#include "ArcLength.h"
#include "CurvePath.h"
#include "ElementText.h"
#include "Icons.h"
#include "PatternMarks.h"
#include "SeamColors.h"
#include "SeamEase.h"
#include "SeamEdits.h"
#include "SeamStretches.h"
#include "StretchLength.h"
#include "Units.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double lineWidth = 5;
constexpr double buttonDistance = 26;
constexpr double markRadius = 4.5;
constexpr QPointF figuresOffset(18, 20);

} // namespace

QPainterPath SewPicture::path(const Stretch& stretch, bool backwards) const
{
    const PatternPatch* patch = m_scene.patch(stretch.patch);
    if (!patch || patch->patch().outline.empty())
        return {};
    const BSpline2& outline = patch->patch().outline;
    const double to = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const auto place = [patch](const Vec2& p) { return toLayout(patch->patch(), p); };
    const QPainterPath pixels = m_transform.matrix().map(curvePath(outline, stretch.from, to, place));
    return backwards ? pixels.toReversed() : pixels;
}

bool SewPicture::leftIsInside(const Stretch& stretch, bool backwards) const
{
    const PatternPatch* patch = m_scene.patch(stretch.patch);
    return patch && (patch->patch().outline.signedArea() > 0) != backwards;
}

std::optional<QPointF> SewPicture::besideMiddle(const Stretch& stretch) const
{
    const PatternPatch* patch = m_scene.patch(stretch.patch);
    if (!patch || patch->patch().outline.empty())
        return std::nullopt;
    const BSpline2& outline = patch->patch().outline;
    const ArcLength2 length(outline);
    const double to = unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
    const double middle = length.parameterAt(0.5 * (length.at(stretch.from) + length.at(to)));
    const Vec2 at = toLayout(patch->patch(), outline.at(middle));
    const Vec2 along = toLayout(patch->patch(), outline.at(middle) + outline.derivative(middle)) - at;
    const double side = outline.signedArea() > 0 ? 1 : -1;
    const Vec2 inward = side * Vec2(-along.y(), along.x()) / std::max(along.norm(), 1e-9);
    return m_transform.toPixels(at) + buttonDistance * QPointF(inward.x(), -inward.y());
}

std::vector<Stretch> SewPicture::row() const
{
    std::vector<Stretch> row;
    if (!taken.empty())
        row.assign(taken.begin() + 1, taken.end());
    if (!taken.empty() && offer && !refused)
        row.push_back(*offer);
    return row;
}

void SewPicture::paintStretch(QPainter& painter, const Stretch& stretch, bool backwards, const QColor& color) const
{
    const QPainterPath line = path(stretch, backwards);
    painter.setBrush(Qt::NoBrush);
    painter.strokePath(line, QPen(color, lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    std::vector<QRectF> written;
    paintSeamArrow(painter, {line, leftIsInside(stretch, backwards), true}, color, written);
}

void SewPicture::paintSeams(QPainter& painter, const ViewColors& colors) const
{
    Message problem;
    const Edit edit = edits::sewInRow(design, taken.front(), row(), flipped, &problem);
    const auto shades = seamColors(design.with(edit), colors.dark);
    for (const Change& change : edit.changes) {
        const Seam& seam = std::get<Seam>(*change.after);
        const QColor color = shades.at(change.id);
        paintStretch(painter, seam.a, false, color);
        paintStretch(painter, seam.b, seam.reversed, color);
        paintSeamLink(painter, path(seam.a, false), path(seam.b, seam.reversed), color);
    }
}

void SewPicture::paintButton(QPainter& painter, const ViewColors& colors) const
{
    painter.setPen(QPen(buttonHovered ? colors.accent : colors.mutedLabel, 1.2));
    painter.setBrush(buttonHovered || flipped ? mixed(colors.canvas, colors.accent, 0.3) : colors.canvas);
    painter.drawEllipse(*button, buttonRadius, buttonRadius);
    const QRectF place(*button - QPointF(8, 8), QSizeF(16, 16));
    icon(QStringLiteral("swap"), colors.label).paint(&painter, place.toRect());
}

QStringList SewPicture::figures(bool* puckers) const
{
    const auto side = [&](const Stretch& stretch) {
        return QStringLiteral("%1  %2").arg(displayName(design, stretch.patch),
                                            lengthText(stretchLength(design, stretch)));
    };
    const std::vector<Stretch> others = row();
    if (others.empty())
        return offer && !refused ? QStringList{side(*offer)} : QStringList{};
    SeamEase ease{stretchLength(design, taken.front()), 0};
    QStringList lines{side(taken.front())};
    for (const Stretch& stretch : others) {
        ease.b += stretchLength(design, stretch);
        lines << side(stretch);
    }
    *puckers = ease.puckers();
    lines << QCoreApplication::translate("SewPicture", "Ease %1, %2").arg(ease.differenceText(), ease.ratioText());
    return lines;
}

/// Beside the pointer, where the eyes are.
void SewPicture::paintFigures(QPainter& painter, const ViewColors& colors) const
{
    bool puckers = false;
    const QStringList lines = figures(&puckers);
    if (lines.isEmpty() || !(offer || buttonHovered))
        return;
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(pointer + figuresOffset,
               QSizeF(width + 16, metrics.height() * static_cast<double>(lines.size()) + 10));
    const QRectF view(painter.viewport());
    if (box.right() > view.right())
        box.moveRight(pointer.x() - figuresOffset.x());
    if (box.bottom() > view.bottom())
        box.moveBottom(pointer.y() - figuresOffset.y());
    QColor ground = colors.canvas;
    ground.setAlphaF(0.92F);
    painter.setPen(QPen(puckers ? colors.warning : colors.gridMajor, puckers ? 1.6 : 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 4, 4);
    double baseline = box.top() + 5 + metrics.ascent();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        painter.setPen(puckers && i + 1 == lines.size() ? colors.warning : colors.label);
        painter.drawText(QPointF(box.left() + 8, baseline), lines[i]);
        baseline += metrics.height();
    }
}

void SewPicture::paint(QPainter& painter, const ViewColors& colors) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (!taken.empty() && !row().empty())
        paintSeams(painter, colors);
    else if (!taken.empty())
        paintStretch(painter, taken.front(), false, colors.accent);
    painter.setBrush(Qt::NoBrush);
    if (offer && refused)
        painter.strokePath(path(*offer, false),
                           QPen(colors.error, lineWidth, Qt::DotLine, Qt::FlatCap, Qt::RoundJoin));
    else if (offer && taken.empty())
        painter.strokePath(path(*offer, false),
                           QPen(colors.hover, lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setPen(QPen(colors.accent, 1.6));
    painter.setBrush(colors.pointFill);
    for (const Vec2& mark : marks)
        painter.drawEllipse(m_transform.toPixels(mark), markRadius, markRadius);
    if (button)
        paintButton(painter, colors);
    paintFigures(painter, colors);
}

} // namespace bolster
