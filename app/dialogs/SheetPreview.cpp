#include "SheetPreview.h"

#include "PieceDrawing.h"

#include <QPainter>

namespace bolster {

namespace {

constexpr double border = 12; // pixels

} // namespace

SheetPreview::SheetPreview(QWidget* parent)
    : QWidget(parent)
{
    setMinimumSize(320, 260);
    setAccessibleName(tr("What will be on the sheets"));
}

void SheetPreview::show(Shown shown)
{
    m_shown = std::move(shown);
    update();
}

void SheetPreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().mid());
    if (!m_shown.pattern || m_shown.table.pieces.empty()) {
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect(), Qt::AlignCenter, tr("There is nothing to cut."));
        return;
    }
    Vec2 whole = m_shown.table.size;
    if (const auto& grid = m_shown.grid)
        whole = {(grid->columns - 1) * grid->step.width() + grid->room.width(),
                 (grid->rows - 1) * grid->step.height() + grid->room.height()};
    const double scale = std::min((width() - 2 * border) / whole.x(), (height() - 2 * border) / whole.y());
    painter.translate(width() / 2.0 - scale * whole.x() / 2, height() / 2.0 - scale * whole.y() / 2);
    painter.scale(scale, scale);
    painter.fillRect(QRectF(0, 0, whole.x(), whole.y()), Qt::white);
    painter.save();
    painter.translate(0, m_shown.table.size.y());
    painter.scale(1, -1);
    for (const TablePiece& place : m_shown.table.pieces)
        drawPiece(painter, m_shown.pattern->pieces[place.piece], place, m_shown.layers, 4 / scale);
    painter.restore();
    if (const auto& grid = m_shown.grid) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2 / scale, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        for (int row = 0; row < grid->rows; ++row)
            for (int column = 0; column < grid->columns; ++column)
                painter.drawRect(QRectF(column * grid->step.width(), row * grid->step.height(), grid->room.width(),
                                        grid->room.height()));
    }
}

} // namespace bolster
