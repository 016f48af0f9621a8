// An application that knows when the views were on the screen.
#pragma once

#include "WatchedApplication.h"

#include <QWidget>

#include <functional>

namespace bolster {

class FeelApplication : public WatchedApplication {
public:
    using WatchedApplication::WatchedApplication;

    /// Called after an event in which these, or something in them, were painted.
    void watch(QWidget* pattern, QWidget* cover, std::function<void(bool pattern, bool cover)> painted)
    {
        m_pattern = pattern;
        m_cover = cover;
        m_painted = std::move(painted);
    }

    bool notify(QObject* receiver, QEvent* event) override
    {
        ++m_depth;
        const bool accepted = WatchedApplication::notify(receiver, event);
        --m_depth;
        if (event->type() == QEvent::Paint && receiver->isWidgetType()) {
            auto* widget = static_cast<QWidget*>(receiver);
            m_patternPainted = m_patternPainted || widget == m_pattern;
            m_coverPainted = m_coverPainted || (m_cover && (widget == m_cover || m_cover->isAncestorOf(widget)));
        }
        // The outermost event is over: what was painted has been handed to the screen.
        if (m_depth == 0 && (m_patternPainted || m_coverPainted) && m_painted)
            m_painted(std::exchange(m_patternPainted, false), std::exchange(m_coverPainted, false));
        return accepted;
    }

private:
    QWidget* m_pattern = nullptr;
    QWidget* m_cover = nullptr;
    std::function<void(bool, bool)> m_painted;
    int m_depth = 0;
    bool m_patternPainted = false;
    bool m_coverPainted = false;
};

} // namespace bolster
