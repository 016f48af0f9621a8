#include "MapLegend.h"

#include "Units.h"

#include <QPainter>

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

// Pixels.
constexpr int legendMargin = 12;
constexpr int legendPadding = 10;
constexpr int leastBarWidth = 220;
constexpr int readingCharacters = 16; // "Here: -12.3 1/m"
constexpr int barHeight = 12;

} // namespace

MapLegend::MapLegend(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, qOverload<>(&QWidget::update));
    hide();
}

void MapLegend::setMap(ShownMapPtr map)
{
    m_map = std::move(map);
    setVisible(m_map != nullptr);
    place();
    update();
}

void MapLegend::setReading(const QString& reading)
{
    if (reading == m_reading)
        return;
    m_reading = reading;
    setAccessibleDescription(reading);
    update();
}

bool MapLegend::place(const std::vector<QRectF>& busy)
{
    resize(sizeHint());
    const QSize space = parentWidget()->size();
    const int right = space.width() - width() - legendMargin, low = space.height() - height() - legendMargin;
    double least = std::numeric_limits<double>::max();
    QPoint best(right, low);
    for (const QPoint corner :
         {best, QPoint(legendMargin, low), QPoint(right, legendMargin), QPoint(legendMargin, legendMargin)}) {
        double covered = 0;
        for (const QRectF& patch : busy) {
            const QRectF both = patch.intersected(QRectF(corner, size()));
            covered += both.isValid() ? both.width() * both.height() : 0;
        }
        if (covered < least) {
            least = covered;
            best = corner;
        }
    }
    move(best);
    return !(least > 0);
}

QSize MapLegend::sizeHint() const
{
    const int line = fontMetrics().height();
    return {barWidth() + 2 * legendPadding, (hasLimits() ? 3 : 2) * line + barHeight + 2 * legendPadding + 6};
}

/// There is room for what the map says under the pointer beside its title.
int MapLegend::barWidth() const
{
    const int title = m_map ? fontMetrics().horizontalAdvance(m_map->title) : 0;
    return std::max(leastBarWidth, title + readingCharacters * fontMetrics().averageCharWidth());
}

QString MapLegend::number(double value) const
{
    const int digits = m_map->limit >= 10 ? 0 : m_map->limit >= 1 ? 1 : 2;
    const bool sign = value > 0 && m_map->kind == MapScale::Kind::Diverging;
    return (sign ? QStringLiteral("+") : QString()) +
           (m_map->unit == millimetreSuffix ? steadyLengthFigure(value, digits) : decimalText(value, digits, true));
}

void MapLegend::paintEvent(QPaintEvent*)
{
    if (!m_map)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Window)); // names of patches below it would be read with it
    painter.drawRoundedRect(rect(), 6, 6);

    const int line = fontMetrics().height();
    const QRect inside = rect().adjusted(legendPadding, legendPadding, -legendPadding, -legendPadding);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect top(inside.topLeft(), QSize(inside.width(), line));
    painter.drawText(top, Qt::AlignLeft | Qt::AlignVCenter, m_map->title);
    painter.drawText(top, Qt::AlignRight | Qt::AlignVCenter, m_reading);

    const QRect bar(inside.left(), inside.top() + line + 3, inside.width(), barHeight);
    const bool both = m_map->kind == MapScale::Kind::Diverging;
    for (int x = 0; x < bar.width(); ++x) {
        const float share = (static_cast<float>(x) + 0.5F) / static_cast<float>(bar.width());
        const auto [r, g, b, a] = m_map->color(m_map->limit * (both ? 2 * share - 1 : share));
        painter.fillRect(bar.left() + x, bar.top(), 1, barHeight, QColor(r, g, b));
    }
    QRect text(bar.left(), bar.bottom() + 3, bar.width(), line);
    const auto limit = static_cast<double>(m_map->limit);
    const QString unit = m_map->unit == millimetreSuffix ? lengthSuffix() : m_map->unit;
    painter.drawText(text, Qt::AlignRight, number(limit) + (both ? QString() : unit) + u' ' + m_map->above);
    if (both) {
        painter.drawText(text, Qt::AlignLeft, number(-limit) + u' ' + m_map->below);
        painter.drawText(text, Qt::AlignHCenter, QStringLiteral("0") + unit);
    } else {
        painter.drawText(text, Qt::AlignLeft, QStringLiteral("0") + unit);
        markValue(painter, bar, text);
    }
    if (hasLimits()) {
        text.translate(0, line);
        int left = text.left();
        for (const auto& [r, g, b, a] : {MapScale::under, MapScale::over})
            if (both || r > b) {
                painter.fillRect(left, text.top() + (line - barHeight) / 2, barHeight, barHeight, QColor(r, g, b));
                left += barHeight + 2;
            }
        painter.drawText(text.adjusted(left - text.left() + 4, 0, 0, 0), Qt::AlignLeft,
                         tr("over the fabric's limit"));
    }
}

/// A line across the bar, and its number below where there is room between those at the ends.
void MapLegend::markValue(QPainter& painter, const QRect& bar, const QRect& text) const
{
    if (!m_map->mark || *m_map->mark > m_map->limit)
        return;
    const double x = bar.left() + bar.width() * static_cast<double>(*m_map->mark / m_map->limit);
    painter.fillRect(QRectF(x - 2, bar.top() - 3, 4, bar.height() + 6), palette().color(QPalette::Window));
    painter.fillRect(QRectF(x - 1, bar.top() - 3, 2, bar.height() + 6), palette().color(QPalette::WindowText));
    const QString figure = number(static_cast<double>(*m_map->mark));
    const int half = fontMetrics().horizontalAdvance(figure) / 2, ends = 10 * fontMetrics().averageCharWidth();
    if (x - half > text.left() + ends && x + half < text.right() - ends)
        painter.drawText(QRectF(x - half, text.top(), 2 * half + 2, text.height()), Qt::AlignHCenter, figure);
}

} // namespace bolster
