// Who hears of what: between document, solver, views, panels and commands.
#include "Banner.h"
#include "CommandPalette.h"
#include "Commands.h"
#include "ContextMenus.h"
#include "CoverAtRest.h"
#include "CoverLink.h"
#include "CuttingCommands.h"
#include "DartCommands.h"
#include "Docks.h"
#include "DrawingCommands.h"
#include "EditCommands.h"
#include "ElementText.h"
#include "ElementsView.h"
#include "FabricCommands.h"
#include "FabricLink.h"
#include "FabricMenu.h"
#include "FileCommands.h"
#include "FileFlows.h"
#include "FindingsLink.h"
#include "FirstSteps.h"
#include "FixingCommands.h"
#include "FrameEdgeCommands.h"
#include "GiveMemoryBack.h"
#include "HelpCommands.h"
#include "InsertCommands.h"
#include "Inspector.h"
#include "InverseCommands.h"
#include "Jobs.h"
#include "KeyPresets.h"
#include "LayerCommands.h"
#include "MainMenu.h"
#include "MainWindow.h"
#include "ManualCommands.h"
#include "MapCommands.h"
#include "PatternCommands.h"
#include "PatternView.h"
#include "PreferenceCommands.h"
#include "ProblemsView.h"
#include "SavedViewCommands.h"
#include "ScanCommands.h"
#include "ScanLink.h"
#include "SeamsView.h"
#include "SelectionEdits.h"
#include "SewingCommands.h"
#include "StartCommands.h"
#include "StartPage.h"
#include "StatusLine.h"
#include "SurfaceCommands.h"
#include "ToolCommands.h"
#include "Tour.h"
#include "Translated.h"
#include "TwinCommands.h"
#include "Units.h"
#include "VersionCommands.h"
#include "ViewCommands.h"
#include "ViewLink.h"
#include "WindowCommands.h"

#include <QApplication>
#include <QLocale>
#include <QLoggingCategory>

#include <algorithm>
#include <span>
#include <utility>

namespace bolster {

namespace {

Q_LOGGING_CATEGORY(times, "bolster.times", QtWarningMsg) // for those who measure

constexpr std::size_t mostSelectedAtOnce = 500; // patches that were imported

/// "fixation-curve": FixationCurveForm.
QString formOf(ElementKind kind)
{
    QString name;
    for (const QString& word : kindIcon(kind).split(u'-'))
        name += word.left(1).toUpper() + word.mid(1);
    return name + QStringLiteral("Form");
}

/// None where the frame is of one piece.
std::optional<PieceOfFrame> pieceAt(const CoverView& view, const QPoint& global, const Design& design,
                                    const DesignFiles& files)
{
    const CoverHit hit = view.hit(view.mapFromGlobal(global));
    const auto mesh = files.meshes.find(hit.element);
    const Frame* frame = design.find<Frame>(hit.element);
    if (hit.kind != CoverHit::Kind::Frame || !frame || mesh == files.meshes.end() || !mesh->second)
        return std::nullopt;
    const std::shared_ptr<const FramePieces> pieces = piecesOf(mesh->second);
    const std::optional<int> piece =
        pieces->ofShown(*mesh->second, pieces->hiddenBy(*mesh->second, frame->hiddenParts), hit.triangle);
    if (!piece || pieces->pieces.size() < 2)
        return std::nullopt;
    return PieceOfFrame{hit.element, mesh->second, *piece};
}

} // namespace

template <class Area, class... Needs>
Area& MainWindow::addArea(Needs&&... needs)
{
    m_areas.push_back(std::make_unique<Area>(std::forward<Needs>(needs)...));
    return static_cast<Area&>(*m_areas.back());
}

/// The order of the areas is that of their commands in the menus that they share.
void MainWindow::addCommands()
{
    Commands& commands = *m_commands;
    addMainMenus(commands);
    auto& cover = addArea<CoverAtRest>(document(), *m_solver, *m_status);
    addArea<FileCommands>(commands, *m_files, *m_session, *m_solver, cover, *m_coverView, *m_fabricLink, *this);
    m_startCommands =
        &addArea<StartCommands>(commands, StartCommands::Parts{*m_startPage, *m_session, *m_files, *m_pattern,
                                                               *m_coverView, *m_banner, *this});
    addArea<EditCommands>(commands, document(), m_selection, *m_docks, *m_elements, *m_history, *m_fabricCommands,
                          *m_status, [this] { return m_pattern->takeBack() || m_coverView->takeBack(); });
    addViewCommands();
    addArea<InsertCommands>(commands, *m_session, m_selection, *m_solver, *m_status);
    addArea<ToolCommands>(commands, *m_pattern, *m_coverView, *m_docks);
    addDesignCommands(cover);
    addArea<SurfaceCommands>(commands, *m_solver, cover, *this);
    addArea<WindowCommands>(commands, *m_docks, *m_inspector);
    m_tour = &addArea<Tour>(commands, Tour::Parts{*m_session, m_selection, *m_maps, *m_files, *m_pattern,
                                                  *m_coverView, *m_docks, *this});
    auto& preferences =
        addArea<PreferenceCommands>(commands, *m_preferences,
                                    PreferenceCommands::Parts{*m_session, *m_solver, *m_covers, *m_coverView,
                                                              *m_fabricCommands, *this, [this] { restart(); }});
    auto& manual = addArea<ManualCommands>(commands, *this, [this] {
        const auto& chosen = m_selection.elements();
        const ElementPtr first = chosen.empty() ? nullptr : document().design().element(*chosen.begin());
        return first ? formOf(kindOf(*first)) : QString();
    });
    connect(m_status, &StatusLine::meaningWanted, &manual, &ManualCommands::openMessage);
    auto& help = addArea<HelpCommands>(commands, *m_palette, *this);
    addArea<FirstSteps>(commands, *m_session, m_selection, *m_solver, *m_pattern, *m_coverView, m_files->opening,
                        *m_startPage);
    addArea<VersionCommands>(*m_session, *m_solver, *m_fabricLink, *m_coverView, *m_history, *this);
    SewingCommands::fillTable(m_seams->table(), commands);
    commands.buildMenus();
    commands.update();
    help.loadKeys(keyPreset(m_preferences->now().keys));
    preferences.keysAreLoaded(help);
    connect(&m_selection, &Selection::changed, &help, [&commands] { commands.update(); });
    connect(&document(), &Document::historyChanged, &help, [&commands] { commands.update(); });
    connect(m_session.get(), &DesignSession::titleChanged, &help, [&commands] { commands.update(); }); // saved
}

void MainWindow::addViewCommands()
{
    Commands& commands = *m_commands;
    m_viewCommands = &addArea<ViewCommands>(commands, document(), m_selection, *m_pattern, *m_coverView,
                                            *m_elements, *m_status, *m_preferences);
    addArea<SavedViewCommands>(commands, *m_coverView, *m_status, *this);
    addArea<LayerCommands>(commands, *m_pattern, *m_coverView, *m_solver);
    m_mapCommands = &addArea<MapCommands>(commands, *m_maps, *m_scans, *m_pattern, *m_coverView, *m_inspector,
                                          *m_docks, *m_spots);
    addArea<DrawingCommands>(commands, *m_pattern, *m_status, *this);
    addArea<ViewLink>(m_selection, m_coverSelection, *m_pattern, *m_coverView, *commands["view.link"]);
}

void MainWindow::addDesignCommands(CoverAtRest& cover)
{
    Commands& commands = *m_commands;
    auto& pattern = addArea<PatternCommands>(document(), m_selection, commands);
    connect(&pattern, &PatternCommands::said, m_status, &StatusLine::flash);
    connect(&pattern, &PatternCommands::edgeLengthWanted, this, [this] {
        Docks::reveal(m_docks->inspector);
        m_inspector->focusFirst();
    });
    addArea<TwinCommands>(commands, document(), m_selection, *m_docks, *m_status);
    auto& sewing = addArea<SewingCommands>(commands, document(), m_selection, *m_docks);
    connect(&sewing, &SewingCommands::selectionToShow, this, [this] { m_pattern->navigation().revealSelection(); });
    addArea<CuttingCommands>(
        commands, CuttingCommands::Parts{*m_cutting, m_files->exports, m_selection, *m_pattern, *m_docks});
    addArea<DartCommands>(commands, document(), m_selection, *m_pattern, *m_status);
    addArea<InverseCommands>(
        commands, InverseCommands::Parts{*m_session, m_selection, *m_solver, *m_maps, *m_pattern, *m_coverView,
                                         *this, [this](const std::optional<CoverPoint>& at) {
                                             at ? m_mapCommands->showSpot(*at) : m_mapCommands->hideSpot();
                                         }});
    addArea<FabricMenu>(commands,
                        FabricMenu::Parts{*m_session, m_selection, *m_fabricCommands, *m_fabricLink, *m_fabricPanel,
                                          *m_solver, *m_pattern, *m_coverView, *m_inspector, *m_docks, *this});
    addArea<FrameEdgeCommands>(commands, *m_session, *m_coverView, *m_status, *this);
    addArea<FixingCommands>(commands, document(), m_selection, *m_solver, *m_status);
    addArea<ScanCommands>(commands, document(), m_selection, *m_scans, m_files->imports, *m_coverView, *m_inspector,
                          *m_status, cover, *this);
}

void MainWindow::connectSession()
{
    connect(m_session.get(), &DesignSession::opened, this, &MainWindow::designOpened);
    m_afterOpening.setSingleShot(true);
    m_afterOpening.setInterval(std::chrono::seconds(5));
    connect(&m_afterOpening, &QTimer::timeout, this, &giveMemoryBack);
    connect(m_session.get(), &DesignSession::leaving, this, &MainWindow::keepCamera);
    connect(m_session.get(), &DesignSession::titleChanged, this, &MainWindow::updateTitle);
    connect(m_session.get(), &DesignSession::filesChanged, this, [this] {
        m_coverView->shown().setFiles(m_session->files());
        m_solver->setFiles(m_session->files());
        m_inspector->setFiles(m_session->files());
        m_commands->update({"layer.scan-colors"});
    });
    connect(m_session.get(), &DesignSession::imported, this, [this](ElementId id) {
        m_selection.set({id});
        const Box3 box = m_coverView->shown().selectedBox(); // may be anywhere, and of any size
        if (!m_solver->surface() || document().design().find<Scan>(id) ||
            (!box.isEmpty() && !m_coverView->navigation().inPicture(box)))
            m_coverView->navigation().fitAll();
    });
    connect(m_session.get(), &DesignSession::problemsChanged, this, &MainWindow::updateProblems);
    connect(&m_problems, &ProblemSet::changed, this, &MainWindow::countProblems);
}

void MainWindow::connectDocument()
{
    connect(&document(), &Document::dirtyChanged, this, &QWidget::setWindowModified);
    connect(&document(), &Document::changed, this, [this] {
        pruneSelection(m_selection, document().design());
        pruneSelection(m_coverSelection, document().design());
        m_covers->setDesign(document().design());
    });
    connect(&document(), &Document::refused, this, [this](const Message& why) {
        m_status->flash(tr("%1 It is back where it was.").arg(translated(why)));
    });
    connect(&document(), &Document::noted, this,
            [this](const Message& note) { m_status->flash(translated(note)); });
    connect(&document(), &Document::dropped, this, &MainWindow::tellDropped);
    connect(&document(), &Document::changed, this, [this] {
        m_banner->withdraw(m_toldDropped);
        if (document().gestureRunning())
            m_status->flash({}); // what was said about the last drag would hide what this one says
        else
            m_status->forgetReason();
    });
}

/// As long as the design is as that edit left it: nobody sees at once that a handle is gone.
void MainWindow::tellDropped(const Design& before, const std::vector<ElementId>& ids)
{
    constexpr std::size_t mostNamed = 5;
    constexpr int longestName = 40; // letters
    QStringList names;
    for (const ElementId id : std::span(ids).first(std::min(mostNamed, ids.size()))) {
        const QString name = displayName(before, id);
        names += isolated(name.size() > longestName ? name.left(longestName) + QStringLiteral("\u2026") : name);
    }
    if (ids.size() > mostNamed)
        names += countedText(before, std::span(ids).subspan(mostNamed));
    m_toldDropped =
        m_banner->announce(Banner::Kind::Information,
                           tr("This change has taken away as well: %1").arg(QLocale().createSeparatedList(names)),
                           {{tr("&Undo"), [this] { document().undo(); }}});
}

void MainWindow::connectSolver()
{
    connect(m_solver.get(), &SolverLink::surfaceChanged, this, [this](const SurfaceMeshPtr& surface) {
        m_pattern->shown().setSurface(surface);
        m_scans->setSurface(surface);
        m_maps->setSurface(surface);
        if (surface && std::exchange(m_fitCover, false))
            m_coverView->navigation().setStandardView(CoverView::StandardView::ThreeQuarter);
    });
    connect(m_solver.get(), &SolverLink::surfaceShown, &m_coverView->shown(), &ShownScene::setSurface);
    connect(m_solver.get(), &SolverLink::surfaceShown, m_covers.get(), &CoverLink::setSurface);
    connect(&m_coverView->navigation(), &CoverNavigation::moved, m_covers.get(),
            [this](const Camera& camera) { m_covers->setPixelSize(camera.pixelSize()); });
    connect(m_solver.get(), &SolverLink::sprang, this, [this](double distance) {
        m_status->flashNext(
            tr("The cover sprang by %1.").arg(lengthText(distance)),
            tr("Folded cloth can lie in several ways, and where a drag leaves it depends on the way of "
               "the pointer. What you see now follows from the design alone: whoever opens it sees "
               "the same, and so do exports and pictures. If you want the other shape, tell the design: "
               "hold the cloth there with a handle, or make the piece smaller until it needs no folds."));
    });
    connect(m_covers.get(), &CoverLink::refined, &m_coverView->shown(), &ShownScene::setCover);
    connect(m_solver.get(), &SolverLink::fieldChanged, &m_coverView->shown(), &ShownScene::setField);
    connect(m_solver.get(), &SolverLink::statusChanged, this, &MainWindow::updateSolverState);
    connect(m_fabricLink.get(), &FabricLink::changed, this, [this] {
        m_pattern->shown().setFabricColors(m_fabricLink->colors());
        m_coverView->shown().setFabricMaps(m_fabricLink->maps());
        m_inspector->setFabricPictures(m_fabricLink->pictures());
        updateProblems();
    });
}

void MainWindow::connectViews()
{
    connect(m_pattern, &PatternView::promptChanged, m_status, &StatusLine::setPrompt);
    connect(m_coverView, &CoverView::promptChanged, m_status, &StatusLine::setPrompt);
    connect(m_pattern, &PatternView::failed, m_status, &StatusLine::flash);
    connect(m_coverView, &CoverView::failed, m_status, &StatusLine::flash);
    connect(m_coverView, &CoverView::pictured, this, [this] { // tests/figures/starts waits for it
        if (m_coverAwaited && m_coverView->shownSurface()) {
            m_coverAwaited = false;
            qCInfo(times, "the cover is on the screen");
            m_fabricLink->begin();
        }
    });
    connect(m_coverView, &CoverView::rendererNote, m_status, &StatusLine::setRendererNote);
    connect(m_pattern, &PatternView::pointerMoved, this, [this](const std::optional<Vec2>& at) {
        m_status->setCoordinates([at] {
            return at ? tr("x %1   y %2").arg(steadyLengthFigure(at->x()), steadyLengthText(at->y())) : QString();
        });
        m_status->setPrompt(m_pattern->prompt());
    });
    connect(m_coverView, &CoverView::pointerMoved, this, [this](const std::optional<Vec3>& at) {
        m_status->setCoordinates([at] {
            return at ? tr("x %1   y %2   z %3")
                            .arg(steadyLengthFigure(at->x()), steadyLengthFigure(at->y()),
                                 steadyLengthText(at->z()))
                      : QString();
        });
        m_status->setPrompt(m_coverView->prompt());
    });
    connect(m_session.get(), &DesignSession::opened, this, [this] {
        m_coverView->visibility().setHidden({});
        m_problemList->forgetFindings();
        m_mapCommands->hideSpot();
    });
    connect(m_elements, &ElementsView::shown, m_viewCommands, &ViewCommands::fitSelection);
    connect(m_seams, &SeamsView::shown, m_viewCommands, &ViewCommands::fitSelection);
    connect(m_problemList, &ProblemsView::chosen, this, &MainWindow::showProblem);
}

void MainWindow::connectContextMenus()
{
    auto* menus = new ContextMenus(document(), m_selection, *m_commands, this);
    connect(m_pattern, &PatternView::contextMenuWanted, menus, &ContextMenus::showInPattern);
    connect(m_elements, &ElementsView::contextMenuWanted, menus, &ContextMenus::showInList);
    connect(m_coverView, &CoverView::contextMenuWanted, menus, [this, menus](const QPoint& at, bool onSomething) {
        menus->showInSurface(at, onSomething,
                             onSomething
                                 ? pieceAt(*m_coverView, at, m_session->document().design(), m_session->files())
                                 : std::nullopt);
    });
    connect(m_pattern, &PatternView::toolMenuWanted, menus,
            [this, menus](const QPoint& at, const ToolKeys& keys) { menus->showForTool(*m_pattern, at, keys); });
    connect(m_coverView, &CoverView::toolMenuWanted, menus,
            [this, menus](const QPoint& at, const ToolKeys& keys) { menus->showForTool(*m_coverView, at, keys); });
}

void MainWindow::connectFiles()
{
    connect(m_coverView, &CoverView::measured, m_inspector, &Inspector::setCoverLengths);
    connect(m_inspector, &Inspector::fileWanted, this, [this](ElementId id) {
        if (document().design().find<Fabric>(id))
            m_fabricCommands->choosePicture(id);
        else
            m_files->imports.replaceFile(id);
    });
    connect(&m_files->opening, &OpenFlow::problemsWanted, this, [this] { Docks::reveal(m_docks->problems); });
    connect(&m_files->saving, &SaveFlow::historyWanted, this, [this] { Docks::reveal(m_docks->history); });
    connect(&m_files->left, &LeftWork::historyWanted, this, [this] { Docks::reveal(m_docks->history); });
    connect(&m_files->talk, &FileTalk::done, m_status, &StatusLine::flash);
    connect(m_fabricCommands, &FabricCommands::done, m_status, &StatusLine::flash);
    connect(&m_files->imports, &ImportFlow::imported, this, [this](FileKind kind) { // what came in is to be seen
        command(kind == FileKind::Cloud ? "layer.scans" : "layer.frames")->setChecked(true);
        // Keys mean the view, not the name in the properties that are there now.
        QMetaObject::invokeMethod(
            m_coverView, [this] { m_coverView->setFocus(Qt::OtherFocusReason); }, Qt::QueuedConnection);
    });
    connect(&m_files->imports, &ImportFlow::patternImported, this, [this](const std::vector<ElementId>& patches) {
        // So many are looked at one by one.
        if (patches.size() <= mostSelectedAtOnce)
            m_selection.set({patches.begin(), patches.end()});
        else
            m_selection.set({});
        command("view.fit-all")->trigger();
        m_status->flash(tr("%n pieces are in the pattern. Seam > Propose seams finds what belongs together.",
                           nullptr, static_cast<int>(patches.size())));
    });
    connect(m_status, &StatusLine::problemsWanted, this, [this] { Docks::reveal(m_docks->problems); });
}

/// Without those that a warning about the pattern says already.
std::vector<CoverFinding> MainWindow::findingsToSay() const
{
    std::vector<CoverFinding> findings = m_findings->findings();
    std::erase_if(findings, [this](const CoverFinding& finding) {
        return finding.kind == CoverFinding::Kind::Free && m_problems.hasWarning(finding.element);
    });
    return findings;
}

/// As many as the list has.
void MainWindow::countProblems()
{
    m_status->setProblems(m_problems.count(Severity::Error),
                          m_problemList->count() - m_problems.count(Severity::Error));
}

void MainWindow::connectFindings()
{
    // What is not on the screen yet is not called good.
    const auto update = [this] {
        const bool seen = m_coverView->pictures(m_solver->surface()) && m_covers->isTrimmed();
        const bool known = seen && m_findings->known() && m_solver->atRest();
        const std::vector<CoverFinding> findings = findingsToSay();
        m_status->setFindings(findings, known);
        m_problemList->setFindings(findings, known);
        countProblems();
        if (known && findings.empty() && std::exchange(m_findingMarked, false))
            m_mapCommands->hideSpot();
    };
    connect(m_findings.get(), &FindingsLink::changed, this, update);
    // A window that is destroyed hides its docks, when the findings are gone.
    connect(m_coverView, &CoverView::pictured, m_findings.get(), update);
    connect(m_covers.get(), &CoverLink::trimmed, m_findings.get(), update);
    connect(m_docks->cover, &QDockWidget::visibilityChanged, m_findings.get(), update);
    connect(m_status, &StatusLine::culpritWanted, this, &MainWindow::showProblem);
    const auto showFinding = [this](const CoverFinding& finding) {
        if (!document().design().element(finding.element))
            return;
        m_selection.set({finding.element});
        m_findingMarked = finding.place.has_value();
        if (finding.place)
            m_mapCommands->showSpot({finding.place->patch, finding.place->outline});
        else
            m_viewCommands->fitSelection();
    };
    connect(m_status, &StatusLine::findingWanted, this, showFinding);
    connect(m_problemList, &ProblemsView::findingChosen, this, showFinding);
}

void MainWindow::connectKeyboard()
{
    connect(m_elements, &ElementsView::propertiesWanted, this, [this] {
        Docks::reveal(m_docks->inspector);
        m_inspector->focusFirst();
    });
    // Keys mean the view again in which one was before, not the next field.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, QWidget* now) {
        if (now == m_pattern || now == m_coverView)
            m_lastView = now;
    });
    connect(
        m_inspector, &Inspector::typed, this,
        [this] { (m_lastView ? m_lastView : m_pattern)->setFocus(Qt::OtherFocusReason); }, Qt::QueuedConnection);
    const QList<QDockWidget*> parts = m_docks->all();
    for (qsizetype i = 1; i < parts.size(); ++i)
        setTabOrder(parts[i - 1]->widget(), parts[i]->widget());
}

/// Beside the lists, without taking their place: what is over in a moment is not seen.
void MainWindow::connectJobs()
{
    m_jobsSeen.setSingleShot(true);
    m_jobsSeen.setInterval(std::chrono::seconds(1));
    connect(&m_jobsSeen, &QTimer::timeout, this, [this] {
        if (!m_docks->jobs->isVisible() && !Jobs::all().running().isEmpty()) {
            m_docks->jobs->show();
            m_jobsShown = true;
        }
    });
    connect(&Jobs::all(), &Jobs::changed, this, [this] {
        if (!Jobs::all().running().isEmpty()) {
            m_jobsSeen.start();
            return;
        }
        m_jobsSeen.stop();
        if (std::exchange(m_jobsShown, false))
            m_docks->jobs->hide();
    });
}

/// What the start page lies over is neither drawn nor dressed; who can see a fabric elsewhere sees what it is like.
/// The first cover comes before its fabric, which takes what solving and drawing would need meanwhile.
void MainWindow::connectStartPage()
{
    m_fabricsAwaited.setSingleShot(true);
    m_fabricsAwaited.setInterval(std::chrono::seconds(1)); // there may be no cover, or one that takes its time
    connect(&m_fabricsAwaited, &QTimer::timeout, m_fabricLink.get(), &FabricLink::begin);
    connect(m_startPage, &StartPage::toggled, this, &MainWindow::pageMoved);
    connect(m_docks->cover, &QDockWidget::topLevelChanged, this, &MainWindow::pageMoved);
    connect(m_docks->fabrics, &QDockWidget::visibilityChanged, m_fabricLink.get(), [this](bool seen) {
        if (seen)
            m_fabricLink->begin();
    });
    connect(&m_selection, &Selection::changed, m_fabricLink.get(), [this] {
        const auto isFabric = [this](ElementId id) { return document().design().find<Fabric>(id) != nullptr; };
        if (std::ranges::any_of(m_selection.elements(), isFabric))
            m_fabricLink->begin();
    });
}

void MainWindow::pageMoved()
{
    const bool covered = m_startPage->isOpen() && !m_docks->cover->isFloating();
    m_coverView->setCovered(covered);
    if (m_wasShown && !covered && !m_fabricLink->begun())
        m_fabricsAwaited.start();
}

} // namespace bolster
