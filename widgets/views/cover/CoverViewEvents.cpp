// The pointer and the keys in the 3D view: they go to the section's handle, the tool or the camera.
#include "CoverView.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>

#include <algorithm>

namespace bolster {

namespace {

constexpr double surfaceClickReach = 5; ///< pixels

CoverPointer pointerOf(const QMouseEvent& event)
{
    return {event.position(), event.modifiers()};
}

} // namespace

void CoverView::startDrag(const QMouseEvent& event, Qt::MouseButton button)
{
    // Beside what can be dragged the left button alone does what it does with Alt elsewhere.
    const auto keys = event.modifiers() | (button == Qt::LeftButton ? Qt::AltModifier : Qt::NoModifier);
    m_drag.start(event, button, moveOf(MouseView::Cover, button, keys));
    setCursor(m_drag.cursor());
}

void CoverView::mousePressEvent(QMouseEvent* event)
{
    if (m_drag.running())
        return;
    const Qt::MouseButton button = event->button();
    const bool moves = moveOf(MouseView::Cover, button, event->modifiers()) != ViewMove::None;
    if (button == Qt::LeftButton && !moves) {
        m_pressedAt = event->position();
        if (!m_section.press(*event))
            m_tools.tool().press(pointerOf(*event));
    } else if (moves || button == Qt::RightButton) { // which may want the menu
        startDrag(*event, button);
    } else {
        event->ignore();
    }
}

void CoverView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_drag.running())
        m_drag.move(*event);
    else if (m_section.move(*event))
        return;
    else if (!m_tools.tool().move(pointerOf(*event)) && event->buttons() & Qt::LeftButton)
        startDrag(*event, Qt::LeftButton);
    const CoverHit solid = m_shown.hits().hitSolid(m_navigation.camera(), event->position());
    emit pointerMoved(solid.kind == CoverHit::Kind::Cover ? std::optional(solid.position) : std::nullopt);
    emit coverPointed(m_drag.running() ? std::nullopt : m_shown.inPattern(solid));
}

void CoverView::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_drag.running()) {
        if (!m_drag.release(*event))
            return;
        setCursor(m_tools.tool().cursor());
        if (event->button() == Qt::RightButton &&
            m_drag.clicked()) // it may turn; where it has not, the menu is wanted
            m_tools.rightClick(*event);
    } else if (event->button() == Qt::LeftButton && !m_section.release(*event)) {
        m_tools.tool().release(pointerOf(*event));
        const bool click = (event->position() - m_pressedAt).manhattanLength() < surfaceClickReach;
        const auto point = m_shown.inPattern(m_shown.hits().hitSolid(m_navigation.camera(), event->position()));
        if (point && click && tool() == CoverToolKind::Select)
            emit coverClicked(*point);
    }
}

void CoverView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_section.handle().hovering() && event->button() == Qt::LeftButton)
        m_section.press(*event);
    else if (event->button() == Qt::LeftButton && !(event->modifiers() & Qt::AltModifier))
        m_tools.tool().doubleClick(pointerOf(*event));
    else
        mousePressEvent(event);
}

void CoverView::wheelEvent(QWheelEvent* event)
{
    const WheelMove move = moveOf(*event);
    if (move.notches != 0)
        m_navigation.zoom(CoverNavigation::closer(move.notches), event->position());
    if (!move.pan.isNull())
        m_navigation.pan(move.pan, event->position());
}

bool CoverView::event(QEvent* event)
{
    return m_whole ? m_tools.guard([&] { return handle(event); }) : QWidget::event(event);
}

bool CoverView::handle(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture) {
        const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture) {
            m_navigation.zoom(1 / std::max(0.1, 1 + gesture.value()), gesture.position());
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride && m_tools.takesShortcut(static_cast<const QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab &&
        m_tools.tool().wants(Qt::Key_Tab))
        return m_tools.tool().keyPress(static_cast<const QKeyEvent&>(*event));
    return QWidget::event(event);
}

void CoverView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && (m_section.cancel() || m_tools.tool().escape()))
        return;
    if (event->key() == Qt::Key_Home)
        m_navigation.fitAll();
    else if (!m_tools.tool().keyPress(*event))
        QWidget::keyPressEvent(event);
}

void CoverView::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_tools.tool().keyRelease(*event))
        QWidget::keyReleaseEvent(event);
}

void CoverView::leaveEvent(QEvent*)
{
    m_section.leave();
    m_tools.tool().leave();
    emit pointerMoved(std::nullopt);
    emit coverPointed(std::nullopt);
}

void CoverView::focusOutEvent(QFocusEvent* event)
{
    m_tools.tool().leave();
    QWidget::focusOutEvent(event);
}

void CoverView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept(); // the right button may turn
    if (event->reason() == QContextMenuEvent::Keyboard)
        m_tools.menuKey();
}

} // namespace bolster
