#include "MainWindow.h"

#include "Ask.h"
#include "Banner.h"
#include "CommandPalette.h"
#include "Commands.h"
#include "CoverLink.h"
#include "CuttingPanel.h"
#include "Docks.h"
#include "DropFlow.h"
#include "ElementsView.h"
#include "FabricCommands.h"
#include "FabricLink.h"
#include "FabricPanel.h"
#include "FileFlows.h"
#include "FileFormats.h"
#include "FindingsLink.h"
#include "HistoryPanel.h"
#include "Inspector.h"
#include "Jobs.h"
#include "JobsPanel.h"
#include "MapCommands.h"
#include "MapLink.h"
#include "PaneSizes.h"
#include "PatternView.h"
#include "PlainLabels.h"
#include "PreferenceStore.h"
#include "ProblemsView.h"
#include "RayRenderer.h"
#include "SavedViews.h"
#include "ScanLink.h"
#include "SeamsView.h"
#include "SpotsPanel.h"
#include "StartCommands.h"
#include "StartPage.h"
#include "StatusLine.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMimeData>
#include <QPushButton>
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
constexpr int layoutVersion = 6; // larger when docks are added or renamed

void fillToolBar(QToolBar& bar, Commands& commands)
{
    bar.setObjectName(QStringLiteral("tools"));
    bar.setMovable(false);
    bar.setIconSize({20, 20});
    commands.fill(bar);
    if (auto* more = bar.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        more->setToolTip(MainWindow::tr("More commands"));
        more->setAccessibleName(more->toolTip());
    }
}

QStringList filesOf(const QMimeData& data)
{
    QStringList files;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

/// Before there is a label: some are polished when they are laid out for the first time.
QWidget* withPlainLabels(QWidget* parent)
{
    keepLabelsPlain(*qApp);
    return parent;
}

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(withPlainLabels(parent))
    , m_preferences(std::make_unique<PreferenceStore>())
    , m_session(std::make_unique<DesignSession>())
    , m_solver(std::make_unique<SolverLink>(m_session->document()))
    , m_scans(std::make_unique<ScanLink>(*m_session, m_selection))
    , m_maps(std::make_unique<MapLink>(*m_session))
    , m_findings(std::make_unique<FindingsLink>(*m_session, *m_solver))
    , m_covers(std::make_unique<CoverLink>())
    , m_fabricLink(std::make_unique<FabricLink>(*m_session))
    , m_fabricCommands(new FabricCommands(*m_session, m_selection, this))
    , m_commands(new Commands(*this))
    , m_pattern(new PatternView(document(), m_selection, m_problems))
    , m_coverView(new CoverView(document(), m_coverSelection))
    , m_elements(new ElementsView(document(), m_selection, m_problems))
    , m_history(new HistoryPanel(document()))
    , m_inspector(new Inspector(document(), m_selection, m_problems))
    , m_problemList(new ProblemsView(m_problems, document()))
    , m_seams(new SeamsView(document(), m_selection))
    , m_fabricPanel(new FabricPanel(document(), m_selection, *m_fabricLink, *m_commands))
    , m_spots(new SpotsPanel(*m_maps, *m_commands))
    , m_cutting(new CuttingPanel(document()))
    , m_status(new StatusLine(this))
    , m_banner(new Banner)
    , m_files(std::make_unique<FileFlows>(*m_session, this, *m_banner))
    , m_drops(new DropFlow(*m_files, *m_fabricCommands, this))
{
    setAcceptDrops(true);
    setStatusBar(m_status);
    m_coverView->setSoftwareRenderer(std::make_unique<RayRenderer>());
    auto* bar = addToolBar(tr("Tools"));
    addMessages();
    m_docks = std::make_unique<Docks>(*this, Docks::Parts{m_pattern, m_coverView, m_elements, m_history,
                                                          m_inspector, m_problemList, m_seams, m_fabricPanel,
                                                          m_spots, m_cutting, new JobsPanel});
    m_startPage = new StartPage(*this, {m_docks->pattern, m_docks->cover});
    m_palette = new CommandPalette(*this);
    connectSession(); // before the areas: what they look at is up to date then
    connectDocument();
    connectSolver();
    addCommands();
    fillToolBar(*bar, *m_commands);
    connectViews();
    connectContextMenus();
    connectFiles();
    connectFindings();
    connectKeyboard();
    connectJobs();
    connectStartPage();
    m_session->startNew();
    restoreSize();
}

MainWindow::~MainWindow()
{
    disconnect(qApp, nullptr, this, nullptr);         // a dialog that goes with the window changes the focus
    disconnect(&Jobs::all(), nullptr, this, nullptr); // jobs that go with it change the list
    hide(); // the views lose the keyboard by that, and end what they have begun: as long as there is what they use
}

void MainWindow::open(const QString& path)
{
    if (isFileOf(FileUse::Design, path) || !DropFlow::takes(path))
        m_files->opening.open(path);
    else
        m_drops->drop({path}); // a frame, say, into a new design
}

void MainWindow::recover()
{
    m_files->left.recover();
}

void MainWindow::greet()
{
    m_startCommands->greet();
}

QAction* MainWindow::command(const char* id)
{
    return (*m_commands)[id];
}

void MainWindow::addMessages()
{
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

void MainWindow::designOpened()
{
    m_banner->dismiss(); // it spoke about the last one
    m_selection.clear();
    m_elements->scrollToTop();
    m_solver->forget(m_session->files());
    m_coverView->shown().setFiles(m_session->files());
    m_pattern->navigation().fitAll();
    m_coverAwaited = true;
    lookAtOpened();
    updateTitle();
    m_commands->update();
    m_afterOpening.start(); // the one before may have been large
}

/// From where it was looked at last; samples and new designs as they look best.
void MainWindow::lookAtOpened()
{
    const std::optional<Viewpoint> last = SavedViews::lastOf(m_session->path());
    m_fitCover = !last;
    if (last)
        m_coverView->navigation().returnTo(*last);
    else
        m_coverView->navigation().setStandardView(CoverView::StandardView::ThreeQuarter);
}

/// Where the camera stands while the first cover is still to come nobody has chosen.
void MainWindow::keepCamera()
{
    bool waits = false;
    document().design().each<Patch>([&](ElementId, const Patch&) { waits = m_fitCover; });
    if (!m_session->path().isEmpty() && !waits)
        SavedViews::keepLast(m_session->path(), m_coverView->navigation().camera());
}

void MainWindow::updateTitle()
{
    const QString title = m_session->title();
    setWindowTitle(
        (m_session->readOnly() ? tr("%1[*] (read-only) \u2013 Bolster") : tr("%1[*] \u2013 Bolster")).arg(title));
    setWindowModified(document().dirty());
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
    m_status->setSolver(status, m_solver->paused(), document().gestureRunning());
    // What is wrong is known only once everything has been looked at: no flicker while a drag goes on.
    if (status.state != SolverStatus::State::Preparing)
        updateProblems();
    if (status.state == SolverStatus::State::Idle || status.state == SolverStatus::State::Failed)
        m_problemList->forgetFindings();
    const bool stale = m_solver->paused() && !m_solver->upToDate();
    m_coverView->shown().setDimmed(status.state == SolverStatus::State::Failed || stale);
}

void MainWindow::showProblem(ElementId element)
{
    if (element == settingsId || !document().design().element(element)) {
        m_selection.clear();
        return;
    }
    m_mapCommands->hideSpot();
    m_elements->reveal(element);
    m_pattern->navigation().fitSelection();
}

void MainWindow::restoreSize()
{
    const QSettings settings;
    if (!restoreGeometry(settings.value(geometryKey).toByteArray()))
        resize(QSize(1400, 900).boundedTo(0.92 * screen()->availableSize()));
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    if (!std::exchange(m_wasShown, true)) {
        pageMoved();
        QMetaObject::invokeMethod(this, &MainWindow::arrange, Qt::QueuedConnection);
    }
}

/// Docks get the sizes they had only in a window that has its own. Once it is on the screen: docks that float would
/// come up before it, and lie behind it.
void MainWindow::arrange()
{
    m_arranged = true;
    const bool restored = restoreState(QSettings().value(stateKey).toByteArray(), layoutVersion);
    m_docks->jobs->hide();
    m_banner->parentWidget()->setVisible(m_banner->shown());
    m_docks->restoreSizes(restored ? QSettings().value(sizesKey).toByteArray() : QByteArray());
}

void MainWindow::storeLayout()
{
    if (!m_arranged)
        return; // it is kept from before
    QSettings settings;
    settings.setValue(geometryKey, saveGeometry());
    settings.setValue(stateKey, saveState(layoutVersion));
    settings.setValue(sizesKey, m_docks->saveSizes());
}

void MainWindow::restart()
{
    m_restarts = true;
    close();
}

/// Not inside the event that led here.
void MainWindow::closeAgain(bool restarts)
{
    QMetaObject::invokeMethod(
        this,
        [this, restarts] {
            m_restarts = restarts;
            close();
        },
        Qt::QueuedConnection);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    const bool restarts = std::exchange(m_restarts, false); // not when it is closed after all another time
    document().cancelGesture(); // a series of arrow keys is an edit of its own when it ends
    if (!std::exchange(m_workKept, false) && (document().hasUnsavedWork() || m_session->saving())) {
        event->ignore();
        m_files->saving.keepWork([this, restarts] {
            m_workKept = true;
            closeAgain(restarts);
        });
        return;
    }
    if (!std::exchange(m_jobsGivenUp, false) && !Jobs::all().running().isEmpty()) {
        event->ignore();
        m_workKept = true; // that was answered
        askAboutJobs(restarts);
        return;
    }
    storeLayout();
    m_session->end();
    event->accept();
    if (restarts)
        emit restartWanted(m_session->path());
}

/// Asks once at a time; who goes on working answers for his unsaved work anew.
void MainWindow::askAboutJobs(bool restarts)
{
    QStringList names;
    for (const Jobs::Job& job : Jobs::all().running())
        names << job.name;
    auto* box = new QMessageBox(QMessageBox::Question, tr("Bolster"), tr("Bolster is still working at something."),
                                QMessageBox::Cancel, this);
    box->setInformativeText(
        names.join(u'\n') + QStringLiteral("\n\n") +
        tr("What is closed now is not finished; files that are being written stay as they were."));
    const QAbstractButton* stop = box->addButton(tr("&Stop it and close"), QMessageBox::DestructiveRole);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setObjectName(QStringLiteral("question.jobs"));
    openQuestion(box, [this, stop, restarts](const QAbstractButton* pressed) {
        m_workKept = pressed == stop;
        if (pressed != stop)
            return;
        m_jobsGivenUp = true;
        Jobs::all().cancelAll();
        closeAgain(restarts);
    });
}

/// What lies in a dock behind another one cannot be seen: who types there changes something without knowing.
bool MainWindow::focusNextPrevChild(bool next)
{
    const auto isBehind = [](const QWidget* part) {
        for (; part; part = part->parentWidget())
            if (const auto* dock = qobject_cast<const QDockWidget*>(part))
                return !isInFront(*dock);
        return false;
    };
    constexpr int mostBehind = 1000;
    for (int k = 0; k < mostBehind; ++k) {
        if (!QMainWindow::focusNextPrevChild(next))
            return false;
        if (!isBehind(focusWidget()))
            return true;
    }
    return true;
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
    if (!filesOf(*event->mimeData()).isEmpty()) // what cannot be opened is told why
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    // After the drop is over for the program it came from: what follows may ask questions.
    QMetaObject::invokeMethod(
        this, [this, files = filesOf(*event->mimeData())] { m_drops->drop(files); }, Qt::QueuedConnection);
}

} // namespace bolster
