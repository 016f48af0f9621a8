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
    QAction* importFrame;
    QAction* importScan;
    QAction* exportSurface;
    QAction* exportPicture;
    QAction* quit;
    // Edit
    QAction* undo;
    QAction* redo;
    QAction* remove;
    QAction* rename;
    QAction* selectAll;
    QAction* selectNone;
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
    QAction* showDeviation;
    QAction* showGround;
    QAction* showField;
    QList<QAction*> themes; ///< data: Theme
    // Insert
    QAction* insertCushion;
    QList<QAction*> insertFoam; ///< data: Foam::Shape
    // Pattern
    QList<QAction*> patternTools; ///< data: PatternToolKind
    QAction* turnLeft;
    QAction* turnRight;
    // Surface
    QAction* settle;
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
    void addRest();
};

} // namespace bolster
