// The workbench: where all parts are wired.
#pragma once

#include "DesignSession.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "SolverLink.h"
#include "SurfaceView.h"

#include <QMainWindow>

#include <functional>
#include <memory>

class QMenu;

namespace bolster {

class Actions;
class Banner;
class CommandPalette;
class Docks;
class ElementsView;
class FabricCommands;
class FabricLink;
class FabricPanel;
class FileFlow;
class FindingsLink;
class HistoryPanel;
class Inspector;
class MapLink;
class PatternView;
class ProblemsView;
class CoverLink;
class ScanLink;
class Thumbnails;
class SeamsView;
class Shortcuts;
class SpotsPanel;
class StatusLine;
enum class ScanWish;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a file as if it had been chosen in the dialog.
    void open(const QString& path);
    /// Offers what a crash has left.
    void recover();

    DesignSession& session() { return *m_session; }
    Document& document() { return m_session->document(); }
    Selection& selection() { return m_selection; }
    SolverLink& solver() { return *m_solver; }
    ScanLink& scans() { return *m_scans; }
    MapLink& maps() { return *m_maps; }
    FindingsLink& findings() { return *m_findings; }
    Inspector& inspector() { return *m_inspector; }
    PatternView& patternView() { return *m_pattern; }
    SurfaceView& surfaceView() { return *m_surface; }
    Actions& actions() { return *m_actions; }
    SeamsView& seams() { return *m_seams; }
    Docks& docks() { return *m_docks; }
    CommandPalette& commandPalette() { return *m_palette; }
    Banner& banner() { return *m_banner; }
    StatusLine& statusLine() { return *m_status; }
    FileFlow& files() { return *m_files; }
    FabricLink& fabricLink() { return *m_fabricLink; }
    FabricCommands& fabricCommands() { return *m_fabricCommands; }
    FabricPanel& fabricPanel() { return *m_fabricPanel; }
    SpotsPanel& spotsPanel() { return *m_spots; }

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void buildToolBars();
    void connectDocument();
    void connectViews();
    void connectActions();
    void connectTools();
    void updateToolActions();
    void connectViewActions();
    void designOpened();
    void keepCamera();
    void lookAtOpened();
    void updateTitle();
    void updateEditActions();
    void updateProblems();
    void updateSolverState();
    void withCoverAtRest(const std::function<void()>& then);
    void showMeasured();
    const SurfaceMapPtr& mapShown() const;
    void connectScans();
    void workOnScan(ElementId scan, ScanWish wish);
    void onTheScan(const std::function<void(ElementId)>& work);
    void updateScanActions();
    void connectSewing();
    void updateSeamActions();
    void connectFixing();
    void createFixation();
    void updateFixingActions();
    void connect3D();
    void linkViews();
    void linkSelections();
    void addOpacitySliders();
    void fillSavedViews(QMenu& menu);
    void saveView();
    void update3DActions();
    void connectDrawing();
    void connectBackground();
    void traceBackground(const QString& path);
    void connectPanels();
    void connectFirstSteps();
    void showDrawn();
    void compareWith(NodeId node);
    void focusNextPart(bool forward);
    void connectFabrics();
    void fillFabricMenus();
    void updateFabricActions();
    void chooseFabric(ElementId fabric);
    void editFabric(ElementId fabric);
    void compareColourways();
    void connectTwins();
    void updateTwinActions();
    void linkSelectedTwins();
    void commitOrTell(const Edit& edit, const QString& problem);
    void fitScanPlacement(ElementId scan);
    void connectMaps();
    void fillWorstSpots(QMenu& menu);
    void showSpot(const CoverPoint& place);
    void connectFindings();
    void readMap(const std::optional<CoverPoint>& place);
    void renderPicture();
    void connectPattern();
    void applyLayers();
    void insert(const Edit& edit, const QString& problem);
    void removeSelection();
    void turnSelection(double degrees);
    void showProblem(ElementId element);
    void fitSelection();
    void restoreSize();
    void storeLayout();

    std::unique_ptr<DesignSession> m_session;
    Selection m_selection;
    Selection m_surfaceSelection; ///< the same, but for what is hovered when the views are not linked
    ProblemSet m_problems;
    std::unique_ptr<SolverLink> m_solver;
    std::unique_ptr<ScanLink> m_scans;
    std::unique_ptr<MapLink> m_maps;
    std::unique_ptr<FindingsLink> m_findings;
    std::unique_ptr<CoverLink> m_covers;
    std::unique_ptr<Thumbnails> m_thumbnails;
    std::unique_ptr<FabricLink> m_fabricLink;
    FabricCommands* m_fabricCommands;
    Actions* m_actions;
    PatternView* m_pattern;
    SurfaceView* m_surface;
    QWidget* m_lastView = nullptr; ///< of these two, that had the keyboard; null: none yet
    ElementsView* m_elements;
    HistoryPanel* m_history;
    Inspector* m_inspector;
    ProblemsView* m_problemList;
    SeamsView* m_seams;
    FabricPanel* m_fabricPanel;
    SpotsPanel* m_spots;
    std::optional<CoverPoint> m_mapPlace; ///< under the pointer
    StatusLine* m_status;
    Banner* m_banner;
    CommandPalette* m_palette = nullptr;
    std::unique_ptr<Shortcuts> m_shortcuts;
    FileFlow* m_files;
    std::unique_ptr<Docks> m_docks;
    bool m_fitCover = false; ///< the next surface is the first of its design
    bool m_arranged = false; ///< docks and tool bars are where they were at the last end
    bool m_workKept = false; ///< closing was agreed to
};

} // namespace bolster
