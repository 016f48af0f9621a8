// Plays gestures through real events in the real window and measures how it feels.
#pragma once

#include "FeelApplication.h"
#include "FeelScript.h"
#include "MainWindow.h"

#include <QElapsedTimer>

#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace bolster {

/// Milliseconds.
struct FeelFigures {
    std::vector<double> toPattern;         ///< pointer to repainted pattern, drags in the pattern
    std::vector<double> toSurfaceFixation; ///< pointer to the new surface on the screen, drags of fixation points
    std::vector<double> toSurfaceOutline;  ///< likewise of outline points
    int unseen = 0;                        ///< moves whose surface never came, or only after the drag
    WatchedApplication::Longest block;     ///< while something moves: anything but painting
    WatchedApplication::Longest paint;
    std::map<QString, int> gestures; ///< by kind
    int events = 0;
};

class FeelPlayer {
public:
    FeelPlayer(FeelApplication& application, MainWindow& window);
    ~FeelPlayer();

    /// Sends the event and lets the window work as long as a hand takes to the next one.
    void play(const FeelEvent& event);
    /// Waits until the surface of the last gesture has come.
    void finishGesture();
    const FeelFigures& figures() const { return m_figures; }

private:
    struct Move {
        double at = 0; ///< ms
        std::uint64_t revision = 0;
        bool patternSeen = false;
    };

    void painted(bool pattern, bool cover);
    std::uint64_t revisionShown() const;
    void send(const FeelEvent& event, QWidget& view, QPoint at);
    QWidget& view(const QString& name);
    double now() const { return 1e-6 * static_cast<double>(m_clock.nsecsElapsed()); }

    FeelApplication& m_application;
    MainWindow& m_window;
    QElapsedTimer m_clock;
    QString m_kind;
    bool m_down = false;
    std::vector<Move> m_moves; ///< that are not all on the screen yet
    /// Revisions of the designs that the newest surfaces are of: what a surface itself counts is something else.
    std::deque<std::pair<SurfaceMeshPtr, std::uint64_t>> m_surfaces;
    QMetaObject::Connection m_toSolver;
    FeelFigures m_figures;
};

} // namespace bolster
