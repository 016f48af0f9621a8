#include "SectionControl.h"

#include "SectionPanel.h"
#include "ShownScene.h"

#include <QMouseEvent>

namespace bolster {

SectionControl::SectionControl(ShownScene& shown, const Camera& camera, QWidget& view)
    : m_shown(shown)
    , m_handle(shown.scene(), camera)
    , m_panel(new SectionPanel(&view))
{
    m_panel->setScene([&shown] { return shown.scene().box; }, [&camera] { return camera; });
    connect(m_panel, &SectionPanel::changed, &shown, &ShownScene::setSection);
    connect(m_panel, &SectionPanel::closed, this, &SectionControl::closed);
}

void SectionControl::setOn(bool on)
{
    m_panel->setOn(on);
}

void SectionControl::place()
{
    m_panel->place();
}

void SectionControl::raise()
{
    m_panel->raise();
}

bool SectionControl::press(const QMouseEvent& event)
{
    if (!m_handle.press(event.position()))
        return false;
    changed();
    return true;
}

bool SectionControl::move(const QMouseEvent& event)
{
    if (m_handle.dragging()) {
        m_panel->setPlane(m_handle.dragged(event.position(), event.modifiers()));
        changed();
        return true;
    }
    const bool before = m_handle.hovering();
    const bool now = event.buttons() == Qt::NoButton && m_handle.hover(event.position());
    if (now && !before)
        emit entered();
    if (now != before)
        changed();
    return now;
}

bool SectionControl::release(const QMouseEvent& event)
{
    if (!m_handle.dragging())
        return false;
    m_handle.release();
    m_handle.hover(event.position());
    changed();
    return true;
}

bool SectionControl::cancel()
{
    if (!m_handle.dragging())
        return false;
    m_panel->setPlane(m_handle.cancel());
    changed();
    return true;
}

void SectionControl::leave()
{
    m_handle.leave();
    changed();
}

void SectionControl::changed()
{
    if (m_shown.scene().section)
        emit handleChanged();
}

} // namespace bolster
