// Everything the user can ask for, each with its text, icon and shortcut. What happens then, others decide.
#pragma once

#include "PatternTools.h"

#include <QAction>
#include <QList>
#include <QObject>

namespace bolster {

class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QObject* parent = nullptr);

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
    QAction* makeTwin;
    QAction* linkTwins;
    QAction* unlinkTwins;
    QAction* releasePoints;
    QAction* relinkPoints;
    QAction* symmetry;
    // Surface
    QAction* settle;
    QAction* pause;
    QAction* report;
    // Window, Help
    QAction* resetLayout;
    QAction* shortcuts;
    QAction* about;

private:
    QAction* add(const QString& text, const QString& iconName, const QKeySequence& shortcut = {});
    QAction* addToggle(const QString& text, const QString& iconName, bool on, const QKeySequence& shortcut = {});
    QAction* addTool(PatternToolKind kind, const QString& text, const QString& iconName,
                     const QKeySequence& shortcut);
    void addFile();
    void addEdit();
    void addView();
    void addInsert();
    void addPattern();
    void addTwins();
    void addRest();
};

} // namespace bolster
