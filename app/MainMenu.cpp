#include "MainMenu.h"

#include "Actions.h"
#include "Docks.h"
#include "FileFlow.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace bolster {

namespace {

class MenuBuilder {
    Q_DECLARE_TR_FUNCTIONS(MainMenu)

public:
    MenuBuilder(QMainWindow& window, Actions& actions, FileFlow& files, Docks& docks)
        : m_bar(*window.menuBar())
        , m_actions(actions)
        , m_files(files)
        , m_docks(docks)
    {}

    void build()
    {
        addFile();
        addEdit();
        addView();
        addInsert();
        addPattern();
        addSurface();
        addWindow();
        QMenu* help = m_bar.addMenu(tr("&Help"));
        help->addAction(m_actions.shortcuts);
        help->addSeparator();
        help->addAction(m_actions.about);
    }

private:
    void addFile()
    {
        QMenu* menu = m_bar.addMenu(tr("&File"));
        menu->addActions({m_actions.newDesign, m_actions.open});
        QMenu* recent = menu->addMenu(tr("Open &recent"));
        QObject::connect(recent, &QMenu::aboutToShow, recent,
                         [recent, &files = m_files] { files.fillRecent(*recent); });
        QMenu* samples = menu->addMenu(tr("Sa&mples"));
        m_files.fillSamples(*samples);
        menu->addSeparator();
        menu->addActions({m_actions.save, m_actions.saveAs});
        menu->addSeparator();
        menu->addActions({m_actions.importFrame, m_actions.importScan});
        menu->addSeparator();
        menu->addActions({m_actions.exportSurface, m_actions.exportPicture});
        menu->addSeparator();
        menu->addAction(m_actions.quit);
    }

    void addEdit()
    {
        QMenu* menu = m_bar.addMenu(tr("&Edit"));
        menu->addActions({m_actions.undo, m_actions.redo});
        menu->addSeparator();
        menu->addActions({m_actions.rename, m_actions.remove});
        menu->addSeparator();
        menu->addActions({m_actions.selectAll, m_actions.selectNone});
    }

    void addView()
    {
        QMenu* menu = m_bar.addMenu(tr("&View"));
        menu->addActions({m_actions.fitAll, m_actions.fitSelection});
        QMenu* views = menu->addMenu(tr("Look at the &cover from"));
        views->addActions(m_actions.standardViews);
        menu->addAction(m_actions.perspective);
        menu->addSeparator();
        menu->addActions({m_actions.showMesh, m_actions.showChecker, m_actions.showFrames, m_actions.showPoints,
                          m_actions.showSeams, m_actions.showCurves, m_actions.showGrid, m_actions.showLabels,
                          m_actions.showScans, m_actions.showGround, m_actions.showField});
        menu->addSeparator();
        menu->addActions({m_actions.showDeviation, m_actions.showScanPairs});
        menu->addSeparator();
        menu->addMenu(tr("Th&eme"))->addActions(m_actions.themes);
    }

    void addInsert()
    {
        QMenu* menu = m_bar.addMenu(tr("&Insert"));
        menu->addAction(m_actions.insertCushion);
        menu->addActions(m_actions.insertFoam);
    }

    void addPattern()
    {
        QMenu* menu = m_bar.addMenu(tr("&Pattern"));
        menu->addActions(m_actions.patternTools);
        menu->addSeparator();
        menu->addActions({m_actions.turnLeft, m_actions.turnRight});
        menu->addSeparator();
        menu->addActions({m_actions.makeTwin, m_actions.linkTwins, m_actions.unlinkTwins, m_actions.releasePoints,
                          m_actions.relinkPoints, m_actions.symmetry});
    }

    void addSurface()
    {
        QMenu* menu = m_bar.addMenu(tr("&Surface"));
        menu->addActions({m_actions.settle, m_actions.pause});
        menu->addSeparator();
        menu->addAction(m_actions.report);
    }

    void addWindow()
    {
        QMenu* menu = m_bar.addMenu(tr("&Window"));
        for (QDockWidget* dock : m_docks.all())
            menu->addAction(dock->toggleViewAction());
        menu->addSeparator();
        menu->addAction(m_actions.resetLayout);
    }

    QMenuBar& m_bar;
    Actions& m_actions;
    FileFlow& m_files;
    Docks& m_docks;
};

} // namespace

void buildMenus(QMainWindow& window, Actions& actions, FileFlow& files, Docks& docks)
{
    MenuBuilder(window, actions, files, docks).build();
}

} // namespace bolster
