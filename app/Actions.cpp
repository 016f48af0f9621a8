#include "Actions.h"

#include "Icons.h"
#include "SurfaceView.h"
#include "Theme.h"

#include <QActionGroup>

namespace bolster {

Actions::Actions(QObject* parent)
    : QObject(parent)
{
    addFile();
    addEdit();
    addView();
    addInsert();
    addPattern();
    addTwins();
    addRest();
}

QAction* Actions::add(const QString& text, const QString& iconName, const QKeySequence& shortcut)
{
    auto* action = new QAction(text, this);
    if (!iconName.isEmpty())
        action->setIcon(icon(iconName));
    action->setShortcut(shortcut);
    action->setMenuRole(QAction::NoRole);
    QString tip = text;
    tip.remove(u'&').remove(QStringLiteral("\u2026"));
    tip = tip.trimmed();
    action->setToolTip(
        shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut.toString(QKeySequence::NativeText)));
    return action;
}

QAction* Actions::addToggle(const QString& text, const QString& iconName, bool on, const QKeySequence& shortcut)
{
    QAction* action = add(text, iconName, shortcut);
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

void Actions::addFile()
{
    newDesign = add(tr("&New"), QStringLiteral("new"), QKeySequence::New);
    open = add(tr("&Open \u2026"), QStringLiteral("open"), QKeySequence::Open);
    save = add(tr("&Save"), QStringLiteral("save"), QKeySequence::Save);
    saveAs = add(tr("Save &as \u2026"), QStringLiteral("save-as"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    importFrame =
        add(tr("&Import frame \u2026"), QStringLiteral("import-frame"), QKeySequence(Qt::CTRL | Qt::Key_I));
    importScan = add(tr("I&mport scan \u2026"), QStringLiteral("import-scan"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    exportSurface = add(tr("&Export surface \u2026"), QStringLiteral("export"), QKeySequence(Qt::CTRL | Qt::Key_E));
    exportPicture = add(tr("Export &picture \u2026"), QStringLiteral("picture"));
    quit = add(tr("&Quit"), {}, QKeySequence(Qt::CTRL | Qt::Key_Q));
}

void Actions::addEdit()
{
    undo = add(tr("&Undo"), QStringLiteral("undo"), QKeySequence::Undo);
    undo->setIconText(tr("Undo")); // the text says what would be undone
    redo = add(tr("&Redo"), QStringLiteral("redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    redo->setIconText(tr("Redo"));
    remove = add(tr("&Delete"), QStringLiteral("delete"), QKeySequence::Delete);
    rename = add(tr("Re&name"), {}, QKeySequence(Qt::Key_F2));
    selectAll = add(tr("Select &all patches"), {}, QKeySequence::SelectAll);
    selectNone = add(tr("Select n&othing"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
}

void Actions::addView()
{
    fitAll = add(tr("Show &all"), QStringLiteral("fit-all"), QKeySequence(Qt::Key_Home));
    fitSelection = add(tr("Show &selection"), QStringLiteral("fit-selection"), QKeySequence(Qt::Key_F));

    using View = SurfaceView::StandardView;
    const struct {
        View view;
        QString name;
        Qt::Key key;
    } views[] = {
        {View::Front, tr("&Front"), Qt::Key_1},
        {View::Back, tr("&Back"), Qt::Key_2},
        {View::Left, tr("&Left"), Qt::Key_3},
        {View::Right, tr("&Right"), Qt::Key_4},
        {View::Top, tr("&Top"), Qt::Key_5},
        {View::Bottom, tr("B&ottom"), Qt::Key_6},
        {View::ThreeQuarter, tr("Three-&quarter"), Qt::Key_0},
    };
    for (const auto& [view, name, key] : views) {
        standardViews.append(add(name, {}, QKeySequence(key)));
        standardViews.back()->setData(static_cast<int>(view));
    }
    perspective = addToggle(tr("&Perspective"), QStringLiteral("perspective"), true, QKeySequence(Qt::Key_P));

    showMesh = addToggle(tr("&Triangulation"), QStringLiteral("mesh"), false, QKeySequence(Qt::Key_M));
    showChecker = addToggle(tr("&Checker"), QStringLiteral("checker"), true, QKeySequence(Qt::Key_C));
    showFrames = addToggle(tr("&Frame"), QStringLiteral("frame"), true, QKeySequence(Qt::Key_R));
    showPoints = addToggle(tr("Control &points"), QStringLiteral("points"), true);
    showSeams = addToggle(tr("&Seams and fixations"), QStringLiteral("seams"), true, QKeySequence(Qt::Key_S));
    showCurves = addToggle(tr("Fixation c&urves"), QStringLiteral("curves"), true);
    showGrid = addToggle(tr("&Grid"), QStringLiteral("grid"), true, QKeySequence(Qt::Key_G));
    showLabels = addToggle(tr("&Labels"), QStringLiteral("labels"), true);
    showScans = addToggle(tr("Sc&ans"), QStringLiteral("scan"), true, QKeySequence(Qt::Key_A));
    showScanPairs = addToggle(tr("Pairs of co&ver and scan"), {}, false);
    showDeviation =
        addToggle(tr("&Deviation from the scan"), QStringLiteral("deviation"), false, QKeySequence(Qt::Key_D));
    showGround = addToggle(tr("Gr&ound"), {}, true);
    showField = addToggle(tr("Cus&hioning"), QStringLiteral("cushion"), false, QKeySequence(Qt::Key_U));

    auto* themeGroup = new QActionGroup(this);
    const Theme now = storedTheme();
    for (const auto& [theme, name] : {std::pair(Theme::System, tr("As the &system")),
                                      std::pair(Theme::Light, tr("&Light")), std::pair(Theme::Dark, tr("&Dark"))}) {
        QAction* action = addToggle(name, {}, theme == now);
        action->setData(static_cast<int>(theme));
        themeGroup->addAction(action);
        themes.append(action);
    }
}

void Actions::addInsert()
{
    insertCushion = add(tr("&Cushion"), QStringLiteral("cushion"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    const struct {
        Foam::Shape shape;
        QString name;
        QKeySequence key;
    } shapes[] = {
        {Foam::Shape::Box, tr("&Box of foam"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B)},
        {Foam::Shape::Cylinder, tr("C&ylinder of foam"), {}},
        {Foam::Shape::Sphere, tr("&Sphere of foam"), {}},
    };
    for (const auto& [shape, name, key] : shapes) {
        insertFoam.append(add(name, QStringLiteral("foam"), key));
        insertFoam.back()->setData(static_cast<int>(shape));
    }
}

QAction* Actions::addTool(PatternToolKind kind, const QString& text, const QString& iconName,
                          const QKeySequence& shortcut)
{
    QAction* action = addToggle(text, iconName, false, shortcut);
    action->setData(static_cast<int>(kind));
    patternTools.append(action);
    return action;
}

void Actions::addPattern()
{
    using Kind = PatternToolKind;
    addTool(Kind::Select, tr("&Select and move"), QStringLiteral("select"), QKeySequence(Qt::Key_V))
        ->setChecked(true);
    addTool(Kind::HandleCurve, tr("Draw &handle curve"), QStringLiteral("handle-curve"), QKeySequence(Qt::Key_H));
    addTool(Kind::FancySeam, tr("Draw &fancy seam"), QStringLiteral("fancy-seam"), QKeySequence(Qt::Key_N));
}

void Actions::addTwins()
{
    makeTwin = add(tr("Make &mirror twin"), QStringLiteral("twin"), QKeySequence(Qt::CTRL | Qt::Key_T));
    linkTwins = add(tr("Link as t&wins"), {});
    unlinkTwins = add(tr("&Unlink twins"), {});
    releasePoints = add(tr("R&elease points from the twin"), {}, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_T));
    relinkPoints = add(tr("Re-l&ink points to the twin"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T));
    symmetry = add(tr("S&ymmetry \u2026"), {});
}

void Actions::addRest()
{
    turnLeft =
        add(tr("Turn 90\u00b0 to the &left"), QStringLiteral("rotate-left"), QKeySequence(Qt::CTRL | Qt::Key_L));
    turnRight = add(tr("Turn 90\u00b0 to the &right"), QStringLiteral("rotate-right"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L));
    settle = add(tr("&Settle"), QStringLiteral("settle"), QKeySequence(Qt::CTRL | Qt::Key_Return));
    pause = addToggle(tr("&Pause"), QStringLiteral("pause"), false, QKeySequence(Qt::CTRL | Qt::Key_P));
    report = add(tr("&Figures \u2026"), {});
    resetLayout = add(tr("&Reset layout"), {});
    shortcuts = add(tr("&Keys and mouse \u2026"), {}, QKeySequence(Qt::Key_F1));
    about = add(tr("&About Bolster"), {});
}

} // namespace bolster
