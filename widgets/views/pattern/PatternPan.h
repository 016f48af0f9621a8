// Pans and zooms the pattern with the pointer.
#pragma once

#include <QCursor>
#include <QPointF>

#include <optional>

class QMouseEvent;

namespace bolster {

class PatternNavigation;

/// With the buttons that MouseStyle says, or with the left one while Space is down.
class PatternPan {
public:
    /// It must outlive it.
    explicit PatternPan(PatternNavigation& navigation)
        : m_navigation(navigation)
    {}

    void setSpace(bool down) { m_space = down; }
    bool running() const { return m_last.has_value(); }
    /// True: it has begun.
    bool press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release() { m_last.reset(); }
    /// Of the view, while it can begin or goes on.
    std::optional<QCursor> cursor() const;

private:
    PatternNavigation& m_navigation;
    bool m_space = false;
    bool m_zooms = false;
    QPointF m_from;
    std::optional<QPointF> m_last;
};

} // namespace bolster
