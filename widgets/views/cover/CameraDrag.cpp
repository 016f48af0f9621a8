#include "CameraDrag.h"

#include "ShownScene.h"

#include <QMouseEvent>

namespace bolster {

namespace {

constexpr double orbitSpeed = 0.0075;  ///< radians per pixel
constexpr double cameraClickReach = 5; ///< pixels

} // namespace

void CameraDrag::start(const QMouseEvent& event, Qt::MouseButton button)
{
    m_navigation.stop();
    m_button = button;
    m_pans = event.modifiers() & Qt::ShiftModifier;
    m_far = false;
    m_from = m_last = event.position();
    const bool onSomething = bool(m_shown.hits().hitSolid(m_navigation.camera(), m_from));
    m_anchor = m_pans || onSomething ? m_navigation.anchorAt(m_from) : m_navigation.middle();
}

void CameraDrag::move(const QMouseEvent& event)
{
    const QPointF by = event.position() - m_last;
    m_last = event.position();
    m_far = m_far || (m_last - m_from).manhattanLength() >= cameraClickReach;
    Camera camera = m_navigation.camera();
    if (m_pans)
        camera.pan({by.x(), by.y()}, m_anchor);
    else
        camera.orbit(-orbitSpeed * by.x(), orbitSpeed * by.y(), m_anchor);
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
