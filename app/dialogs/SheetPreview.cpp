#include "SheetPreview.h"

#include "PieceDrawing.h"

#include <QEvent>
#include <QPainter>

namespace bolster {

namespace {

constexpr double border = 12;        // pixels
constexpr double leastLetters = 2.5; // pixels: smaller ones are only grey

} // namespace

SheetPreview::SheetPreview(QWidget* parent)
    : QWidget(parent)
    , m_job([](const Order& order,
               const std::stop_token& stop) { return std::pair(order.revision, drawn(order, stop)); },
            [this](const std::pair<int, QImage>& made) {
                m_picture = made.second;
                m_drawn = made.first == m_revision;
                update();
            })
{
    setMinimumSize(320, 260);
    setAccessibleName(tr("What will be on the sheets"));
}

void SheetPreview::show(Shown shown)
{
    m_shown = std::move(shown);
    draw();
}

void SheetPreview::draw()
{
    m_drawn = false;
    ++m_revision;
    if (isEmpty()) {
        m_job.cancel();
        m_picture = {};
    } else {
        m_job.request({m_shown, size(), devicePixelRatioF(), palette(), m_revision}, true);
    }
    update();
}

void SheetPreview::resizeEvent(QResizeEvent*)
{
    draw();
}

void SheetPreview::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        draw();
}

QImage SheetPreview::drawn(const Order& order, const std::stop_token& stop)
{
    const Shown& shown = order.shown;
    const SheetGrid& grid = shown.plan->grid;
    const CutTable& table = shown.plan->table;
    QImage image((QSizeF(order.pixels) * order.ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(order.ratio);
    image.fill(order.palette.color(QPalette::Mid));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const QSizeF whole = shown.plan->sheets.empty() ? QSizeF(table.size.x(), table.size.y()) : grid.whole();
    const double width = order.pixels.width(), height = order.pixels.height();
    const double scale = std::min((width - 2 * border) / whole.width(), (height - 2 * border) / whole.height());
    painter.translate(width / 2 - scale * whole.width() / 2, height / 2 - scale * whole.height() / 2);
    painter.scale(scale, scale);
    const auto place = [&](const Sheet& sheet) {
        return QRectF(QPointF(sheet.column * grid.step.width(), sheet.row * grid.step.height()), grid.room.size());
    };
    if (shown.plan->sheets.empty())
        painter.fillRect(QRectF(QPointF(), whole), Qt::white);
    for (const Sheet& sheet : shown.plan->sheets)
        painter.fillRect(place(sheet), Qt::white);
    painter.save();
    painter.translate(0, table.size.y());
    painter.scale(1, -1);
    for (const TablePiece& piece : table.pieces) {
        if (stop.stop_requested())
            break; // nobody sees it
        const CutPiece& cut = shown.pattern->pieces[piece.piece];
        CutLayers layers = shown.layers;
        layers.labels = layers.labels && cut.label.height * scale > leastLetters;
        drawPiece(painter, cut, piece, layers, 4 / scale);
    }
    painter.restore();
    painter.setPen(QPen(order.palette.color(QPalette::Highlight), 1.2 / scale, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    for (const Sheet& sheet : shown.plan->sheets)
        painter.drawRect(place(sheet));
    return image;
}

void SheetPreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(rect(), palette().mid());
    if (!m_picture.isNull()) {
        const QSizeF size = m_picture.deviceIndependentSize().scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
        painter.drawImage(QRectF(rect().center().x() + 0.5 - size.width() / 2,
                                 rect().center().y() + 0.5 - size.height() / 2, size.width(), size.height()),
                          m_picture);
    } else {
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect(), Qt::AlignCenter,
                         m_shown.pattern && isEmpty() ? tr("There is nothing to cut.") : tr("Laying out \u2026"));
    }
}

} // namespace bolster
