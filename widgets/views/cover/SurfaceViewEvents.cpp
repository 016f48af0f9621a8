// The pointer and the keys in the 3D view: they turn the camera or go to the tool.
#include "Document.h"
#include "Selection.h"
#include "SurfaceView.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>

#include <cmath>

namespace bolster {

namespace {

constexpr double orbitSpeed = 0.0075;   ///< radians per pixel
constexpr double surfaceClickReach = 5; ///< pixels
constexpr QPointF nowhere(-1e6, -1e6);
constexpr double wheelStep = 0.88; ///< distance after one notch

SurfacePointer pointerOf(const QMouseEvent& event)
{
    return {event.position(), event.modifiers()};
}

} // namespace

/// What lies under the pointer, or the place at the depth of the scene's middle: movements are about it.
Vec3 SurfaceView::anchorAt(QPointF pixel) const
{
    if (const SurfaceHit solid = m_hitTest.hitSolid(m_camera, pixel))
        return solid.position;
    const Vec3 middle = m_scene.box.isEmpty() ? m_camera.target : Vec3(m_scene.box.center());
    const bool inFront = !m_camera.perspective || m_camera.depth(middle) > 0;
    return m_camera.onPlaneThrough(inFront ? middle : m_camera.target, {pixel.x(), pixel.y()});
}

void SurfaceView::startNavigation(Navigation navigation, QPointF pixel)
{
    m_flight.stop();
    m_fitPending = false;
    m_navigation = navigation;
    m_navigationLast = pixel;
    m_navigationAnchor = anchorAt(pixel);
    if (navigation == Navigation::Turn && !m_hitTest.hitSolid(m_camera, pixel))
        m_navigationAnchor = m_scene.box.isEmpty() ? m_camera.target : Vec3(m_scene.box.center());
    setCursor(navigation == Navigation::Pan ? Qt::ClosedHandCursor : Qt::SizeAllCursor);
}

void SurfaceView::navigate(QPointF pixel)
{
    const QPointF by = pixel - m_navigationLast;
    m_navigationLast = pixel;
    Camera camera = m_camera;
    if (m_navigation == Navigation::Turn)
        camera.orbit(-orbitSpeed * by.x(), orbitSpeed * by.y(), m_navigationAnchor);
    else
        camera.pan({by.x(), by.y()}, m_navigationAnchor);
    apply(camera);
}

void SurfaceView::mousePressEvent(QMouseEvent* event)
{
    if (m_navigation != Navigation::None)
        return;
    const bool left = event->button() == Qt::LeftButton, alt = event->modifiers() & Qt::AltModifier;
    if (left && !alt) {
        m_pressedAt = event->position();
        if (pressSection(*event))
            return;
        m_tool->press(pointerOf(*event));
        return;
    }
    if (!left && event->button() != Qt::MiddleButton && event->button() != Qt::RightButton) {
        event->ignore();
        return;
    }
    const bool pan = event->modifiers() & Qt::ShiftModifier;
    m_navigationButton = event->button();
    m_pressedAt = event->position();
    startNavigation(pan ? Navigation::Pan : Navigation::Turn, event->position());
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event)
{
    if (m_navigation != Navigation::None) {
        if ((event->position() - m_pressedAt).manhattanLength() >= surfaceClickReach)
            m_pressedAt = nowhere; // who comes back there has turned, not clicked
        navigate(event->position());
    } else if (moveSection(*event)) {
        return;
    } else if (!m_tool->move(pointerOf(*event)) && event->buttons() & Qt::LeftButton) {
        m_navigationButton = Qt::LeftButton;
        startNavigation(event->modifiers() & Qt::ShiftModifier ? Navigation::Pan : Navigation::Turn,
                        event->position());
    }
    const SurfaceHit solid = m_hitTest.hitSolid(m_camera, event->position());
    emit pointerMoved(solid.kind == SurfaceHit::Kind::Cover ? std::optional(solid.position) : std::nullopt);
    emit coverPointed(m_navigation == Navigation::None ? coverPointOf(solid) : std::nullopt);
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_navigation != Navigation::None) {
        if (event->button() == m_navigationButton) {
            m_navigation = Navigation::None;
            setCursor(m_tool->cursor());
            if (event->button() == Qt::RightButton)
                rightClick(*event);
        }
    } else if (event->button() == Qt::LeftButton && !releaseSection(*event)) {
        m_tool->release(pointerOf(*event));
        const bool click = (event->position() - m_pressedAt).manhattanLength() < surfaceClickReach;
        if (const auto point = coverPointOf(m_hitTest.hitSolid(m_camera, event->position()));
            point && click && m_toolKind == SurfaceToolKind::Select)
            emit coverClicked(*point);
    }
}

void SurfaceView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_sectionHandle.hovering() && event->button() == Qt::LeftButton)
        pressSection(*event);
    else if (event->button() == Qt::LeftButton && !(event->modifiers() & Qt::AltModifier))
        m_tool->doubleClick(pointerOf(*event));
    else
        mousePressEvent(event);
}

void SurfaceView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0)
        return;
    Camera camera = m_camera;
    camera.zoom(std::pow(wheelStep, notches), anchorAt(event->position()));
    setCamera(camera);
}

bool SurfaceView::event(QEvent* event)
{
    try {
        return handle(event);
    } catch (const std::exception& error) {
        toolFailed(error);
        return true;
    }
}

/// The design is again what it was before the gesture.
void SurfaceView::toolFailed(const std::exception& error)
{
    m_document.cancelGesture();
    m_tool = makeSurfaceTool(m_toolKind, *this);
    emit failed(tr("This could not be done, and nothing was changed: %1").arg(QString::fromUtf8(error.what())));
    refresh();
}

bool SurfaceView::handle(QEvent* event)
{
    if (event->type() == QEvent::NativeGesture) {
        const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture) {
            Camera camera = m_camera;
            camera.zoom(1 / std::max(0.1, 1 + gesture.value()), anchorAt(gesture.position()));
            setCamera(camera);
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride && m_tool->wants(static_cast<QKeyEvent*>(event)->key())) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && m_sectionHandle.dragging() &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && m_document.gestureRunning()) {
        const int key = static_cast<const QKeyEvent&>(*event).key();
        const bool nudges = key >= Qt::Key_Left && key <= Qt::Key_PageDown;
        if (!nudges && key != Qt::Key_Shift)
            m_document.finishGesture(); // other keys mean what they always do
    }
    if (event->type() == QEvent::ShortcutOverride && m_document.gestureRunning()) {
        // During a drag these belong to the tool, whatever the menus say.
        const auto& press = static_cast<const QKeyEvent&>(*event);
        const bool command = press.modifiers() & (Qt::ControlModifier | Qt::MetaModifier | Qt::AltModifier);
        const int key = command ? 0 : press.key();
        if (key == Qt::Key_Escape || key == Qt::Key_S || key == Qt::Key_X || key == Qt::Key_Y || key == Qt::Key_Z) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab &&
        m_tool->wants(Qt::Key_Tab))
        return m_tool->keyPress(*static_cast<QKeyEvent*>(event));
    return QWidget::event(event);
}

void SurfaceView::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && (cancelSection() || m_tool->escape()))
        return;
    if (event->key() == Qt::Key_Home)
        fitAll();
    else if (!m_tool->keyPress(*event))
        QWidget::keyPressEvent(event);
}

void SurfaceView::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_tool->keyRelease(*event))
        QWidget::keyReleaseEvent(event);
}

void SurfaceView::leaveEvent(QEvent*)
{
    m_sectionHandle.leave();
    sectionHandleChanged();
    m_tool->leave();
    emit pointerMoved(std::nullopt);
    emit coverPointed(std::nullopt);
}

void SurfaceView::focusOutEvent(QFocusEvent* event)
{
    m_tool->leave();
    QWidget::focusOutEvent(event);
}

/// The right button turns; where it has not, the menu is wanted.
void SurfaceView::rightClick(const QMouseEvent& event)
{
    const bool click = (event.position() - m_pressedAt).manhattanLength() < surfaceClickReach;
    if (!click || m_document.gestureRunning())
        return;
    const SurfaceHit found = m_toolKind == SurfaceToolKind::Select ? hit(event.position()) : SurfaceHit();
    if (found.kind == SurfaceHit::Kind::Point) {
        if (const Selection::Point point{found.element, found.point}; !m_selection.contains(point))
            m_selection.set({found.element}, {point});
    } else if (found && !m_selection.contains(found.element)) {
        m_selection.set({found.element});
    }
    wantMenu(event.globalPosition().toPoint(), bool(found));
}

void SurfaceView::wantMenu(const QPoint& global, bool onSomething)
{
    if (const ToolKeys keys = m_tool->keys(); !keys.empty())
        emit toolMenuWanted(global, keys);
    else
        emit contextMenuWanted(global, onSomething);
}

void SurfaceView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept(); // the right button turns
    if (event->reason() == QContextMenuEvent::Keyboard && !m_document.gestureRunning())
        wantMenu(mapToGlobal(rect().center()),
                 m_toolKind == SurfaceToolKind::Select && !m_selection.elements().empty());
}

} // namespace bolster
