#include "Actions.h"

#include "CoverMap.h"
#include "Icons.h"
#include "Seam.h"
#include "SurfaceView.h"
#include "Theme.h"
#include "Units.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QHash>
#include <QSet>

namespace bolster {

namespace {

/// The English texts of all that was translated.
QHash<QString, QString>& englishTexts()
{
    static QHash<QString, QString> texts;
    return texts;
}

/// "&Import frame ..." is "import-frame".
QString idOf(const QString& english)
{
    QString id;
    for (const QChar c : english.toLower()) {
        if (c.isLetterOrNumber())
            id += c;
        else if (c != u'&' && !id.isEmpty() && !id.endsWith(u'-'))
            id += u'-';
    }
    return id.endsWith(u'-') ? id.chopped(1) : id;
}

} // namespace

Actions::Actions(QObject* parent)
    : QObject(parent)
{
    addFile();
    addEdit();
    addView();
    addInsert();
    addPattern();
    addSeams();
    addFixing();
    add3D();
    addPatternEdits();
    addDrawing();
    addTwins();
    addScans();
    addFabrics();
    addRest();
    giveIds();
}

QString Actions::tr(const char* text, const char* comment, int n)
{
    const QString translated = QCoreApplication::translate("bolster::Actions", text, comment, n);
    englishTexts().insert(translated, QString::fromUtf8(text));
    return translated;
}

void Actions::giveIds()
{
    QSet<QString> taken;
    for (QAction* action : findChildren<QAction*>(Qt::FindDirectChildrenOnly)) {
        const QString id = idOf(englishTexts().value(action->text(), action->text()));
        QString free = id;
        for (int i = 2; taken.contains(free); ++i)
            free = QStringLiteral("%1-%2").arg(id).arg(i);
        taken.insert(free);
        action->setObjectName(free);
    }
}

QString Actions::plainText(const QAction& action)
{
    QString text = action.iconText();
    return text.remove(u'&').remove(QStringLiteral("\u2026")).trimmed();
}

void Actions::describe(QAction& action)
{
    const QString text = plainText(action);
    const QKeySequence key = action.shortcut();
    action.setToolTip(key.isEmpty() ? text
                                    : QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
}

QAction* Actions::add(const QString& text, const QString& iconName, const QKeySequence& shortcut)
{
    auto* action = new QAction(text, this);
    if (!iconName.isEmpty())
        action->setIcon(icon(iconName));
    action->setShortcut(shortcut);
    action->setMenuRole(QAction::NoRole);
    describe(*action);
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
    saveCopy = add(tr("With &everything \u2026"), {});
    saveCopyWithoutHistory = add(tr("Without &history \u2026"), {});
    saveCopyWithoutScans = add(tr("Without history and &scans \u2026"), {});
    revert = add(tr("Re&vert to saved"), {});
    importFrame =
        add(tr("&Import frame \u2026"), QStringLiteral("import-frame"), QKeySequence(Qt::CTRL | Qt::Key_I));
    importScan = add(tr("Impor&t scan \u2026"), QStringLiteral("import-scan"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    exportSurface = add(tr("&Export surface \u2026"), QStringLiteral("export"), QKeySequence(Qt::CTRL | Qt::Key_E));
    exportPicture = add(tr("Export &picture \u2026"), QStringLiteral("picture"));
    renderPicture = add(tr("Ren&der picture \u2026"), QStringLiteral("picture"), QKeySequence(Qt::Key_F12));
    renderPicture->setShortcuts({QKeySequence(Qt::Key_F12), QKeySequence::Print}); // there is nothing else to print
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
    nameBranch = add(tr("Name this &branch \u2026"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F2));
    nameBranch->setToolTip(tr("Name the way that the history has gone since it forked (%1)")
                               .arg(nameBranch->shortcut().toString(QKeySequence::NativeText)));
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
    showChecker = addToggle(tr("Chec&ker"), QStringLiteral("checker"), false, QKeySequence(Qt::Key_C));
    showFrames = addToggle(tr("&Frame"), QStringLiteral("frame"), true, QKeySequence(Qt::Key_R));
    showPoints = addToggle(tr("Control po&ints"), QStringLiteral("points"), true);
    showSeams = addToggle(tr("Sea&ms and fixations"), QStringLiteral("seams"), true, QKeySequence(Qt::Key_S));
    showCurves = addToggle(tr("Fixation c&urves"), QStringLiteral("curves"), true);
    showGrid = addToggle(tr("&Grid"), QStringLiteral("grid"), true, QKeySequence(Qt::Key_G));
    showLabels = addToggle(tr("&Labels"), QStringLiteral("labels"), true);
    showScans = addToggle(tr("Sca&ns"), QStringLiteral("scan"), true, QKeySequence(Qt::Key_A));
    showScanPairs = addToggle(tr("Pairs of co&ver and scan"), {}, false);
    showScanColors = addToggle(tr("Own &colours of scans"), {}, true);
    showDeviation =
        addToggle(tr("&Deviation from the scan"), QStringLiteral("deviation"), false, QKeySequence(Qt::Key_D));
    const struct {
        CoverMap::Kind kind;
        QString name;
    } coverMaps[] = {
        {CoverMap::Kind::Strain, tr("&Largest strain")},
        {CoverMap::Kind::Along, tr("Strain al&ong the grain")},
        {CoverMap::Kind::Across, tr("Strain a&cross the grain")},
        {CoverMap::Kind::Shear, tr("&Shear")},
        {CoverMap::Kind::Curvature, tr("&Mean curvature")},
        {CoverMap::Kind::Thickness, tr("Distance to the &frame")},
    };
    auto* mapGroup = new QActionGroup(this); // one at a time, or none
    mapGroup->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    mapGroup->addAction(showDeviation);
    for (const auto& [kind, name] : coverMaps) {
        QAction* action = addToggle(name, {}, false);
        action->setData(static_cast<int>(kind));
        mapGroup->addAction(action);
        maps.append(action);
    }
    showSpotList = add(tr("Show worst spots as a l&ist"), {});
    showGround = addToggle(tr("Gr&ound"), {}, true);
    showField = addToggle(tr("Cushionin&g"), QStringLiteral("cushion"), false, QKeySequence(Qt::Key_U));

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
    addTool(Kind::Outline, tr("Draw &outline"), QStringLiteral("outline"), QKeySequence(Qt::Key_O));
    addTool(Kind::Rectangle, tr("Draw &rectangle"), QStringLiteral("rectangle"),
            QKeySequence(Qt::SHIFT | Qt::Key_R));
    addTool(Kind::Ellipse, tr("Draw &ellipse"), QStringLiteral("ellipse"), QKeySequence(Qt::SHIFT | Qt::Key_E));
    addTool(Kind::Split, tr("S&plit patch"), QStringLiteral("split"), QKeySequence(Qt::Key_K));
    addTool(Kind::HandleCurve, tr("Draw &handle curve"), QStringLiteral("handle-curve"), QKeySequence(Qt::Key_H));
    addTool(Kind::FancySeam, tr("Draw &fancy seam"), QStringLiteral("fancy-seam"), QKeySequence(Qt::Key_N));
    sew = addTool(Kind::Sew, tr("Se&w"), QStringLiteral("sew"), QKeySequence(Qt::Key_W));
    addTool(Kind::Attach, tr("&Attach to fixation curve"), QStringLiteral("attach"),
            QKeySequence(Qt::SHIFT | Qt::Key_A));
    addTool(Kind::Trim, tr("Stitch or pipe a seam"), QStringLiteral("outline-trim"),
            QKeySequence(Qt::SHIFT | Qt::Key_T));
    addTool(Kind::Measure, tr("&Measure"), QStringLiteral("measure"), QKeySequence(Qt::SHIFT | Qt::Key_M));
}

void Actions::addSeams()
{
    flipSeams = add(tr("&Flip"), QStringLiteral("flip-seam"), QKeySequence(Qt::SHIFT | Qt::Key_W));
    swapSeamSides = add(tr("Swap si&des"), QStringLiteral("swap"));
    const struct {
        Continuity continuity;
        QString name;
        Qt::Key key;
    } continuities[] = {
        {Continuity::C0, tr("C&0 \u2013 an edge"), Qt::Key_0},
        {Continuity::C1, tr("C&1 \u2013 smooth, texture too"), Qt::Key_1},
        {Continuity::G1, tr("&G1 \u2013 rounded"), Qt::Key_2},
    };
    for (const auto& [continuity, name, key] : continuities) {
        seamContinuities.append(addToggle(name, {}, false, QKeySequence(Qt::CTRL | key)));
        seamContinuities.back()->setData(static_cast<int>(continuity));
    }
    for (const auto& [match, name] : {std::pair(Match::Length, tr("Match by &length")),
                                      std::pair(Match::Parameter, tr("Match by &parameter"))}) {
        seamMatches.append(addToggle(name, {}, false));
        seamMatches.back()->setData(static_cast<int>(match));
    }
    showSeamList = add(tr("Show seam li&st"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W));
}

void Actions::addFixing()
{
    surfaceTools.append(addToggle(tr("&Draw fixation curve"), QStringLiteral("draw-fixation"), false,
                                  QKeySequence(Qt::SHIFT | Qt::Key_F)));
    surfaceTools.back()->setData(static_cast<int>(SurfaceToolKind::DrawFixation));
    createFixation = add(tr("&Create fixation curve"), QStringLiteral("create-fixation"),
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F));
}

void Actions::add3D()
{
    showHandles = addToggle(tr("&Handle curves"), QStringLiteral("handle-curve"), true);
    showFancySeams = addToggle(tr("Fanc&y seams"), QStringLiteral("fancy-seam"), true);
    linkViews =
        addToggle(tr("Lin&k the views"), QStringLiteral("link-views"), true, QKeySequence(Qt::SHIFT | Qt::Key_L));
    linkViews->setToolTip(tr("Show the pointer's place in the other view, too (%1)")
                              .arg(linkViews->shortcut().toString(QKeySequence::NativeText)));
    hideSelected = add(tr("&Hide selected"), QStringLiteral("hide"), QKeySequence(Qt::SHIFT | Qt::Key_H));
    isolate = add(tr("&Isolate selected"), QStringLiteral("isolate"), QKeySequence(Qt::SHIFT | Qt::Key_I));
    showHidden = add(tr("Sho&w hidden again"), QStringLiteral("show-hidden"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H));
    section = addToggle(tr("Sec&tion"), QStringLiteral("section"), false, QKeySequence(Qt::SHIFT | Qt::Key_X));
    saveView = add(tr("&Save view \u2026"), {});
}

void Actions::addDrawing()
{
    snapping = addToggle(tr("S&napping"), QStringLiteral("snapping"), true, QKeySequence(Qt::SHIFT | Qt::Key_S));
    showRulers =
        addToggle(tr("&Rulers"), QStringLiteral("rulers"), true, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
    showGuides = addToggle(tr("Gui&des"), {}, true, QKeySequence(Qt::SHIFT | Qt::Key_G));
    removeGuides = add(tr("Remove all g&uides"), {});
    lasso =
        addToggle(tr("Select with a &loop"), QStringLiteral("lasso"), false, QKeySequence(Qt::SHIFT | Qt::Key_Q));

    background = add(tr("&Open picture \u2026"), QStringLiteral("picture"));
    showBackground = addToggle(tr("Sho&w"), {}, true, QKeySequence(Qt::SHIFT | Qt::Key_B));
    scaleBackground = add(tr("&Scale by two points"), {});
    moveBackground = add(tr("&Move"), {});
    auto* opacities = new QActionGroup(this);
    for (const double opacity : {1.0, 0.6, 0.3}) {
        QAction* action = addToggle(tr("Opacity %1").arg(percentText(opacity)), {}, opacity == 0.6);
        action->setData(opacity);
        opacities->addAction(action);
        backgroundOpacities.append(action);
    }
    removeBackground = add(tr("&Remove"), {});
}

void Actions::addTwins()
{
    makeTwin = add(tr("Make &mirror twin"), QStringLiteral("twin"), QKeySequence(Qt::CTRL | Qt::Key_T));
    showTwins = addToggle(tr("Mirror image of the &selection"), QStringLiteral("twin"), true);
    showSymmetry = addToggle(tr("Symmetry &axis and plane"), {}, true);
    linkTwins = add(tr("Link as t&wins"), {});
    unlinkTwins = add(tr("&Unlink twins"), {});
    releasePoints = add(tr("R&elease points from the twin"), {}, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_T));
    relinkPoints = add(tr("Re-l&ink points to the twin"), {}, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T));
    symmetry = add(tr("S&ymmetry \u2026"), {});
}

void Actions::addScans()
{
    const auto addWith = [this](const QString& text, const QKeySequence& keys, const QString& tip) {
        QAction* action = add(text, {}, keys);
        action->setToolTip(
            keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
        return action;
    };
    placeScan = addWith(tr("&Place on the cover"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P),
                        tr("Moves and turns the scan so that it lies on the cover as well as it can"));
    cutScan = addWith(tr("&Cut away \u2026"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_X),
                      tr("Drag a rectangle in the 3D view over what is to be cut away of the scan"));
    keepScan = addWith(tr("&Keep only \u2026"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_K),
                       tr("Drag a rectangle in the 3D view around what is to be kept of the scan"));
    keepAroundCover = addWith(tr("Keep &around the cover"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_A),
                              tr("Cuts away what is farther from the cover than the threshold"));
    removeCuts = addWith(tr("&Remove all cuts"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_R),
                         tr("Brings back all that was cut away of the scan"));
    replaceScan = addWith(tr("Choose another &file \u2026"), {}, tr("Reads the scan from another file"));
}

void Actions::addFabrics()
{
    const auto addWith = [this](const QString& text, const QString& iconName, const QString& tip) {
        QAction* action = add(text, iconName);
        action->setToolTip(tip);
        return action;
    };
    newFabric = addWith(tr("&New fabric"), QStringLiteral("fabric"),
                        tr("Adds leather, weave, velvet or another fabric to the library of the design"));
    newPictureFabric = addWith(tr("From a &picture \u2026"), {},
                               tr("A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR"));
    importFabrics =
        addWith(tr("&Import fabrics \u2026"), {}, tr("Takes over the fabrics of a file, a design or a project"));
    exportFabric =
        addWith(tr("&Export fabric \u2026"), {}, tr("Writes the fabric to a file, its picture beside it"));
    assignFabric = addWith(tr("&Assign to selection"), QStringLiteral("patch"),
                           tr("Gives the selected patches the fabric that is chosen in the library"));
    editFabric = addWith(tr("Fabric p&roperties"), QStringLiteral("settings"),
                         tr("Shows kind, colours, size and limits of the fabric"));
    fabricPicture = addWith(tr("Picture on the &fabric \u2026"), QStringLiteral("picture"),
                            tr("Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR"));
    duplicateFabric = addWith(tr("D&uplicate fabric"), {}, tr("Adds a copy of the fabric, to be changed"));
    renameFabric = addWith(tr("Rename fa&bric \u2026"), {}, tr("Gives the fabric another name"));
    removeFabric = addWith(tr("&Delete fabric \u2026"), QStringLiteral("delete"),
                           tr("Removes the fabric; asks what patches get instead"));
    fabricsOnCushions = addToggle(tr("On &cushions"), QStringLiteral("pillow"), true);
    fabricsOnCushions->setToolTip(tr("Shows the fabrics of the library on cushions"));
    fabricsOnBalls = addToggle(tr("On &balls"), QStringLiteral("ball"), false);
    fabricsOnBalls->setToolTip(tr("Shows the fabrics of the library on balls"));
    auto* shapes = new QActionGroup(this);
    shapes->addAction(fabricsOnCushions);
    shapes->addAction(fabricsOnBalls);
    newColourway = addWith(tr("New &colourway \u2026"), QStringLiteral("colourway"),
                           tr("Adds a set of fabrics for the patches; it begins as what is shown now"));
    showColourway = addWith(tr("&Show colourway"), {}, tr("Chooses which fabrics are seen; the shape stays"));
    renameColourway =
        addWith(tr("Rena&me colourway \u2026"), {}, tr("Gives the colourway that is shown another name"));
    removeColourway = addWith(tr("De&lete colourway"), {}, tr("Removes the colourway that is shown"));
    compareColourways = addWith(tr("Compare c&olourways \u2026"), {}, tr("Shows two colourways side by side"));
}

void Actions::addRest()
{
    turnLeft =
        add(tr("Turn 90\u00b0 to the &left"), QStringLiteral("rotate-left"), QKeySequence(Qt::CTRL | Qt::Key_L));
    turnRight = add(tr("Turn 90\u00b0 to the &right"), QStringLiteral("rotate-right"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L));
    pause = addToggle(tr("&Pause"), QStringLiteral("pause"), false);
    pause->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Period), QKeySequence(Qt::Key_Pause)});
    describe(*pause);
    report = add(tr("&Figures \u2026"), {});
    resetLayout = add(tr("&Reset layout"), {});
    nextPart = add(tr("&Next part of the window"), {}, QKeySequence(Qt::Key_F6));
    previousPart = add(tr("Pre&vious part of the window"), {}, QKeySequence(Qt::SHIFT | Qt::Key_F6));
    findCommand =
        add(tr("&Find a command \u2026"), QStringLiteral("search"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P));
    editShortcuts = add(tr("&Edit shortcuts \u2026"), {});
    shortcuts = add(tr("&Keys and mouse \u2026"), {}, QKeySequence(Qt::Key_F1));
    about = add(tr("&About Bolster"), {});
}

} // namespace bolster
