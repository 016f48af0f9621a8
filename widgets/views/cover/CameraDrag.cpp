#include "CameraDrag.h"

#include "ShownScene.h"

#include <QMouseEvent>

namespace bolster {

namespace {

constexpr double orbitSpeed = 0.0075;  ///< radians per pixel
constexpr double cameraClickReach = 5; ///< pixels

} // namespace

QCursor CameraDrag::cursor() const
{
    switch (m_move) {
    case ViewMove::Turn:
        return Qt::SizeAllCursor;
    case ViewMove::Pan:
        return Qt::ClosedHandCursor;
    case ViewMove::Zoom:
        return Qt::SizeVerCursor;
    default:
        return Qt::ArrowCursor;
    }
}

void CameraDrag::start(const QMouseEvent& event, Qt::MouseButton button, ViewMove move)
{
    if (move != ViewMove::None)
        m_navigation.stop();
    m_button = button;
    m_move = move;
    m_far = false;
    m_from = m_last = event.position();
    const bool onSomething = bool(m_shown.hits().hitSolid(m_navigation.camera(), m_from));
    m_anchor = m_move == ViewMove::Pan || onSomething ? m_navigation.anchorAt(m_from) : m_navigation.middle();
}

void CameraDrag::move(const QMouseEvent& event)
{
    const QPointF by = event.position() - m_last;
    m_last = event.position();
    m_far = m_far || (m_last - m_from).manhattanLength() >= cameraClickReach;
    Camera camera = m_navigation.camera();
    switch (m_move) {
    case ViewMove::Turn:
        camera.orbit(-orbitSpeed * by.x(), orbitSpeed * by.y(), m_anchor);
        break;
    case ViewMove::Pan:
        camera.pan({by.x(), by.y()}, m_anchor);
        break;
    case ViewMove::Zoom:
        camera.zoom(CoverNavigation::closer(zoomOfDrag(by.y())), m_anchor);
        break;
    case ViewMove::None:
        return;
    }
    m_navigation.setCamera(camera);
}

bool CameraDrag::release(const QMouseEvent& event)
{
    if (event.button() != m_button)
        return false;
    m_button = Qt::NoButton;
    m_far = m_far || (event.position() - m_from).manhattanLength() >= cameraClickReach;
    return true;
}

} // namespace bolster
