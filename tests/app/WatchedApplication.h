// An application that knows how long it was busy with anything but painting.
#pragma once

#include <QApplication>
#include <QEvent>

#include <algorithm>
#include <ctime>
#include <string>

namespace bolster {

class WatchedApplication : public QApplication {
public:
    using QApplication::QApplication;

    /// The longest event of a kind: by the clock, and what of it this thread itself has computed, which does not
    /// depend on what else the machine does. Milliseconds; painting inside the event is taken out.
    struct Longest {
        double wall = 0;
        double cpu = 0;
        std::string what; ///< the one with the most computing
    };

    void startWatching() { m_block = m_paint = {}; }
    const Longest& longestBlock() const { return m_block; }
    const Longest& longestPaint() const { return m_paint; }

    /// How often something was painted.
    int pictures() const { return m_pictures; }
    /// How often something was shown, moved, resized or laid out.
    int changesOfLayout() const { return m_layouts; }

    bool notify(QObject* receiver, QEvent* event) override
    {
        count(event->type());
        const bool paint = event->type() == QEvent::Paint || event->type() == QEvent::UpdateRequest ||
                           event->type() == QEvent::UpdateLater;
        if (m_inPaint || (!paint && m_depth > 0))
            return QApplication::notify(receiver, event); // belongs to the event around it
        const std::string what =
            std::string(receiver->metaObject()->className()) + " event " + std::to_string(event->type());
        const Span paintedBefore = m_painted;
        const Span start = now();
        m_inPaint = paint;
        ++m_depth;
        const bool accepted = QApplication::notify(receiver, event);
        --m_depth;
        m_inPaint = false;
        Span spent = now() - start;
        if (paint)
            m_painted = m_painted + spent;
        else
            spent = spent - (m_painted - paintedBefore);
        note(paint ? m_paint : m_block, spent, what);
        return accepted;
    }

private:
    struct Span {
        double wall = 0;
        double cpu = 0;
        Span operator-(const Span& other) const { return {wall - other.wall, cpu - other.cpu}; }
        Span operator+(const Span& other) const { return {wall + other.wall, cpu + other.cpu}; }
    };

    static double read(clockid_t clock)
    {
        timespec time{};
        clock_gettime(clock, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }
    static Span now() { return {read(CLOCK_MONOTONIC), read(CLOCK_THREAD_CPUTIME_ID)}; }

    static void note(Longest& longest, const Span& spent, const std::string& what)
    {
        longest.wall = std::max(longest.wall, spent.wall);
        if (spent.cpu <= longest.cpu)
            return;
        longest.cpu = spent.cpu;
        longest.what = what;
    }

    void count(QEvent::Type type)
    {
        m_pictures += type == QEvent::Paint ? 1 : 0;
        for (const QEvent::Type layout :
             {QEvent::LayoutRequest, QEvent::Resize, QEvent::Move, QEvent::Show, QEvent::Hide})
            m_layouts += type == layout ? 1 : 0;
    }

    int m_pictures = 0;
    int m_layouts = 0;
    int m_depth = 0;
    bool m_inPaint = false;
    Span m_painted;
    Longest m_block;
    Longest m_paint;
};

/// The windows are laid out, whatever the window manager makes of them.
inline void waitUntilLaidOut()
{
    constexpr int calmRounds = 5, mostRounds = 500;
    const auto* const application = static_cast<const WatchedApplication*>(qApp);
    for (int calm = 0, round = 0; calm < calmRounds && round < mostRounds; ++calm, ++round) {
        const int before = application->changesOfLayout();
        QGuiApplication::sync();
        QCoreApplication::processEvents();
        if (application->changesOfLayout() != before)
            calm = 0;
    }
}

} // namespace bolster
