#include "MapLegend.h"

#include "Units.h"

#include <QPainter>

namespace bolster {

namespace {

// Pixels.
constexpr int margin = 12;
constexpr int padding = 10;
constexpr int barWidth = 220;
constexpr int barHeight = 12;

} // namespace

MapLegend::MapLegend(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void MapLegend::setMap(SurfaceMapPtr map)
{
    m_map = std::move(map);
    setVisible(m_map != nullptr);
    place();
    update();
}

void MapLegend::place()
{
    resize(sizeHint());
    const QSize space = parentWidget()->size();
    move(space.width() - width() - margin, space.height() - height() - margin);
}

QSize MapLegend::sizeHint() const
{
    const int line = fontMetrics().height();
    return {barWidth + 2 * padding, 2 * line + barHeight + 2 * padding + 6};
}

QString MapLegend::number(double value) const
{
    const int digits = m_map->limit >= 10 ? 0 : m_map->limit >= 1 ? 1 : 2;
    return (value > 0 ? QStringLiteral("+") : QString()) + decimalText(value, digits, true);
}

void MapLegend::paintEvent(QPaintEvent*)
{
    if (!m_map)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor back = palette().color(QPalette::Window);
    back.setAlphaF(0.88F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(back);
    painter.drawRoundedRect(rect(), 6, 6);

    const int line = fontMetrics().height();
    const QRect inside = rect().adjusted(padding, padding, -padding, -padding);
    painter.setPen(palette().color(QPalette::WindowText));
    const QString title = fontMetrics().elidedText(m_map->title, Qt::ElideRight, inside.width());
    painter.drawText(QRect(inside.topLeft(), QSize(inside.width(), line)), Qt::AlignLeft | Qt::AlignVCenter, title);

    const QRect bar(inside.left(), inside.top() + line + 3, barWidth, barHeight);
    for (int x = 0; x < barWidth; ++x) {
        const auto [r, g, b, a] =
            m_map->color(m_map->limit * (2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(barWidth) - 1));
        painter.fillRect(bar.left() + x, bar.top(), 1, barHeight, QColor(r, g, b));
    }
    const QRect numbers(bar.left(), bar.bottom() + 3, barWidth, line);
    painter.drawText(numbers, Qt::AlignLeft, number(static_cast<double>(-m_map->limit)) + u' ' + m_map->below);
    painter.drawText(numbers, Qt::AlignHCenter, QStringLiteral("0") + m_map->unit);
    painter.drawText(numbers, Qt::AlignRight, number(static_cast<double>(m_map->limit)) + u' ' + m_map->above);
}

} // namespace bolster
