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
        addSeam();
        addFabric();
        addFrame();
        addScan();
        addSurface();
        addWindow();
        QMenu* help = m_bar.addMenu(tr("&Help"));
        help->addActions({m_actions.findCommand, m_actions.shortcuts, m_actions.editShortcuts});
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
        QMenu* unsaved = menu->addMenu(tr("&Unsaved work"));
        QObject::connect(unsaved, &QMenu::aboutToShow, unsaved,
                         [unsaved, &files = m_files] { files.fillUnsaved(*unsaved); });
        QMenu* samples = menu->addMenu(tr("Sa&mples"));
        m_files.fillSamples(*samples);
        menu->addSeparator();
        menu->addActions({m_actions.save, m_actions.saveAs});
        menu->addMenu(tr("Save a &copy"))
            ->addActions({m_actions.saveCopy, m_actions.saveCopyWithoutHistory, m_actions.saveCopyWithoutScans});
        menu->addAction(m_actions.revert);
        menu->addSeparator();
        menu->addActions({m_actions.importFrame, m_actions.importScan});
        menu->addSeparator();
        menu->addActions({m_actions.exportSurface, m_actions.exportPicture, m_actions.renderPicture});
        menu->addSeparator();
        menu->addAction(m_actions.quit);
    }

    void addEdit()
    {
        QMenu* menu = m_bar.addMenu(tr("&Edit"));
        menu->addActions({m_actions.undo, m_actions.redo, m_actions.nameBranch});
        menu->addSeparator();
        menu->addActions({m_actions.cut, m_actions.copy, m_actions.paste, m_actions.duplicate});
        menu->addSeparator();
        menu->addActions({m_actions.rename, m_actions.remove});
        menu->addSeparator();
        menu->addActions({m_actions.selectAll, m_actions.selectNone, m_actions.lasso});
    }

    void addView()
    {
        QMenu* menu = m_bar.addMenu(tr("&View"));
        menu->addActions({m_actions.fitAll, m_actions.fitSelection});
        QMenu* views = menu->addMenu(tr("Look at the &cover from"));
        views->addActions(m_actions.standardViews);
        QMenu* saved = menu->addMenu(tr("Sa&ved views"));
        saved->setObjectName(QStringLiteral("saved-views")); // filled by the window
        menu->addActions({m_actions.perspective, m_actions.section, m_actions.linkViews});
        menu->addSeparator();
        QMenu* layers = menu->addMenu(tr("La&yers"));
        layers->addActions({m_actions.showMesh, m_actions.showChecker, m_actions.showFrames, m_actions.showPoints,
                            m_actions.showSeams, m_actions.showCurves, m_actions.showHandles,
                            m_actions.showFancySeams, m_actions.showLabels, m_actions.showScans,
                            m_actions.showGround, m_actions.showField});
        layers->addSeparator();
        layers->addActions({m_actions.showTwins, m_actions.showSymmetry});
        layers->addSeparator();
        layers->addActions({m_actions.showScanPairs, m_actions.showScanColors});
        QMenu* map = menu->addMenu(tr("&Map"));
        map->addActions(m_actions.maps);
        map->addAction(m_actions.showDeviation);
        map->addSeparator();
        map->addMenu(tr("&Worst spots"))->setObjectName(QStringLiteral("worst-spots")); // filled by the window
        map->addAction(m_actions.showSpotList);
        QMenu* grid = menu->addMenu(tr("&Grid and snapping"));
        grid->addActions({m_actions.showGrid, m_actions.snapping, m_actions.showRulers, m_actions.showGuides,
                          m_actions.removeGuides});
        menu->addSeparator();
        menu->addActions({m_actions.hideSelected, m_actions.isolate, m_actions.showHidden});
        QMenu* transparency = menu->addMenu(tr("&Opacity"));
        transparency->setObjectName(QStringLiteral("opacity")); // filled by the window
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
        QMenu* arrange = menu->addMenu(tr("Arran&ge"));
        arrange->addActions(
            {m_actions.turnLeft, m_actions.turnRight, m_actions.mirrorHorizontally, m_actions.mirrorVertically});
        arrange->addSeparator();
        arrange->addMenu(tr("Al&ign"))->addActions(m_actions.align);
        arrange->addMenu(tr("&Distribute"))->addActions(m_actions.distribute);
        arrange->addAction(m_actions.arrange);
        menu->addMenu(tr("Poin&ts and edges"))
            ->addActions({m_actions.makeCorner, m_actions.makeSmooth, m_actions.straighten, m_actions.edgeLength,
                          m_actions.equalLengths});
        menu->addMenu(tr("Mirror twi&ns"))
            ->addActions({m_actions.makeTwin, m_actions.linkTwins, m_actions.unlinkTwins, m_actions.releasePoints,
                          m_actions.relinkPoints, m_actions.symmetry});
        menu->addAction(m_actions.mergePatches);
        menu->addSeparator();
        QMenu* picture = menu->addMenu(tr("&Background picture"));
        picture->addActions(
            {m_actions.background, m_actions.showBackground, m_actions.scaleBackground, m_actions.moveBackground});
        picture->addSeparator();
        picture->addActions(m_actions.backgroundOpacities);
        picture->addSeparator();
        picture->addAction(m_actions.removeBackground);
    }

    void addSeam()
    {
        QMenu* menu = m_bar.addMenu(tr("Sea&m"));
        menu->addAction(m_actions.sew);
        menu->addSeparator();
        menu->addActions({m_actions.flipSeams, m_actions.swapSeamSides});
        menu->addSeparator();
        menu->addActions(m_actions.seamContinuities);
        menu->addSeparator();
        menu->addActions(m_actions.seamMatches);
        menu->addSeparator();
        menu->addAction(m_actions.showSeamList);
    }

    void addFabric()
    {
        QMenu* menu = m_bar.addMenu(tr("F&abric"));
        menu->addActions({m_actions.newFabric, m_actions.newPictureFabric});
        menu->addSeparator();
        menu->addActions({m_actions.assignFabric, m_actions.editFabric, m_actions.fabricPicture});
        menu->addSeparator();
        menu->addActions({m_actions.duplicateFabric, m_actions.renameFabric, m_actions.removeFabric});
        menu->addSeparator();
        menu->addActions({m_actions.importFabrics, m_actions.exportFabric});
        menu->addSeparator();
        menu->addMenu(tr("Pre&views"))->addActions({m_actions.fabricsOnCushions, m_actions.fabricsOnBalls});
        menu->addSeparator();
        menu->addActions({m_actions.showColourway, m_actions.newColourway, m_actions.renameColourway,
                          m_actions.removeColourway, m_actions.compareColourways});
    }

    void addFrame()
    {
        QMenu* menu = m_bar.addMenu(tr("F&rame"));
        menu->addActions(m_actions.surfaceTools);
        menu->addAction(m_actions.createFixation);
    }

    void addScan()
    {
        QMenu* menu = m_bar.addMenu(tr("S&can"));
        menu->setToolTipsVisible(true);
        menu->addAction(m_actions.placeScan);
        menu->addSeparator();
        menu->addActions({m_actions.cutScan, m_actions.keepScan, m_actions.keepAroundCover, m_actions.removeCuts});
        menu->addSeparator();
        menu->addAction(m_actions.replaceScan);
    }

    void addSurface()
    {
        QMenu* menu = m_bar.addMenu(tr("&Surface"));
        menu->addAction(m_actions.pause);
        menu->addSeparator();
        menu->addAction(m_actions.report);
    }

    void addWindow()
    {
        QMenu* menu = m_bar.addMenu(tr("&Window"));
        for (QDockWidget* dock : m_docks.all())
            menu->addAction(dock->toggleViewAction());
        menu->addSeparator();
        menu->addActions({m_actions.nextPart, m_actions.previousPart});
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
