#include "PatternPan.h"

#include "PatternNavigation.h"

#include <QMouseEvent>

namespace bolster {

bool PatternPan::press(const QMouseEvent& event)
{
    if (event.button() != Qt::MiddleButton && !(event.button() == Qt::LeftButton && m_space))
        return false;
    m_last = event.position();
    return true;
}

void PatternPan::move(const QMouseEvent& event)
{
    m_navigation.setTransform(m_navigation.transform().panned(event.position() - *m_last));
    m_last = event.position();
}

std::optional<QCursor> PatternPan::cursor() const
{
    if (running())
        return Qt::ClosedHandCursor;
    return m_space ? std::optional<QCursor>(Qt::OpenHandCursor) : std::nullopt;
}

} // namespace bolster
