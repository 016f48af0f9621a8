#include "FlatPiecesView.h"

#include "MapScale.h"
#include "ViewColors.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace bolster {

namespace {

constexpr double margin = 14;      // pixels
constexpr double roomForName = 60; // pixels: narrower pieces have none
constexpr float colourSteps = 24;  // triangles of a step are painted together

/// Where a piece lies in the layout; nothing where it has become no patch.
std::optional<Vec2> placeOf(const FormMade& made, std::size_t piece)
{
    const auto* patch = made.pattern.design.find<Patch>(made.pattern.patches[piece]);
    return patch ? std::optional(patch->position) : std::nullopt;
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
}

void FlatPiecesView::show(std::shared_ptr<const FormMade> made, double limit)
{
    m_made = std::move(made);
    m_limit = limit;
    update();
}

/// Millimetres of the layout to pixels, all of it inside.
QTransform FlatPiecesView::fitting() const
{
    Box2 box;
    for (std::size_t p = 0; p < m_made->flat.size(); ++p)
        if (const auto place = placeOf(*m_made, p))
            for (const Vec2& at : m_made->flat[p].at)
                box.extend(at + *place);
    if (box.isEmpty())
        return {};
    const double scale = std::min((width() - 2 * margin) / std::max(box.sizes().x(), 1.0),
                                  (height() - 2 * margin) / std::max(box.sizes().y(), 1.0));
    QTransform fit;
    fit.translate(width() / 2.0, height() / 2.0);
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
    const MapScale scale{MapScale::Kind::Sequential, static_cast<float>(m_limit)};
    std::map<int, QPainterPath> steps;
    for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
        const float share = std::min(flat.strain[t] / static_cast<float>(m_limit), 1.0F);
        QPainterPath& path = steps[static_cast<int>(share * colourSteps)];
        path.addPolygon(QPolygonF{at(piece.triangles[t][0]), at(piece.triangles[t][1]), at(piece.triangles[t][2])});
        path.closeSubpath();
    }
    painter.setRenderHint(QPainter::Antialiasing, false); // no lines between triangles
    for (const auto& [step, path] : steps) {
        const MapScale::Rgba c = scale.color(static_cast<float>(step) / colourSteps * static_cast<float>(m_limit));
        painter.fillPath(path, QColor(c[0], c[1], c[2]));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF border;
    for (const int vertex : piece.border)
        border << at(vertex);
    const ViewColors colors = ViewColors::of(palette());
    painter.setPen(QPen(colors.outline, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(border);
    const QRectF box = border.boundingRect();
    if (box.width() < roomForName)
        return;
    const QString name =
        fontMetrics().elidedText(QString::fromStdString(piece.name), Qt::ElideRight, static_cast<int>(box.width()));
    QRectF plate = fontMetrics().boundingRect(name);
    plate.moveCenter(box.center());
    painter.fillRect(plate.adjusted(-3, -1, 3, 1), colors.canvas);
    painter.setPen(colors.label);
    painter.drawText(plate, Qt::AlignCenter, name);
}

} // namespace bolster
