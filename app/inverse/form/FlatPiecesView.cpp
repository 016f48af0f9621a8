#include "FlatPiecesView.h"

#include "MapScale.h"
#include "Units.h"
#include "ViewColors.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr double margin = 14;      // pixels
constexpr double mostHidden = 0.4; // of a piece's height, by its name
constexpr int colourSteps = 24;    // triangles of a step are painted together
constexpr int scaleWidth = 120;    // pixels of the bar with the colours

/// Where a piece lies in the layout; nothing where it has become no patch.
std::optional<Vec2> placeOf(const FormMade& made, std::size_t piece)
{
    const auto* patch = made.pattern.design.find<Patch>(made.pattern.patches[piece]);
    return patch ? std::optional(patch->position) : std::nullopt;
}

/// Of a step from 0, no strain, to colourSteps, the limit.
QColor stepColor(int step)
{
    const MapScale scale{MapScale::Kind::Sequential, colourSteps};
    const MapScale::Rgba color = scale.color(static_cast<float>(step));
    return {color[0], color[1], color[2]};
}

QPointF toPoint(const Vec2& at)
{
    return {at.x(), at.y()};
}

} // namespace

FlatPiecesView::FlatPiecesView(QWidget* parent)
    : QWidget(parent)
{
    setMinimumSize(240, 200);
    setAccessibleName(tr("Pieces laid flat"));
    setMouseTracking(true);
}

void FlatPiecesView::show(std::shared_ptr<const FormMade> made, double limit)
{
    m_made = std::move(made);
    m_limit = limit;
    m_hovered.reset();
    update();
}

std::optional<std::size_t> FlatPiecesView::pieceAt(const QPointF& pixel) const
{
    if (!m_made)
        return std::nullopt;
    const QTransform fit = fitting();
    for (std::size_t p = 0; p < m_made->flat.size(); ++p)
        if (borderOf(fit, p).containsPoint(pixel, Qt::OddEvenFill))
            return p;
    return std::nullopt;
}

void FlatPiecesView::hover(std::optional<std::size_t> piece)
{
    if (std::exchange(m_hovered, piece) == piece)
        return;
    update();
    emit hoveredChanged();
}

void FlatPiecesView::mouseMoveEvent(QMouseEvent* event)
{
    hover(pieceAt(event->position()));
}

void FlatPiecesView::leaveEvent(QEvent*)
{
    hover(std::nullopt);
}

int FlatPiecesView::scaleHeight() const
{
    return fontMetrics().height() + 12;
}

/// Millimetres of the layout to pixels, all of it inside, above the scale.
QTransform FlatPiecesView::fitting() const
{
    Box2 box;
    for (std::size_t p = 0; p < m_made->flat.size(); ++p)
        if (const auto place = placeOf(*m_made, p))
            for (const Vec2& at : m_made->flat[p].at)
                box.extend(at + *place);
    if (box.isEmpty())
        return {};
    const double high = height() - scaleHeight();
    const double scale = std::min((width() - 2 * margin) / std::max(box.sizes().x(), 1.0),
                                  (high - 2 * margin) / std::max(box.sizes().y(), 1.0));
    QTransform fit;
    fit.translate(width() / 2.0, high / 2.0);
    fit.scale(scale, -scale);
    fit.translate(-box.center().x(), -box.center().y());
    return fit;
}

void FlatPiecesView::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colors.canvas);
    if (!m_made)
        return;
    const QTransform fit = fitting();
    for (std::size_t p = 0; p < m_made->flat.size(); ++p)
        paintPiece(painter, fit, p);
    paintScale(painter);
}

/// Below the pieces: which colour is how much strain.
void FlatPiecesView::paintScale(QPainter& painter) const
{
    const int top = height() - scaleHeight() + 6, high = fontMetrics().height();
    painter.setPen(ViewColors::of(palette()).label);
    const QString begin = tr("Strain: %1").arg(percentText(0)), end = tr("%1 and more").arg(percentText(m_limit));
    int x = static_cast<int>(margin);
    const auto write = [&](const QString& text) {
        const int wide = fontMetrics().horizontalAdvance(text);
        painter.drawText(QRect(x, top, wide, high), Qt::AlignCenter, text);
        x += wide + 6;
    };
    write(begin);
    for (int step = 0; step < colourSteps; ++step)
        painter.fillRect(QRectF(x + step * scaleWidth / double(colourSteps), top + high / 4.0,
                                scaleWidth / double(colourSteps) + 0.5, high / 2.0),
                         stepColor(step));
    x += scaleWidth + 6;
    write(end);
}

/// Of a piece in pixels; empty where it has become no patch.
QPolygonF FlatPiecesView::borderOf(const QTransform& fit, std::size_t p) const
{
    QPolygonF border;
    if (const std::optional<Vec2> place = placeOf(*m_made, p))
        for (const int vertex : m_made->form.pieces[p].border)
            border << fit.map(toPoint(m_made->flat[p].at[static_cast<std::size_t>(vertex)] + *place));
    return border;
}

bool FlatPiecesView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString tip;
    if (const std::optional<std::size_t> p = pieceAt(help->pos()))
        tip =
            tr("%1: strain %2 (rms)")
                .arg(QString::fromStdString(m_made->form.pieces[*p].name), percentText(m_made->flat[*p].strainRms));
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

void FlatPiecesView::paintPiece(QPainter& painter, const QTransform& fit, std::size_t p) const
{
    const std::optional<Vec2> place = placeOf(*m_made, p);
    if (!place)
        return;
    const FlatPiece& flat = m_made->flat[p];
    const FormPiece& piece = m_made->form.pieces[p];
    const auto at = [&](int vertex) {
        return fit.map(toPoint(flat.at[static_cast<std::size_t>(vertex)] + *place));
    };
    std::map<int, QPainterPath> steps;
    for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
        const float share = std::min(flat.strain[t] / static_cast<float>(m_limit), 1.0F);
        QPainterPath& path = steps[static_cast<int>(share * colourSteps)];
        path.addPolygon(QPolygonF{at(piece.triangles[t][0]), at(piece.triangles[t][1]), at(piece.triangles[t][2])});
        path.closeSubpath();
    }
    painter.setRenderHint(QPainter::Antialiasing, false); // no lines between triangles
    for (const auto& [step, path] : steps)
        painter.fillPath(path, stepColor(step));
    painter.setRenderHint(QPainter::Antialiasing);
    const QPolygonF border = borderOf(fit, p);
    const ViewColors colors = ViewColors::of(palette());
    painter.setPen(m_hovered == p ? QPen(colors.hover, 2) : QPen(colors.outline, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(border);
    const QRectF box = border.boundingRect();
    const QString name = QString::fromStdString(piece.name);
    QRectF plate = fontMetrics().boundingRect(name);
    plate.moveCenter(box.center());
    if (plate.width() > box.width() || plate.height() > mostHidden * box.height())
        return; // a tip has it
    painter.fillRect(plate.adjusted(-3, -1, 3, 1), colors.canvas);
    painter.setPen(colors.label);
    painter.drawText(plate, Qt::AlignCenter | Qt::TextDontClip, name); // descenders of some fonts stick out
}

} // namespace bolster
