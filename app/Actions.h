// Everything the user can ask for, each with its text, icon and shortcut. What happens then, others decide.
#pragma once

#include "PatternTools.h"

#include <QAction>
#include <QList>
#include <QObject>

namespace bolster {

/// Each action has an id as its object name ("import-frame"), made of its English text: the same in every language.
class Actions : public QObject {
public:
    explicit Actions(QObject* parent = nullptr);

    /// The action's text without mnemonic and dots; of undo and redo without what it would undo.
    static QString plainText(const QAction& action);
    /// Puts text and keys into the tooltip.
    static void describe(QAction& action);

    // File
    QAction* newDesign;
    QAction* open;
    QAction* save;
    QAction* saveAs;
    QAction* saveCopy;
    QAction* saveCopyWithoutHistory;
    QAction* saveCopyWithoutScans;
    QAction* revert;
    QAction* importFrame;
    QAction* importScan;
    QAction* exportSurface;
    QAction* exportPicture;
    QAction* renderPicture;
    QAction* quit;
    // Edit
    QAction* undo;
    QAction* redo;
    QAction* remove;
    QAction* rename;
    QAction* nameBranch;
    QAction* selectAll;
    QAction* selectNone;
    QAction* cut;
    QAction* copy;
    QAction* paste;
    QAction* duplicate;
    // View
    QAction* fitAll;
    QAction* fitSelection;
    QList<QAction*> standardViews; ///< data: SurfaceView::StandardView
    QAction* perspective;
    QAction* showMesh;
    QAction* showChecker;
    QAction* showFrames;
    QAction* showPoints;
    QAction* showSeams;
    QAction* showCurves;
    QAction* showGrid;
    QAction* showLabels;
    QAction* showScans;
    QAction* showScanPairs;
    QAction* showScanColors;
    QAction* showDeviation;
    QList<QAction*> maps; ///< data: CoverMap::Kind
    QAction* showSpotList;
    QAction* showGround;
    QAction* showField;
    QAction* showHandles;
    QAction* showFancySeams;
    QAction* linkViews;
    QAction* hideSelected;
    QAction* isolate;
    QAction* showHidden;
    QAction* section;
    QAction* saveView;
    QAction* snapping;
    QAction* showRulers;
    QAction* showGuides;
    QAction* removeGuides;
    QAction* lasso;
    QList<QAction*> themes; ///< data: Theme
    // Insert
    QAction* insertCushion;
    QList<QAction*> insertFoam; ///< data: Foam::Shape
    // Pattern
    QList<QAction*> patternTools; ///< data: PatternToolKind
    QList<QAction*> surfaceTools; ///< of the 3D view; data: SurfaceToolKind
    QAction* createFixation;
    QAction* background; ///< opens a picture
    QAction* showBackground;
    QAction* scaleBackground;
    QAction* moveBackground;
    QList<QAction*> backgroundOpacities; ///< data: 0 to 1
    QAction* removeBackground;
    QAction* turnLeft;
    QAction* turnRight;
    // Seam
    QAction* sew; ///< also one of the pattern tools
    QAction* flipSeams;
    QAction* swapSeamSides;
    QList<QAction*> seamContinuities; ///< data: Continuity
    QList<QAction*> seamMatches;      ///< data: Match
    QAction* showSeamList;
    QAction* mirrorHorizontally;
    QAction* mirrorVertically;
    QList<QAction*> align;      ///< data: edits::Alignment
    QList<QAction*> distribute; ///< data: edits::Direction
    QAction* arrange;
    QAction* makeCorner;
    QAction* makeSmooth;
    QAction* straighten;
    QAction* edgeLength;   ///< its field in the properties
    QAction* equalLengths; ///< of edges, or of the sides of seams
    QAction* mergePatches;
    QAction* makeTwin;
    QAction* linkTwins;
    QAction* showTwins;    ///< the mirror image of what is selected
    QAction* showSymmetry; ///< axis and plane
    QAction* unlinkTwins;
    QAction* releasePoints;
    QAction* relinkPoints;
    QAction* symmetry;
    // Scan
    QAction* placeScan;
    QAction* cutScan;
    QAction* keepScan;
    QAction* keepAroundCover;
    QAction* removeCuts;
    QAction* replaceScan;
    // Fabric
    QAction* newFabric; ///< its menu offers presets
    QAction* newPictureFabric;
    QAction* importFabrics;
    QAction* exportFabric;
    QAction* assignFabric;
    QAction* editFabric;
    QAction* fabricPicture;
    QAction* duplicateFabric;
    QAction* renameFabric;
    QAction* removeFabric;
    QAction* fabricsOnCushions; ///< this or the other
    QAction* fabricsOnBalls;
    QAction* newColourway;
    QAction* showColourway; ///< its menu has them all
    QAction* renameColourway;
    QAction* removeColourway;
    QAction* compareColourways;
    // Surface
    QAction* pause;
    QAction* report;
    // Window, Help
    QAction* resetLayout;
    QAction* nextPart;
    QAction* previousPart;
    QAction* findCommand;
    QAction* shortcuts;
    QAction* editShortcuts;
    QAction* about;

private:
    /// As QObject::tr; remembers the English texts for the ids.
    static QString tr(const char* text, const char* comment = nullptr, int n = -1);
    void giveIds();
    QAction* add(const QString& text, const QString& iconName, const QKeySequence& shortcut = {});
    QAction* addToggle(const QString& text, const QString& iconName, bool on, const QKeySequence& shortcut = {});
    QAction* addTool(PatternToolKind kind, const QString& text, const QString& iconName,
                     const QKeySequence& shortcut);
    void addFile();
    void addEdit();
    void addView();
    void addInsert();
    void addPattern();
    void addSeams();
    void addFixing();
    void add3D();
    void addPatternEdits();
    void addDrawing();
    void addTwins();
    void addScans();
    void addFabrics();
    void addRest();
};

} // namespace bolster
