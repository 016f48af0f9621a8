// The section in the 3D view: its panel and the arrows that move it.
#include "SectionPanel.h"
#include "SurfaceView.h"

#include <QMouseEvent>

namespace bolster {

void SurfaceView::setSectionShown(bool shown)
{
    m_sectionPanel->setOn(shown);
}

void SurfaceView::setSection(const std::optional<SectionPlane>& section)
{
    if (section == m_scene.section)
        return;
    m_scene.section = section;
    m_hitTest.setSection(section);
    updateScans();
    updateMarks();
    placeCrosshair();
    draw(true);
}

bool SurfaceView::pressSection(const QMouseEvent& event)
{
    if (!m_sectionHandle.press(event.position()))
        return false;
    sectionHandleChanged();
    return true;
}

bool SurfaceView::moveSection(const QMouseEvent& event)
{
    if (m_sectionHandle.dragging()) {
        m_sectionPanel->setPlane(m_sectionHandle.dragged(event.position(), event.modifiers()));
        sectionHandleChanged();
        return true;
    }
    const bool before = m_sectionHandle.hovering();
    const bool now = event.buttons() == Qt::NoButton && m_sectionHandle.hover(event.position());
    if (now && !before)
        m_tool->leave();
    if (now != before)
        sectionHandleChanged();
    return now;
}

bool SurfaceView::releaseSection(const QMouseEvent& event)
{
    if (!m_sectionHandle.dragging())
        return false;
    m_sectionHandle.release();
    m_sectionHandle.hover(event.position());
    sectionHandleChanged();
    return true;
}

bool SurfaceView::cancelSection()
{
    if (!m_sectionHandle.dragging())
        return false;
    m_sectionPanel->setPlane(m_sectionHandle.cancel());
    sectionHandleChanged();
    return true;
}

void SurfaceView::sectionHandleChanged()
{
    if (!m_scene.section)
        return;
    updateMarks();
    draw(m_sectionHandle.dragging());
    refresh();
}

} // namespace bolster
