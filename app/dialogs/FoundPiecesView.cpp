#include "FoundPiecesView.h"

#include "ViewColors.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <numeric>

namespace bolster {

namespace {

constexpr double viewBorder = 14;       // pixels
constexpr double pieceGap = 0.03;       // of the width of a row
constexpr std::size_t mostDrawn = 4000; // points of a line on the screen

QPainterPath pathOf(const Contour& line, const Vec2& offset)
{
    QPainterPath path;
    const std::size_t step = std::max<std::size_t>(1, line.points.size() / mostDrawn);
    for (std::size_t i = 0; i < line.points.size(); i += step) {
        const Vec2 at = line.points[i].at + offset;
        i == 0 ? path.moveTo(at.x(), at.y()) : path.lineTo(at.x(), at.y());
    }
    if (line.closed)
        path.closeSubpath();
    return path;
}

} // namespace

FoundPiecesView::FoundPiecesView(QWidget* parent)
    : QWidget(parent)
{
    setMinimumSize(320, 260);
    setAccessibleName(tr("Pieces in the file"));
}

void FoundPiecesView::show(std::shared_ptr<const FoundPattern> pattern, std::set<std::size_t> chosen, int marked)
{
    const bool other = pattern != m_pattern;
    m_pattern = std::move(pattern);
    m_chosen = std::move(chosen);
    m_marked = marked;
    if (other)
        layOut();
    update();
}

/// Blocks lie on each other at their origin: in rows then, the tallest first.
void FoundPiecesView::layOut()
{
    m_offsets.clear();
    m_box = {};
    if (!m_pattern)
        return;
    const std::vector<FoundPiece>& pieces = m_pattern->pieces;
    m_offsets.assign(pieces.size(), Vec2::Zero());
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0u);
    double area = 0;
    for (const FoundPiece& piece : pieces)
        area += piece.cut.box().sizes().prod();
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return pieces[i].cut.box().sizes().y(); });
    const double width = 1.4 * std::sqrt(area), gap = pieceGap * width;
    Vec2 at(0, 0);
    double row = 0;
    for (const std::size_t i : order) {
        const Box2 box = pieces[i].cut.box();
        if (at.x() > 0 && at.x() + box.sizes().x() > width) {
            at = {0, at.y() - row - gap};
            row = 0;
        }
        row = std::max(row, box.sizes().y());
        m_offsets[i] = at - Vec2(box.min().x(), box.max().y());
        m_box.extend(Vec2(at.x() + box.sizes().x(), at.y() - box.sizes().y()));
        m_box.extend(at);
        at.x() += box.sizes().x() + gap;
    }
    for (const Contour& line : m_pattern->open)
        if (pieces.empty())
            m_box.extend(line.box());
}

QTransform FoundPiecesView::placed() const
{
    const Vec2 size = m_box.sizes().cwiseMax(1e-6);
    const double scale = std::min((width() - 2 * viewBorder) / size.x(), (height() - 2 * viewBorder) / size.y());
    QTransform map;
    map.translate(width() / 2.0, height() / 2.0);
    map.scale(scale, -scale);
    map.translate(-m_box.center().x(), -m_box.center().y());
    return map;
}

void FoundPiecesView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    if (!m_pattern || m_box.isEmpty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter,
                         m_pattern ? tr("There is no piece in it.") : tr("Reading \u2026"));
        return;
    }
    const QTransform map = placed();
    const QColor line = palette().color(QPalette::Text);
    for (std::size_t i = 0; i < m_pattern->pieces.size(); ++i) {
        const FoundPiece& piece = m_pattern->pieces[i];
        const bool chosen = m_chosen.contains(i), marked = static_cast<int>(i) == m_marked;
        painter.setOpacity(chosen ? 1 : 0.35);
        painter.setPen(QPen(line, marked ? 2 : 1));
        painter.setBrush(marked ? palette().highlight() : palette().alternateBase());
        painter.drawPath(map.map(pathOf(piece.cut, m_offsets[i])));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Link), 1));
        if (piece.sew)
            painter.drawPath(map.map(pathOf(*piece.sew, m_offsets[i])));
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1));
        for (const FoundLine& inner : piece.inner)
            painter.drawPath(map.map(pathOf(inner.line, m_offsets[i])));
        painter.setPen(QPen(line, 1.5));
        for (const FoundNotch& notch : piece.notches) {
            const Vec2 at = notch.at + m_offsets[i];
            painter.drawEllipse(map.map(QPointF(at.x(), at.y())), 2, 2);
        }
        const Vec2 middle = piece.cut.box().center() + m_offsets[i];
        painter.setPen(marked ? palette().color(QPalette::HighlightedText) : line);
        const QPointF place = map.map(QPointF(middle.x(), middle.y()));
        const double wide = map.m11() * piece.cut.box().sizes().x() - 6;
        if (wide > 24)
            painter.drawText(QRectF(place.x() - wide / 2, place.y() - 40, wide, 80),
                             Qt::AlignCenter | Qt::TextWordWrap, QString::fromStdString(piece.name));
    }
    painter.setOpacity(1);
    painter.setPen(QPen(ViewColors::of(palette()).error, 1.5));
    if (m_pattern->pieces.empty())
        for (const Contour& open : m_pattern->open)
            painter.drawPath(map.map(pathOf(open, Vec2::Zero())));
}

void FoundPiecesView::mousePressEvent(QMouseEvent* event)
{
    if (!m_pattern || m_box.isEmpty())
        return;
    const QPointF place = placed().inverted().map(event->position());
    for (std::size_t i = 0; i < m_pattern->pieces.size(); ++i)
        if (m_pattern->pieces[i].cut.contains(Vec2(place.x(), place.y()) - m_offsets[i])) {
            emit pressed(static_cast<int>(i));
            return;
        }
}

} // namespace bolster
