// What the window does when an action is triggered.
#include "MainWindow.h"

#include "Actions.h"
#include "Docks.h"
#include "ElementsView.h"
#include "FabricCommands.h"
#include "FileFlow.h"
#include "HelpDialogs.h"
#include "HistoryModel.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Insert.h"
#include "PatchEdits.h"
#include "PatternView.h"
#include "SelectionEdits.h"
#include "StatusLine.h"
#include "Theme.h"
#include "Translated.h"

#include <QApplication>

namespace bolster {

void MainWindow::connectActions()
{
    const auto on = [this](QAction* action, auto function) {
        connect(action, &QAction::triggered, this, function);
    };
    on(m_actions->newDesign, [this] { m_files->startNew(); });
    on(m_actions->open, [this] { m_files->open(); });
    on(m_actions->save, [this] { m_files->save(); });
    on(m_actions->saveAs, [this] { m_files->saveAs(); });
    on(m_actions->saveCopy, [this] { m_files->saveCopy({}); });
    on(m_actions->saveCopyWithoutHistory, [this] { m_files->saveCopy({.withHistory = false}); });
    on(m_actions->saveCopyWithoutScans, [this] { m_files->saveCopy({.withHistory = false, .withScans = false}); });
    on(m_actions->revert, [this] { m_files->revert(); });
    on(m_actions->importFrame, [this] { m_files->importFrame(); });
    on(m_actions->importScan, [this] { m_files->importScan(); });
    on(m_actions->exportSurface,
       [this] { withCoverAtRest([this] { m_files->exportSurface(m_solver->surface()); }); });
    on(m_actions->renderPicture, [this] { withCoverAtRest([this] { renderPicture(); }); });
    on(m_actions->exportPicture, [this] {
        if (m_solver->surface())
            withCoverAtRest([this] { m_files->exportPicture(m_surface->grabPicture()); });
        else
            m_files->exportPicture(m_surface->grabPicture());
    });
    on(m_actions->quit, [this] { close(); });

    on(m_actions->undo, [this] { document().undo(); });
    on(m_actions->redo, [this] { document().redo(); });
    on(m_actions->nameBranch, [this] {
        Docks::reveal(m_docks->history);
        HistoryView& view = m_history->view();
        view.nameBranchOf(view.hasFocus() ? view.currentIndex().data(HistoryModel::NodeRole).toInt()
                                          : document().history().current());
    });
    on(m_actions->remove, [this] { removeSelection(); });
    on(m_actions->rename, [this] {
        Docks::reveal(m_docks->elements);
        m_elements->rename(*m_selection.elements().begin());
    });
    on(m_actions->selectAll, [this] {
        Selection::Elements all;
        document().design().each<Patch>([&](ElementId id, const Patch&) { all.insert(id); });
        m_selection.set(std::move(all));
    });
    on(m_actions->selectNone, [this] { m_selection.clear(); });
    connectTools();
    on(m_actions->turnLeft, [this] { turnSelection(90); });
    on(m_actions->turnRight, [this] { turnSelection(-90); });

    on(m_actions->insertCushion, [this] {
        document().cancelGesture();
        const Edit edit = insertCushion(document().design(), m_selection.elements(), m_session->files());
        insert(edit, tr("Cushioning needs a frame: import one first."));
        if (const QString note = voxelNote(edit); !note.isEmpty())
            m_status->flash(note);
    });
    for (QAction* action : m_actions->insertFoam)
        on(action, [this, action] {
            document().cancelGesture();
            insert(insertFoam(document().design(), m_selection.elements(),
                              static_cast<Foam::Shape>(action->data().toInt()), m_solver->surface(),
                              m_session->files()),
                   tr("Foam belongs to a cushion: insert one first."));
        });

    on(m_actions->pause, [this](bool paused) {
        m_solver->setPaused(paused);
        updateSolverState();
    });
    on(m_actions->report, [this] { withCoverAtRest([this] { showFigures(this, m_solver->report()); }); });
    on(m_actions->resetLayout, [this] { m_docks->reset(); });
    on(m_actions->shortcuts, [this] { showShortcuts(this, *m_actions); });
    on(m_actions->about, [this] { showAbout(this); });
}

void MainWindow::connectViewActions()
{
    connect(m_actions->fitAll, &QAction::triggered, this, [this] {
        m_pattern->navigation().fitAll();
        m_surface->navigation().fitAll();
    });
    connect(m_actions->fitSelection, &QAction::triggered, this, &MainWindow::fitSelection);
    for (QAction* action : m_actions->standardViews)
        connect(action, &QAction::triggered, this, [this, action] {
            m_surface->navigation().setStandardView(static_cast<SurfaceView::StandardView>(action->data().toInt()));
        });
    connect(m_actions->perspective, &QAction::toggled, &m_surface->navigation(),
            &SurfaceNavigation::setPerspective);
    connect(&m_surface->navigation(), &SurfaceNavigation::perspectiveChanged, m_actions->perspective,
            &QAction::setChecked);
    for (QAction* toggle :
         {m_actions->showMesh, m_actions->showChecker, m_actions->showFrames, m_actions->showPoints,
          m_actions->showSeams, m_actions->showCurves, m_actions->showGrid, m_actions->showLabels,
          m_actions->showHandles, m_actions->showFancySeams, m_actions->showScans, m_actions->showScanPairs,
          m_actions->showScanColors, m_actions->showGround, m_actions->showField, m_actions->showTwins,
          m_actions->showSymmetry})
        connect(toggle, &QAction::toggled, this, &MainWindow::applyLayers);
    connect(m_actions->showDeviation, &QAction::toggled, this, &MainWindow::showMeasured);
    for (QAction* action : m_actions->themes)
        connect(action, &QAction::triggered, this, [action] {
            const auto theme = static_cast<Theme>(action->data().toInt());
            storeTheme(theme);
            applyTheme(*qApp, theme);
        });
}

void MainWindow::applyLayers()
{
    PatternLayers layers;
    layers.grid = m_actions->showGrid->isChecked();
    layers.mesh = m_actions->showMesh->isChecked();
    layers.seams = m_actions->showSeams->isChecked();
    layers.points = m_actions->showPoints->isChecked();
    layers.labels = m_actions->showLabels->isChecked();
    layers.handles = m_actions->showHandles->isChecked();
    layers.fancySeams = m_actions->showFancySeams->isChecked();
    layers.twins = m_actions->showTwins->isChecked();
    layers.symmetry = m_actions->showSymmetry->isChecked();
    m_pattern->shown().setLayers(layers);

    using Layer = SurfaceView::Layer;
    m_surface->visibility().setLayerVisible(Layer::Checker, m_actions->showChecker->isChecked());
    m_surface->visibility().setLayerVisible(Layer::MeshEdges, m_actions->showMesh->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Seams, m_actions->showSeams->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Frames, m_actions->showFrames->isChecked());
    m_surface->visibility().setLayerVisible(Layer::FixationCurves, m_actions->showCurves->isChecked());
    m_surface->visibility().setLayerVisible(Layer::HandleCurves, m_actions->showHandles->isChecked());
    m_surface->visibility().setLayerVisible(Layer::FancySeams, m_actions->showFancySeams->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Scans, m_actions->showScans->isChecked());
    m_surface->visibility().setLayerVisible(Layer::ScanPairs, m_actions->showScanPairs->isChecked());
    m_surface->visibility().setLayerVisible(Layer::ScanColors, m_actions->showScanColors->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Twins, m_actions->showTwins->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Symmetry, m_actions->showSymmetry->isChecked());
    m_surface->visibility().setLayerVisible(Layer::Ground, m_actions->showGround->isChecked());
    if (m_actions->showField->isChecked() != m_surface->visibility().layerVisible(Layer::Field)) {
        m_surface->visibility().setLayerVisible(Layer::Field, m_actions->showField->isChecked());
        m_solver->setFieldShown(m_actions->showField->isChecked());
    }
}

/// Commits the edit and selects what it adds; an empty one is a problem.
void MainWindow::insert(const Edit& edit, const QString& problem)
{
    if (edit.empty()) {
        m_status->flash(problem);
        return;
    }
    document().commit(edit);
    m_selection.set({edit.changes.front().id});
}

void MainWindow::removeSelection()
{
    document().cancelGesture();
    const std::vector<ElementId> fabrics = selectedOf<Fabric>(document().design(), m_selection.elements());
    if (fabrics.size() == 1 && m_selection.elements().size() == 1) {
        m_fabricCommands->remove(); // asks what patches get instead
        return;
    }
    QString problem;
    const std::size_t selected = m_selection.elements().size();
    const Edit edit = removeSelected(document().design(), m_selection, &problem);
    if (edit.empty())
        m_status->flash(problem);
    else
        removeAndForget(document(), m_selection, edit);
    if (edit.changes.size() > selected)
        m_status->flash(translated(edit.verb)); // more than was asked for
}

void MainWindow::turnSelection(double degrees)
{
    document().cancelGesture();
    const std::vector<ElementId> patches = selectedOf<Patch>(document().design(), m_selection.elements());
    Box2 box;
    for (const ElementId id : patches) {
        const Patch& patch = *document().design().find<Patch>(id);
        for (const Vec2& point : patch.outline.points())
            box.extend(toLayout(patch, point));
    }
    if (!box.isEmpty())
        document().commit(edits::turnPatches(document().design(), patches, box.center(), degrees));
}

} // namespace bolster
