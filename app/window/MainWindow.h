// The workbench: where all parts are wired.
#pragma once

#include "CoverView.h"
#include "DesignSession.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "SolverLink.h"

#include <QMainWindow>
#include <QTimer>

#include <memory>
#include <vector>

class QAction;

namespace bolster {

class Banner;
class CommandPalette;
class Commands;
class CoverAtRest;
class Docks;
class DropFlow;
class ElementsView;
class FabricCommands;
class FabricLink;
class FabricPanel;
class FindingsLink;
class HistoryPanel;
class Inspector;
class LayerCommands;
struct CoverFinding;
class MapCommands;
class MapLink;
class PatternView;
class PreferenceStore;
class ProblemsView;
class CoverLink;
class CuttingPanel;
class ScanLink;
class SeamsView;
class SpotsPanel;
class StartCommands;
class StartPage;
class StatusLine;
class Tour;
class ViewCommands;
struct FileFlows;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a file as if it had been chosen in the dialog.
    void open(const QString& path);
    /// Offers what a crash has left.
    void recover();
    /// Shows the start page, as a program does that was started with nothing to open.
    void greet();

    DesignSession& session() { return *m_session; }
    Document& document() { return m_session->document(); }
    Selection& selection() { return m_selection; }
    SolverLink& solver() { return *m_solver; }
    ScanLink& scans() { return *m_scans; }
    MapLink& maps() { return *m_maps; }
    FindingsLink& findings() { return *m_findings; }
    Inspector& inspector() { return *m_inspector; }
    PatternView& patternView() { return *m_pattern; }
    CoverView& coverView() { return *m_coverView; }
    Commands& commands() { return *m_commands; }
    PreferenceStore& preferences() { return *m_preferences; }
    /// By its id.
    QAction* command(const char* id);
    SeamsView& seams() { return *m_seams; }
    Docks& docks() { return *m_docks; }
    CommandPalette& commandPalette() { return *m_palette; }
    Banner& banner() { return *m_banner; }
    StatusLine& statusLine() { return *m_status; }
    FileFlows& files() { return *m_files; }
    DropFlow& drops() { return *m_drops; }
    StartPage& startPage() { return *m_startPage; }
    Tour& tour() { return *m_tour; }
    FabricLink& fabricLink() { return *m_fabricLink; }
    FabricCommands& fabricCommands() { return *m_fabricCommands; }
    FabricPanel& fabricPanel() { return *m_fabricPanel; }
    SpotsPanel& spotsPanel() { return *m_spots; }
    CuttingPanel& cuttingPanel() { return *m_cutting; }

    /// Closes as always, with all questions; who agrees to it is to start the program again.
    void restart();

signals:
    /// It is closed, and shall be there again with this project or design; empty: there was none.
    void restartWanted(const QString& path);

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// Makes the commands of an area, which lives as long as the window.
    template <class Area, class... Needs>
    Area& addArea(Needs&&... needs);
    void addMessages();
    void addCommands();
    void addViewCommands();
    void addDesignCommands(CoverAtRest& cover);
    void connectSession();
    void connectDocument();
    void connectSolver();
    void connectViews();
    void connectContextMenus();
    void connectFiles();
    void connectFindings();
    void connectKeyboard();
    void connectJobs();
    void connectStartPage();
    void pageMoved();
    void askAboutJobs(bool restarts);
    void closeAgain(bool restarts);
    void tellDropped(const Design& before, const std::vector<ElementId>& ids);
    void designOpened();
    void keepCamera();
    void lookAtOpened();
    void updateTitle();
    void updateProblems();
    void countProblems();
    std::vector<CoverFinding> findingsToSay() const;
    void updateSolverState();
    void showProblem(ElementId element);
    void restoreSize();
    void arrange();
    void storeLayout();

    std::unique_ptr<PreferenceStore> m_preferences;
    std::unique_ptr<DesignSession> m_session;
    Selection m_selection;
    Selection m_coverSelection; ///< the same, but for what is hovered when the views are not linked
    ProblemSet m_problems;
    std::unique_ptr<SolverLink> m_solver;
    std::unique_ptr<ScanLink> m_scans;
    std::unique_ptr<MapLink> m_maps;
    std::unique_ptr<FindingsLink> m_findings;
    std::unique_ptr<CoverLink> m_covers;
    QTimer m_afterOpening; ///< until all that belonged to the design before is gone
    std::unique_ptr<FabricLink> m_fabricLink;
    FabricCommands* m_fabricCommands;
    Commands* m_commands;
    PatternView* m_pattern;
    CoverView* m_coverView;
    QWidget* m_lastView = nullptr; ///< of these two, that had the keyboard; null: none yet
    ElementsView* m_elements;
    HistoryPanel* m_history;
    Inspector* m_inspector;
    ProblemsView* m_problemList;
    SeamsView* m_seams;
    FabricPanel* m_fabricPanel;
    SpotsPanel* m_spots;
    CuttingPanel* m_cutting;
    StatusLine* m_status;
    Banner* m_banner;
    int m_toldDropped = 0; ///< the banner's number of that
    CommandPalette* m_palette = nullptr;
    std::unique_ptr<FileFlows> m_files;
    DropFlow* m_drops;
    std::unique_ptr<Docks> m_docks;
    StartPage* m_startPage = nullptr;
    std::vector<std::unique_ptr<QObject>> m_areas; ///< of commands; they go first
    ViewCommands* m_viewCommands = nullptr;
    MapCommands* m_mapCommands = nullptr;
    bool m_findingMarked = false; ///< its place, in both views
    StartCommands* m_startCommands = nullptr;
    Tour* m_tour = nullptr;
    bool m_jobsShown = false;   ///< by itself
    QTimer m_jobsSeen;          ///< a job takes longer than a moment: the list of jobs comes up
    QTimer m_fabricsAwaited;    ///< until the fabrics are baked even without a cover
    bool m_coverAwaited = true; ///< of this design none was on the screen yet
    bool m_fitCover = false;    ///< the next surface is the first of its design
    bool m_wasShown = false;
    bool m_arranged = false;    ///< docks and tool bars are where they were at the last end
    bool m_restarts = false;    ///< closing is for starting again
    bool m_workKept = false;    ///< closing was agreed to
    bool m_jobsGivenUp = false; ///< the same of what is still being worked at
};

} // namespace bolster
