// Help > Tour: seven things to try on a sample, in the window itself.
#pragma once

#include "Design.h"
#include "History.h"

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace bolster {

class Commands;
class CoverView;
class DesignSession;
class Docks;
class MapLink;
class PatternView;
class Selection;
class TourMark;
class TourPanel;
struct FileFlows;

/// Goes on when somebody has really done what a step says, or by Next. Where it was left is kept in the settings.
class Tour : public QObject {
    Q_DECLARE_TR_FUNCTIONS(Tour)

public:
    struct Parts {
        DesignSession& session;
        Selection& selection;
        MapLink& maps;
        FileFlows& files;
        PatternView& pattern;
        CoverView& coverView;
        Docks& docks;
        QMainWindow& window;
    };

    Tour(Commands& commands, const Parts& parts);
    ~Tour() override;

    /// Opens the sample unless it is there; on where it was left.
    void start();
    void leave();
    bool running() const { return !m_panel.isNull(); }
    /// From 0 on.
    int step() const { return m_step; }

private:
    /// What somebody may have done.
    enum class Deed { CurveDragged, Undone, SeamSelected, SeamChanged, StrainSeen, OutlineChanged, Exported };
    struct Step {
        Deed deed;
        QString title;
        QString text;
        QString praise; ///< when it is done
        std::function<void()> point;
    };

    void addSteps();
    void watch();
    void begin();
    void show();
    void go(int step);
    void did(Deed deed);
    void historyChanged();
    void pointAtMenu(const char* menu);
    void pointAtDock(QDockWidget* dock);

    Commands& m_commands;
    Parts m_parts;
    std::vector<Step> m_steps;
    int m_step = 0;
    bool m_onSample = false; ///< the design that is open is that of the tour
    QPointer<TourPanel> m_panel;
    QPointer<TourMark> m_mark;
    Design m_before; ///< and where its history stood, to see what was done since
    NodeId m_node = 0;
    NodeId m_count = 0;
};

} // namespace bolster
