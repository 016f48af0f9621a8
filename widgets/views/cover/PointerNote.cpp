#include "PointerNote.h"

#include "ViewColors.h"

#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

// Pixels.
constexpr int noteGap = 16;
constexpr int notePadding = 6;
constexpr int leastTyped = 64;

} // namespace

PointerNote::PointerNote(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

void PointerNote::showNote(const std::optional<SceneNote>& note)
{
    if (note == m_note)
        return;
    m_note = note;
    if (!note) {
        hide();
        return;
    }
    const int caret = note->typed ? 3 : 0;
    const int width = fontMetrics().horizontalAdvance(note->text) + 2 * notePadding + caret;
    resize(std::max(width, note->typed ? leastTyped : 0), fontMetrics().height() + 2 * notePadding);
    QPoint at = note->beside.toPoint() + QPoint(noteGap, noteGap);
    if (at.x() + this->width() > parentWidget()->width())
        at.setX(static_cast<int>(note->beside.x()) - noteGap - this->width());
    if (at.y() + height() > parentWidget()->height())
        at.setY(static_cast<int>(note->beside.y()) - noteGap - height());
    move(std::max(0, at.x()), std::max(0, at.y()));
    show();
    update();
}

void PointerNote::paintEvent(QPaintEvent*)
{
    const ViewColors colors = ViewColors::of(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    const QColor border = !m_note->typed ? colors.gridMajor : m_note->good ? colors.accent : colors.error;
    painter.setPen(QPen(border, m_note->typed ? 1.6 : 1));
    painter.setBrush(m_note->typed ? colors.pointFill : colors.canvas);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(m_note->good ? colors.label : colors.error);
    const QRectF inside = QRectF(rect()).adjusted(notePadding, notePadding, -notePadding, -notePadding);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, m_note->text);
    if (!m_note->typed)
        return;
    const double caret = inside.left() + fontMetrics().horizontalAdvance(m_note->text) + 1.5;
    painter.setPen(QPen(colors.label, 1));
    painter.drawLine(QPointF(caret, inside.top()), QPointF(caret, inside.bottom()));
}

} // namespace bolster
