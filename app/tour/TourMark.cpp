#include "TourMark.h"

#include "ViewColors.h"

#include <QEvent>
#include <QPainter>
#include <QRegion>

namespace bolster {

namespace {

constexpr int thickness = 3; // pixels
constexpr int distance = 2;

} // namespace

TourMark::TourMark(QWidget* window)
    : QWidget(window)
    , m_window(window)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    window->installEventFilter(this);
    hide();
}

void TourMark::pointAt(QWidget* widget, const QRect& part)
{
    if (m_widget && m_widget != m_window)
        m_widget->removeEventFilter(this);
    m_widget = widget;
    m_part = part;
    if (widget && widget != m_window)
        widget->installEventFilter(this);
    place();
}

QRect TourMark::target() const
{
    if (!m_widget || !m_widget->isVisible() || m_widget->window() != m_window)
        return {};
    const QRect part = m_part.isEmpty() ? m_widget->rect() : m_part;
    return {m_widget->mapTo(m_window, part.topLeft()), part.size()};
}

void TourMark::place()
{
    const QRect around = target();
    setVisible(!around.isEmpty());
    if (!around.isEmpty()) {
        constexpr int out = thickness + distance;
        const QRect frame = around.adjusted(-out, -out, out, out).intersected(m_window->rect());
        setGeometry(frame);
        const QRect inside = rect().adjusted(thickness, thickness, -thickness, -thickness);
        setMask(QRegion(rect()).subtracted(inside)); // nothing of what is inside is touched
        raise();
        update();
    }
    emit moved();
}

bool TourMark::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::LayoutRequest:
        QMetaObject::invokeMethod(this, &TourMark::place, Qt::QueuedConnection); // when all have their places
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void TourMark::paintEvent(QPaintEvent*)
{
    QPainter(this).fillRect(rect(), ViewColors::of(palette()).accent);
}

} // namespace bolster
