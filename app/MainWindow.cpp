#include "MainWindow.h"

#include "Actions.h"
#include "Banner.h"
#include "CoverLink.h"
#include "Docks.h"
#include "ElementsView.h"
#include "FabricCommands.h"
#include "FabricLink.h"
#include "FabricPanel.h"
#include "FileFlow.h"
#include "FindingsLink.h"
#include "HistoryPanel.h"
#include "Inspector.h"
#include "MainMenu.h"
#include "MapLink.h"
#include "PatternView.h"
#include "PlainLabels.h"
#include "ProblemsView.h"
#include "RayRenderer.h"
#include "SavedViews.h"
#include "ScanLink.h"
#include "SeamsView.h"
#include "SelectionEdits.h"
#include "Shortcuts.h"
#include "SpotsPanel.h"
#include "StatusLine.h"
#include "Thumbnails.h"
#include "Translated.h"
#include "Units.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace bolster {

namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");
const QString sizesKey = QStringLiteral("window/panes");
constexpr int layoutVersion = 4; // larger when docks are added or renamed

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent)
    , m_session(std::make_unique<DesignSession>())
    , m_solver(std::make_unique<SolverLink>(m_session->document()))
    , m_scans(std::make_unique<ScanLink>(*m_session, m_selection))
    , m_maps(std::make_unique<MapLink>(*m_session))
    , m_findings(std::make_unique<FindingsLink>(*m_session, *m_solver))
    , m_covers(std::make_unique<CoverLink>())
    , m_fabricLink(std::make_unique<FabricLink>(*m_session))
    , m_fabricCommands(new FabricCommands(*m_session, m_selection, this))
    , m_actions(new Actions(this))
    , m_pattern(new PatternView(document(), m_selection, m_problems))
    , m_surface(new SurfaceView(document(), m_surfaceSelection))
    , m_elements(new ElementsView(document(), m_selection, m_problems))
    , m_history(new HistoryPanel(document()))
    , m_inspector(new Inspector(document(), m_selection, m_problems))
    , m_problemList(new ProblemsView(m_problems))
    , m_seams(new SeamsView(document(), m_selection))
    , m_fabricPanel(new FabricPanel(document(), m_selection, *m_fabricLink, *m_actions))
    , m_spots(new SpotsPanel(*m_maps, *m_actions))
    , m_status(new StatusLine(this))
    , m_banner(new Banner)
    , m_files(new FileFlow(*m_session, this, m_banner))
{
    keepLabelsPlain(*qApp);
    setAcceptDrops(true);
    setStatusBar(m_status);
    m_surface->setSoftwareRenderer(std::make_unique<RayRenderer>());
    buildToolBars();
    m_docks = std::make_unique<Docks>(*this, Docks::Parts{m_pattern, m_surface, m_elements, m_history, m_inspector,
                                                          m_problemList, m_seams, m_fabricPanel, m_spots});
    buildMenus(*this, *m_actions, *m_files, *m_docks);
    connectDocument();
    connectViews();
    connectScans();
    connectMaps();
    connectFindings();
    connectSewing();
    connectFixing();
    connect3D();
    connectDrawing();
    connectTwins();
    connectFabrics();
    connectActions();
    connectViewActions();
    connectPattern();
    connectPanels();
    connectFirstSteps();
    m_session->startNew();
    applyLayers();
    restoreSize();
}

MainWindow::~MainWindow() = default;

void MainWindow::open(const QString& path)
{
    m_files->open(path);
}

void MainWindow::recover()
{
    m_files->recover();
}

void MainWindow::buildToolBars()
{
    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    bar->addActions({m_actions->newDesign, m_actions->open, m_actions->save});
    bar->addSeparator();
    bar->addActions({m_actions->undo, m_actions->redo, m_actions->remove});
    bar->addSeparator();
    bar->addActions(m_actions->patternTools);
    bar->addActions(m_actions->surfaceTools);
    bar->addAction(m_actions->createFixation);
    bar->addSeparator();
    bar->addActions({m_actions->pause, m_actions->fitAll, m_actions->fitSelection, m_actions->perspective});
    bar->addSeparator(); // what follows has keys and is in View > Layers: the first that a small window leaves out
    bar->addActions({m_actions->showMesh, m_actions->showChecker, m_actions->showSeams, m_actions->showPoints,
                     m_actions->showCurves, m_actions->showFrames, m_actions->showScans, m_actions->showDeviation,
                     m_actions->showGrid, m_actions->snapping});
    if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button")))
        more->setToolTip(tr("More commands"));

    addToolBarBreak();
    auto* messages = addToolBar(tr("Messages"));
    messages->setObjectName(QStringLiteral("messages"));
    messages->setMovable(false);
    messages->setStyleSheet(QStringLiteral("QToolBar { padding: 0; border: none; }"));
    messages->addWidget(m_banner);
    messages->toggleViewAction()->setVisible(false);
    messages->hide();
    connect(m_banner, &Banner::toggled, messages, &QWidget::setVisible);
    setContextMenuPolicy(Qt::NoContextMenu);
}

void MainWindow::connectDocument()
{
    connect(m_session.get(), &DesignSession::opened, this, &MainWindow::designOpened);
    connect(m_session.get(), &DesignSession::leaving, this, &MainWindow::keepCamera);
    connect(m_session.get(), &DesignSession::titleChanged, this, &MainWindow::updateTitle);
    connect(m_session.get(), &DesignSession::titleChanged, this, &MainWindow::updateEditActions); // saved now
    connect(m_session.get(), &DesignSession::filesChanged, this, [this] {
        m_surface->shown().setFiles(m_session->files());
        m_solver->setFiles(m_session->files());
        m_inspector->setFiles(m_session->files());
        m_actions->showScanColors->setVisible(m_surface->shown().hasScanColors());
    });
    connect(m_session.get(), &DesignSession::imported, this, [this](ElementId id) {
        m_selection.set({id});
        if (!m_solver->surface())
            m_surface->navigation().fitAll();
    });
    connect(m_session.get(), &DesignSession::problemsChanged, this, &MainWindow::updateProblems);
    connect(&document(), &Document::dirtyChanged, this, &QWidget::setWindowModified);
    connect(&document(), &Document::historyChanged, this, &MainWindow::updateEditActions);
    connect(&document(), &Document::changed, this, [this] {
        pruneSelection(m_selection, document().design());
        pruneSelection(m_surfaceSelection, document().design());
        m_covers->setDesign(document().design());
        m_actions->undo->setEnabled(document().history().canUndo() || document().gestureRunning());
    });
    connect(&m_selection, &Selection::changed, this, &MainWindow::updateEditActions);

    connect(m_solver.get(), &SolverLink::surfaceChanged, this, [this](const SurfaceMeshPtr& surface) {
        m_pattern->shown().setSurface(surface);
        m_scans->setSurface(surface);
        m_maps->setSurface(surface);
        if (surface && std::exchange(m_fitCover, false))
            m_surface->navigation().setStandardView(SurfaceView::StandardView::ThreeQuarter);
        m_actions->exportSurface->setEnabled(surface != nullptr);
        m_actions->renderPicture->setEnabled(surface != nullptr);
    });
    connect(m_solver.get(), &SolverLink::surfaceShown, &m_surface->shown(), &ShownScene::setSurface);
    connect(m_solver.get(), &SolverLink::surfaceShown, m_covers.get(), &CoverLink::setSurface);
    connect(m_solver.get(), &SolverLink::sprang, this, [this](double distance) {
        m_status->flashWithReason(
            tr("The cover sprang by %1.").arg(lengthText(distance)),
            tr("Folded cloth can lie in several ways, and where a drag leaves it depends on the way of "
               "the pointer. What you see now follows from the design alone: whoever opens it sees "
               "the same, and so do exports and pictures. If you want the other shape, tell the design: "
               "hold the cloth there with a handle, or make the piece smaller until it needs no folds."));
    });
    connect(m_covers.get(), &CoverLink::refined, &m_surface->shown(), &ShownScene::setCover);
    connect(m_solver.get(), &SolverLink::fieldChanged, &m_surface->shown(), &ShownScene::setField);
    connect(m_solver.get(), &SolverLink::statusChanged, this, &MainWindow::updateSolverState);
    connect(&m_problems, &ProblemSet::changed, this, [this] {
        m_status->setProblems(m_problems.count(Severity::Error), m_problems.count(Severity::Warning));
    });
}

void MainWindow::connectViews()
{
    connect(m_pattern, &PatternView::promptChanged, m_status, &StatusLine::setPrompt);
    connect(m_surface, &SurfaceView::promptChanged, m_status, &StatusLine::setPrompt);
    connect(m_pattern, &PatternView::failed, m_status, &StatusLine::flash);
    connect(m_surface, &SurfaceView::failed, m_status, &StatusLine::flash);
    connect(m_surface, &SurfaceView::rendererNote, m_status, &StatusLine::setRendererNote);
    connect(m_pattern, &PatternView::pointerMoved, this, [this](const std::optional<Vec2>& at) {
        m_status->setCoordinates(
            at ? tr("x %1   y %2 mm").arg(decimalText(at->x(), 1, true), decimalText(at->y(), 1, true))
               : QString());
        m_status->setPrompt(m_pattern->prompt());
    });
    connect(m_surface, &SurfaceView::pointerMoved, this, [this](const std::optional<Vec3>& at) {
        m_status->setCoordinates(at ? tr("x %1   y %2   z %3 mm")
                                          .arg(decimalText(at->x(), 1, true), decimalText(at->y(), 1, true),
                                               decimalText(at->z(), 1, true))
                                    : QString());
        m_status->setPrompt(m_surface->prompt());
    });
    connect(m_inspector, &Inspector::fileWanted, this, [this](ElementId id) {
        if (document().design().find<Fabric>(id))
            m_fabricCommands->choosePicture(id);
        else
            m_files->replaceFile(id);
    });
    connect(m_elements, &ElementsView::shown, this, &MainWindow::fitSelection);
    connect(m_problemList, &ProblemsView::chosen, this, &MainWindow::showProblem);
    connect(m_files, &FileFlow::problemsWanted, this, [this] { Docks::reveal(m_docks->problems); });
    connect(m_files, &FileFlow::historyWanted, this, [this] { Docks::reveal(m_docks->history); });
    connect(m_files, &FileFlow::done, m_status, &StatusLine::flash);
    connect(m_files, &FileFlow::imported, this, [this](FileKind kind) { // what came in is to be seen
        (kind == FileKind::Cloud ? m_actions->showScans : m_actions->showFrames)->setChecked(true);
    });
    connect(m_status, &StatusLine::problemsWanted, this, [this] { Docks::reveal(m_docks->problems); });
}

void MainWindow::designOpened()
{
    m_banner->dismiss(); // it spoke about the last one
    m_selection.clear();
    m_elements->scrollToTop();
    m_solver->forget(m_session->files());
    m_surface->shown().setFiles(m_session->files());
    m_actions->showScanColors->setVisible(m_surface->shown().hasScanColors());
    m_pattern->navigation().fitAll();
    lookAtOpened();
    updateTitle();
    updateEditActions();
}

/// From where it was looked at last; samples and new designs as they look best.
void MainWindow::lookAtOpened()
{
    const std::optional<Viewpoint> last = SavedViews::lastOf(m_session->path());
    m_fitCover = !last;
    if (last)
        m_surface->navigation().returnTo(*last);
    else
        m_surface->navigation().setStandardView(SurfaceView::StandardView::ThreeQuarter);
}

/// Where the camera stands while the first cover is still to come nobody has chosen.
void MainWindow::keepCamera()
{
    bool waits = false;
    document().design().each<Patch>([&](ElementId, const Patch&) { waits = m_fitCover; });
    if (!m_session->path().isEmpty() && !waits)
        SavedViews::keepLast(m_session->path(), m_surface->navigation().camera());
}

void MainWindow::updateTitle()
{
    const QString title = m_session->title();
    setWindowTitle(
        (m_session->readOnly() ? tr("%1[*] (read-only) \u2013 Bolster") : tr("%1[*] \u2013 Bolster")).arg(title));
    setWindowModified(document().dirty());
}

void MainWindow::updateEditActions()
{
    const History& history = document().history();
    const auto verb = [&](NodeId node) { return translated(history.node(node).edit.verb); };
    const NodeId current = history.current();
    m_actions->undo->setEnabled(history.canUndo() || document().gestureRunning()); // a drag is undone first
    m_actions->undo->setText(history.canUndo() ? tr("&Undo: %1").arg(verb(current)) : tr("&Undo"));
    m_actions->redo->setEnabled(history.canRedo());
    m_actions->redo->setText(history.canRedo() ? tr("&Redo: %1").arg(verb(history.node(current).lastVisitedChild))
                                               : tr("&Redo"));
    m_actions->revert->setEnabled(m_files->hasSaved() && history.current() != document().saved());
    m_actions->nameBranch->setEnabled(history.branchOf(current).has_value());

    const bool any = !m_selection.elements().empty();
    const bool patches = !selectedOf<Patch>(document().design(), m_selection.elements()).empty();
    m_actions->remove->setEnabled(any);
    m_actions->rename->setEnabled(m_selection.elements().size() == 1);
    m_actions->selectNone->setEnabled(any);
    m_actions->turnLeft->setEnabled(patches);
    m_actions->turnRight->setEnabled(patches);
}

void MainWindow::updateProblems()
{
    Problems all = m_session->problems();
    for (const Problem& problem : m_solver->status().problems)
        if (std::ranges::find(all, problem) == all.end())
            all.push_back(problem);
    std::ranges::copy(m_fabricLink->problems(), std::back_inserter(all));
    m_problems.set(std::move(all));
}

void MainWindow::updateSolverState()
{
    const SolverStatus& status = m_solver->status();
    m_status->setSolver(status, m_solver->paused());
    // What is wrong is known only once everything has been looked at: no flicker while a drag goes on.
    if (status.state != SolverStatus::State::Preparing)
        updateProblems();
    const bool stale = m_solver->paused() && !m_solver->upToDate();
    m_surface->shown().setDimmed(status.state == SolverStatus::State::Failed || stale);
    m_actions->report->setEnabled(m_solver->report().vertices > 0);
}

void MainWindow::showProblem(ElementId element)
{
    if (element == settingsId || !document().design().element(element)) {
        m_selection.clear();
        return;
    }
    m_elements->reveal(element);
    m_pattern->navigation().fitSelection();
}

void MainWindow::fitSelection()
{
    m_pattern->navigation().fitSelection();
    m_surface->navigation().fitSelection();
}

void MainWindow::restoreSize()
{
    const QSettings settings;
    if (!restoreGeometry(settings.value(geometryKey).toByteArray()))
        resize(QSize(1400, 900).boundedTo(0.92 * screen()->availableSize()));
}

/// Docks get the sizes they had only in a window that has its own.
void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    if (std::exchange(m_arranged, true))
        return;
    const bool restored = restoreState(QSettings().value(stateKey).toByteArray(), layoutVersion);
    m_docks->problems->hide();
    m_banner->parentWidget()->setVisible(m_banner->shown());
    m_docks->restoreSizes(restored ? QSettings().value(sizesKey).toByteArray() : QByteArray());
}

void MainWindow::storeLayout()
{
    QSettings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(stateKey, saveState(layoutVersion));
    settings.setValue(sizesKey, m_docks->saveSizes());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    document().cancelGesture(); // a series of arrow keys is an edit of its own when it ends
    if (!std::exchange(m_workKept, false) && (document().hasUnsavedWork() || m_session->saving())) {
        event->ignore();
        m_files->keepWork([this] {
            m_workKept = true;
            QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection); // not inside its own event
        });
        return;
    }
    storeLayout();
    m_session->end();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    // The icons are drawn in the colours of the palette.
    if (event->type() == QEvent::PaletteChange)
        for (QWidget* widget : findChildren<QWidget*>())
            widget->update();
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && FileFlow::takes(urls.front().toLocalFile()))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    // After the drop is over for the program it came from: what follows may ask questions.
    QMetaObject::invokeMethod(
        this, [this, file = event->mimeData()->urls().value(0).toLocalFile()] { m_files->drop(file); },
        Qt::QueuedConnection);
}

} // namespace bolster
