#include "PatternPan.h"

#include "MouseStyle.h"
#include "PatternNavigation.h"

#include <QMouseEvent>

namespace bolster {

bool PatternPan::press(const QMouseEvent& event)
{
    const ViewMove move = event.button() == Qt::LeftButton && m_space
                              ? ViewMove::Pan
                              : moveOf(MouseView::Pattern, event.button(), event.modifiers());
    if (move == ViewMove::None)
        return false;
    m_zooms = move == ViewMove::Zoom;
    m_from = event.position();
    m_last = m_from;
    return true;
}

void PatternPan::move(const QMouseEvent& event)
{
    const QPointF by = event.position() - *m_last;
    const PatternTransform& now = m_navigation.transform();
    m_navigation.setTransform(m_zooms ? now.zoomed(m_from, PatternNavigation::closer(zoomOfDrag(by.y())))
                                      : now.panned(by));
    m_last = event.position();
}

std::optional<QCursor> PatternPan::cursor() const
{
    if (running())
        return m_zooms ? Qt::SizeVerCursor : Qt::ClosedHandCursor;
    return m_space ? std::optional<QCursor>(Qt::OpenHandCursor) : std::nullopt;
}

} // namespace bolster
