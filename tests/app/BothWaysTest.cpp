// From a form to its pattern, and a pattern that follows a goal: by pointer and keys.
#include "WindowTest.h"

#include "AreaRow.h"
#include "CauseWindow.h"
#include "CoverNavigation.h"
#include "DesignJson.h"
#include "Designer.h"
#include "FlatPiecesView.h"
#include "FormPatternJob.h"
#include "FormPatternWindow.h"
#include "Jobs.h"
#include "MapLink.h"
#include "NumberBox.h"
#include "PatternFitWindow.h"
#include "ReliefWindow.h"
#include "RestingSolve.h"
#include "SurfaceExport.h"
#include "SweepWindow.h"
#include "TestPaths.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QSlider>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace bolster {
namespace {

constexpr double bowlRadius = 250, bowlHeight = 60; // mm

Vec3 onBowl(double x, double y)
{
    return {x, y, bowlHeight * (1 - (x * x + y * y) / (bowlRadius * bowlRadius))};
}

/// The back of a bucket seat: a round form, open below.
void writeBowl(const QString& path)
{
    constexpr int rings = 24, around = 72;
    QString text = "v 0 0 60\n";
    for (int r = 1; r <= rings; ++r)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around, radius = bowlRadius * r / rings;
            const Vec3 at = onBowl(radius * std::cos(angle), radius * std::sin(angle));
            text += QString("v %1 %2 %3\n").arg(at.x()).arg(at.y()).arg(at.z());
        }
    const auto vertex = [](int ring, int k) { return ring == 0 ? 1 : 2 + (ring - 1) * around + k % around; };
    for (int r = 0; r < rings; ++r)
        for (int k = 0; k < around; ++k) {
            text += QString("f %1 %2 %3\n").arg(vertex(r, k)).arg(vertex(r + 1, k)).arg(vertex(r + 1, k + 1));
            if (r > 0)
                text += QString("f %1 %2 %3\n").arg(vertex(r, k)).arg(vertex(r + 1, k + 1)).arg(vertex(r, k + 1));
        }
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.toUtf8());
}

void writeText(const QString& path, const std::string& text)
{
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
}

class BothWaysTest : public WindowTest {
protected:
    const Design& design() { return window.document().design(); }
    template <class T>
    int count()
    {
        int found = 0;
        design().each<T>([&](ElementId, const T&) { ++found; });
        return found;
    }

    void drawSeam(const std::vector<Vec3>& places)
    {
        designer.choose({"Frame", "Draw fixation curve"});
        for (const Vec3& place : places)
            designer.clickCover(place);
        designer.key(Qt::Key_Return);
        designer.key(Qt::Key_Escape);
    }

    /// Once the window has its size.
    static bool pointsAtAPiece(FlatPiecesView& pieces)
    {
        return QTest::qWaitFor(
            [&] {
                for (int x = 0; x < pieces.width() && !pieces.hovered(); x += 5)
                    QTest::mouseMove(&pieces, {x, pieces.height() / 2 - 20});
                return pieces.hovered().has_value();
            },
            10000);
    }

    /// What begins and stops work takes no click as soon as it has ended: that was meant to stop it.
    static void waitAsAHandDoes() { QTest::qWait(1100); }

    static void pressIn(QWidget& dialog, const QString& text)
    {
        for (auto* button : dialog.findChildren<QPushButton*>())
            if (button->text().remove('&').startsWith(text)) {
                ASSERT_TRUE(button->isEnabled());
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        FAIL() << "no button " << text.toStdString();
    }

    /// A design that has a frame, and nothing else.
    ElementId openFrame(const char* name, const char* file)
    {
        Frame frame;
        frame.name = name;
        frame.file = file;
        const Design empty;
        const QString path = folder.filePath("frame.json");
        writeText(path, writeDesign(empty.with({{}, {{empty.nextId(), nullptr, makeElement(frame)}}})));
        EXPECT_TRUE(open(path));
        waitForBackground();
        return empty.nextId();
    }

    PatternFitWindow* openFit()
    {
        designer.choose({"Pattern", "Fit to a goal"});
        return window.findChild<PatternFitWindow*>();
    }

    static bool says(const QWidget& dialog, const QString& words)
    {
        return std::ranges::any_of(dialog.findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    }

    QString lastStep()
    {
        const History& history = window.document().history();
        return QString::fromStdString(history.node(history.current()).edit.verb.english());
    }

    static QCheckBox* box(const QWidget& dialog, const QString& words)
    {
        for (auto* box : dialog.findChildren<QCheckBox*>())
            if (box->text().remove('&').contains(words))
                return box;
        return nullptr;
    }

    /// One step leads back to this design.
    void expectUndone(QWidget& dialog, const Design& before)
    {
        dialog.close();
        takeKeyboard();
        designer.key(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_EQ(writeDesign(design()), writeDesign(before));
    }

    /// A box cushion with pieces that are too large, beside a scan of one that is right.
    void openLargeCushion(bool pulls = false)
    {
        const QString path = sample("box-cushion");
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const Design right = readDesign(file.readAll().toStdString()).design;
        const SolveResult solved = solveResting(right, {});
        ASSERT_TRUE(solved.surface);
        ASSERT_TRUE(exportPly(*solved.surface, right, folder.filePath("built.ply")).empty());
        Design bent = right;
        std::vector<ElementId> patches;
        right.each<Patch>([&](ElementId id, const Patch& patch) {
            if (patch.twin)
                return;
            Patch wider = patch;
            std::vector<Vec2> points = patch.outline.points();
            const Vec2 middle = patch.outline.boundingBox().center();
            for (Vec2& point : points)
                point = middle + 1.03 * (point - middle);
            wider.outline = wider.outline.withPoints(points);
            bent = bent.with({{}, {{id, bent.element(id), makeElement(wider)}}});
            patches.push_back(id);
        });
        Scan scan;
        scan.name = "Built";
        scan.file = "built.ply";
        scan.enabled = pulls;
        bent = bent.with({{}, {{bent.nextId(), nullptr, makeElement(scan)}}});
        writeText(folder.filePath("cushion.json"), writeDesign(bent));
        ASSERT_TRUE(open(folder.filePath("cushion.json")));
        ASSERT_TRUE(waitUntilAtRest());
        waitForBackground();
    }

    Designer designer{window};
    QTemporaryDir folder;
};

TEST_F(BothWaysTest, ABucketSeatIsMadeOfAFormWithFourDrawnSeams)
{
    writeBowl(folder.filePath("bowl.obj"));
    openFrame("Bucket", "bowl.obj");
    window.coverView().navigation().setStandardView(CoverView::StandardView::Top);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window.coverView().navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-9); }, 10000));
    const double end = 0.985 * std::sqrt(bowlRadius * bowlRadius - 90.0 * 90.0);
    for (const double x : {-90.0, 90.0})
        drawSeam({onBowl(x, -end), onBowl(x, -end / 2), onBowl(x, 0), onBowl(x, end / 2), onBowl(x, end)});
    for (const double y : {-110.0, 110.0})
        drawSeam({onBowl(-88, y), onBowl(-45, y), onBowl(0, y), onBowl(45, y), onBowl(88, y)});
    ASSERT_EQ(count<FixationCurve>(), 4);

    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    EXPECT_EQ(dialog->made()->flat.size(), 5U);
    const int steps = window.document().history().count();
    pressIn(*dialog, "Make the pattern");
    EXPECT_EQ(count<Patch>(), 5);
    EXPECT_EQ(count<Seam>(), 8);
    EXPECT_EQ(window.document().history().count(), steps + 1);
    takeKeyboard();
    ASSERT_TRUE(waitUntilAtRest());
    const SolveReport& report = window.solver().report();
    EXPECT_LT(report.strain.rms, 0.03);
    EXPECT_EQ(report.flippedTriangles, 0);
    // The cover lies where the form was: flat enough that nothing but its border holds it.
    for (const Vec3& at : window.solver().surface()->positions)
        EXPECT_NEAR(at.z(), onBowl(at.x(), at.y()).z(), 12);

    // Made anew it takes the place of what was made before, when that is asked for.
    const Design first = design();
    const auto curves = count<FixationCurve>();
    designer.choose({"Pattern", "From a form"});
    dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
    const auto replace =
        std::ranges::find_if(boxes, [](const QCheckBox* box) { return box->text().contains("Replace"); });
    ASSERT_NE(replace, boxes.end());
    EXPECT_TRUE((*replace)->text().contains("5"));
    const auto* lines = dialog->findChild<QTreeWidget*>();
    ASSERT_EQ(lines->topLevelItemCount(), 5) << "the four that were drawn, and what holds the cover in one";
    const QTreeWidgetItem* holding = lines->topLevelItem(4);
    EXPECT_EQ(holding->childCount(), curves - 4);
    EXPECT_FALSE(holding->isExpanded());
    std::set<QString> names;
    for (int k = 0; k < holding->childCount(); ++k)
        names.insert(holding->child(k)->text(0));
    EXPECT_EQ(std::ssize(names), curves - 4) << "each has its own";
    EXPECT_TRUE((*replace)->isChecked());
    pressIn(*dialog, "Make the pattern");
    EXPECT_EQ(lastStep(), "Make the pattern of Bucket again");
    EXPECT_EQ(count<Patch>(), 5);
    EXPECT_EQ(count<FixationCurve>(), curves);
    takeKeyboard();
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(design(), first);
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(count<Patch>(), 0);
    EXPECT_EQ(count<FixationCurve>(), 4);

    // A line that was not to be cut is not when the window is opened again.
    for (const Qt::CheckState expected : {Qt::Checked, Qt::Unchecked}) {
        designer.choose({"Pattern", "From a form"});
        dialog = window.findChild<FormPatternWindow*>();
        ASSERT_TRUE(dialog);
        QTreeWidgetItem* line = dialog->findChild<QTreeWidget*>()->topLevelItem(0);
        EXPECT_EQ(line->checkState(0), expected);
        line->setCheckState(0, Qt::Unchecked);
        dialog->close();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.findChild<FormPatternWindow*>(); }, 10000));
    }
}

TEST_F(BothWaysTest, AnOpenSeamLineIsShownAndLedOnTheNearestWay)
{
    writeBowl(folder.filePath("bowl.obj"));
    openFrame("Bucket", "bowl.obj");
    window.coverView().navigation().setStandardView(CoverView::StandardView::Top);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window.coverView().navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-9); }, 10000));
    const double end = 0.985 * std::sqrt(bowlRadius * bowlRadius - 60.0 * 60.0);
    drawSeam({onBowl(60, -end), onBowl(60, 0), onBowl(60, end / 2)});
    const Design before = design();
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    EXPECT_EQ(dialog->made()->flat.size(), 1U);
    ASSERT_EQ(dialog->made()->form.openEnds.size(), 1U);
    EXPECT_TRUE(says(*dialog, "ends inside a piece"));
    const OpenEnd open = dialog->made()->form.openEnds.front();
    const auto isShown = [&](const Vec3& at) {
        const auto& dots = window.coverView().shown().scene().dots;
        return std::ranges::any_of(dots,
                                   [&](const SceneDot& dot) { return (dot.at - at.cast<float>()).norm() < 1e-3F; });
    };
    EXPECT_TRUE(isShown(open.way.front()));

    pressIn(*dialog, "Lead ");
    EXPECT_EQ(lastStep(), "Lead open seam lines on");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    EXPECT_EQ(dialog->made()->flat.size(), 2U);
    EXPECT_TRUE(dialog->made()->form.openEnds.empty());
    EXPECT_FALSE(isShown(open.way.front()));
    expectUndone(*dialog, before);
}

TEST_F(BothWaysTest, AFrameThatIsMovedMeanwhileIsLaidFlatAsItStands)
{
    writeBowl(folder.filePath("bowl.obj"));
    const ElementId id = openFrame("Bucket", "bowl.obj");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    EXPECT_TRUE(says(*dialog, "Keeps the cover outside"));
    Frame keeps = *design().find<Frame>(id);
    keeps.contact = true;
    window.document().commit({{}, {{id, design().element(id), makeElement(keeps)}}});
    EXPECT_TRUE(dialog->made()) << "its pieces are the same";
    EXPECT_FALSE(says(*dialog, "Keeps the cover outside"));
    Frame moved = *design().find<Frame>(id);
    moved.position += Vec3(0, 0, 500);
    window.document().commit({{}, {{id, design().element(id), makeElement(moved)}}});
    EXPECT_FALSE(dialog->made()) << "that was of the frame where it had been";
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    Box3 box;
    for (const Vec3& point : dialog->made()->form.points)
        box.extend(point);
    EXPECT_NEAR(box.min().z(), 500, 1e-6);
    EXPECT_NEAR(box.max().z(), 500 + bowlHeight, 1e-6);
    dialog->close();
}

TEST_F(BothWaysTest, ClosedAndOpenedAgainTheFormIsCutAsBefore)
{
    writeBowl(folder.filePath("bowl.obj"));
    openFrame("Bucket", "bowl.obj");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    box(*dialog, "not lie flat")->click();
    box(*dialog, "bends by more")->click();
    dialog->findChild<NumberBox*>()->display(50);
    dialog->close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.findChild<FormPatternWindow*>(); }, 10000));
    designer.choose({"Pattern", "From a form"});
    dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(box(*dialog, "not lie flat")->isChecked());
    EXPECT_TRUE(box(*dialog, "bends by more")->isChecked());
    EXPECT_EQ(dialog->findChild<NumberBox*>()->value(), 50);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 120000)) << "and begins at once";

    ASSERT_TRUE(open(sample("pillow"))); // another design is cut as usual
    designer.choose({"Pattern", "From a form"});
    dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    EXPECT_FALSE(box(*dialog, "not lie flat")->isChecked());
    dialog->close();
}

TEST_F(BothWaysTest, StoppedItKeepsThePiecesFromBefore)
{
    writeBowl(folder.filePath("bowl.obj"));
    openFrame("Bucket", "bowl.obj");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    box(*dialog, "not lie flat")->click();
    pressIn(*dialog, "Stop");
    EXPECT_TRUE(says(*dialog, "These are the pieces from before."));
    EXPECT_FALSE(dialog->made()) << "they are not what is asked for";
    auto* pieces = dialog->findChild<FlatPiecesView*>();
    EXPECT_TRUE(pointsAtAPiece(*pieces));
    dialog->close();
}

TEST_F(BothWaysTest, EveryPartThatCannotBeLaidFlatIsNamed)
{
    QString text;
    int first = 1;
    for (const char* name : {"Left", "Right", "Seat"}) {
        const int x = 500 * first;
        text += QString("g %1\nv %2 0 0\nv %3 0 0\nv %2 400 0\nv %2 0 300\n").arg(name).arg(x).arg(x + 400);
        text += QString("f %1 %3 %2\nf %1 %2 %4\nf %2 %3 %4\nf %3 %1 %4\n")
                    .arg(first)
                    .arg(first + 1)
                    .arg(first + 2)
                    .arg(first + 3);
        first += 4;
    }
    writeText(folder.filePath("three.obj"), text.toStdString());
    openFrame("Three", "three.obj");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    for (const char* name : {"Left", "Right", "Seat"})
        EXPECT_TRUE(says(*dialog, QString("%1 is left out: it is closed all around").arg(name))) << name;
    dialog->close();
}

/// A box that is closed all around: what is wrong with it is said, and one mark mends it.
TEST_F(BothWaysTest, AClosedFormIsDividedWhenThatIsTicked)
{
    writeText(folder.filePath("box.obj"), R"(g Box
v 0 0 0
v 400 0 0
v 400 300 0
v 0 300 0
v 0 0 120
v 400 0 120
v 400 300 120
v 0 300 120
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)");
    const ElementId box = openFrame("Box", "box.obj");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 60000));
    EXPECT_TRUE(dialog->made()->pattern.isEmpty());
    const auto says = [&](const QString& words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    };
    EXPECT_TRUE(says("where it would not lie flat"));

    const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
    const auto divide =
        std::ranges::find_if(boxes, [](const QCheckBox* each) { return each->text().contains("not lie"); });
    ASSERT_NE(divide, boxes.end());
    QTest::mouseClick(*divide, Qt::LeftButton, {}, {8, (*divide)->height() / 2});
    ASSERT_TRUE((*divide)->isChecked());
    const QList<QPushButton*> buttons = dialog->findChildren<QPushButton*>();
    const auto stop =
        std::ranges::find_if(buttons, [](QPushButton* button) { return button->text().remove('&') == "Stop"; });
    ASSERT_NE(stop, buttons.end());
    const QPoint place = (*stop)->mapTo(dialog, (*stop)->rect().center());
    for (int twice = 0; twice < 2; ++twice) {
        QWidget* there = dialog->childAt(place);
        QTest::mouseClick(there ? there : dialog, Qt::LeftButton, {},
                          there ? there->mapFrom(dialog, place) : place);
    }
    EXPECT_TRUE(says("It was stopped.")) << "the second click begins nothing";
    EXPECT_FALSE((*stop)->isVisible());
    EXPECT_FALSE(dialog->made());
    pressIn(*dialog, "Lay it flat");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() && dialog->made()->problem.empty(); }, 120000));
    EXPECT_FALSE(says("Tick \"where"));
    const auto drawn = [&](float width) {
        return std::ranges::count(window.coverView().shown().scene().lines, width, &SceneLine::width);
    };
    EXPECT_EQ(drawn(1.5F), std::ssize(dialog->made()->form.pieces)) << "where each piece lies";
    EXPECT_EQ(drawn(4), 0);
    auto* pieces = dialog->findChild<FlatPiecesView*>();
    ASSERT_TRUE(pieces);
    ASSERT_TRUE(pointsAtAPiece(*pieces));
    EXPECT_EQ(drawn(4), 1) << "and that under the pointer";
    const auto seen = [&] { return window.patternView().navigation().transform().matrix(); };
    const QTransform before = seen();
    pressIn(*dialog, "Make the pattern");
    EXPECT_EQ(lastStep(), "Make the pattern of Box");
    const QTransform after = seen();
    EXPECT_NE(after, before);
    const auto keepsOutside = [&] { return design().find<Frame>(box)->contact; };
    EXPECT_TRUE(keepsOutside()) << "a cover that is held along its seams alone would turn inside out";
    window.document().undo();
    EXPECT_EQ(seen(), before) << "what was seen before is seen again";
    EXPECT_FALSE(keepsOutside());
    window.document().redo();
    EXPECT_EQ(seen(), after);
    EXPECT_TRUE(keepsOutside());
    EXPECT_TRUE(QTest::qWaitFor([&] { return drawn(4) == 0; }, 10000));
    EXPECT_GE(count<Patch>(), 1);
    EXPECT_LE(count<Patch>(), 6);
    double area = 0;
    design().each<Patch>([&](ElementId, const Patch& patch) { area += patch.outline.signedArea(); });
    EXPECT_NEAR(area, 2 * (400 * 300 + 400 * 120 + 300 * 120), 500);
}

/// OBJ says nothing of its axes; by custom y points up.
TEST_F(BothWaysTest, AFormThatLiesWhereTheCoverIsIsTakenAsItLies)
{
    const QString path = folder.filePath("form.obj");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 500 0 10\nv 500 300 100\nv 0 300 90\nf 1 2 3\nf 1 3 4\n");
    file.close();
    FormPatternJob job;
    FormWanted wanted;
    wanted.file = path;
    wanted.draft = true;
    const auto size = [&](const Box3& there) {
        wanted.there = there;
        return job.make(wanted, {}).size.value_or(Vec3::Zero());
    };
    EXPECT_TRUE(size({}).isApprox(Vec3(500, 100, 300)));
    EXPECT_TRUE(size(Box3(Vec3(-20, 0, 0), Vec3(520, 310, 120))).isApprox(Vec3(500, 300, 100)));
    EXPECT_TRUE(size(Box3(Vec3(3000, 0, 0), Vec3(3500, 310, 120))).isApprox(Vec3(500, 100, 300)));
    EXPECT_TRUE(size(Box3(Vec3(0, 0, 0), Vec3(20, 20, 20))).isApprox(Vec3(500, 100, 300)));
}

TEST_F(BothWaysTest, AFrameFromCadIsCutAtTheEdgesOfItsFaces)
{
    ASSERT_TRUE(QFile::copy(QString::fromStdString(test::dataFolder() + "/frames/two-faces.step"),
                            folder.filePath("seat.step")));
    openFrame("Seat", "seat.step");
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    const auto pieces = [&](std::size_t count) {
        return QTest::qWaitFor([&] { return dialog->made() && dialog->made()->flat.size() == count; }, 60000);
    };
    EXPECT_TRUE(pieces(1)) << "it is flat, and one part";
    QCheckBox* faces = nullptr;
    for (auto* box : dialog->findChildren<QCheckBox*>())
        if (box->text().contains("CAD"))
            faces = box;
    ASSERT_TRUE(faces);
    ASSERT_TRUE(faces->isVisible());
    faces->setFocus();
    QTest::keyClick(faces, Qt::Key_Space);
    EXPECT_TRUE(pieces(2));
    pressIn(*dialog, "Make the pattern");
    EXPECT_EQ(count<Patch>(), 2);
    EXPECT_EQ(count<Seam>(), 1);

    // Without its file there are no edges, and nothing is cut at them.
    ASSERT_TRUE(QFile::remove(folder.filePath("seat.step")));
    designer.choose({"Pattern", "From a form"});
    dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    for (auto* box : dialog->findChildren<QCheckBox*>())
        EXPECT_FALSE(box->text().contains("CAD") && box->isVisible());
}

/// The sample's cover as it should be is the scan; one of its patches is too large.
TEST_F(BothWaysTest, ChangesForAScanAreTakenInPart)
{
    openLargeCushion();
    const Design before = design();

    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->hasFound(); }, 120000));
    EXPECT_TRUE(window.document().gestureRunning()) << "the change is seen at once";
    auto* list = dialog->findChild<QTreeWidget*>();
    ASSERT_GE(list->topLevelItemCount(), 2);
    const auto idOf = [&](int row) {
        return static_cast<ElementId>(list->topLevelItem(row)->data(0, Qt::UserRole).toUInt());
    };
    const auto said = [&] {
        QString found;
        for (const auto* label : dialog->findChildren<QLabel*>())
            if (label->text().contains("of the changes:"))
                found = label->text();
        return found;
    };
    const auto outlineNow = [&](ElementId id) { return design().find<Patch>(id)->outline; };
    const ElementId left = idOf(0), taken = idOf(1);
    const BSpline2 whole = outlineNow(taken);
    const QString all = said();
    EXPECT_TRUE(all.startsWith("With all")) << all.toStdString();
    EXPECT_FALSE(outlineNow(left) == before.find<Patch>(left)->outline);

    list->setFocus();
    list->setCurrentItem(list->topLevelItem(0));
    QTest::keyClick(list, Qt::Key_Space); // not that one
    EXPECT_TRUE(outlineNow(left) == before.find<Patch>(left)->outline);
    auto* share = dialog->findChild<QSlider*>();
    share->setFocus();
    for (int k = 0; k < 5; ++k)
        QTest::keyClick(share, Qt::Key_PageDown); // 50 %
    ASSERT_EQ(share->value(), 50);
    const QList<NumberBox*> numbers = dialog->findChildren<NumberBox*>();
    const auto percent = std::ranges::find(numbers, QString("How much of it"), &QWidget::accessibleName);
    ASSERT_NE(percent, numbers.end());
    EXPECT_EQ((*percent)->value(), 50);
    const Vec2 start = before.find<Patch>(taken)->outline.points()[0];
    const Vec2 half = outlineNow(taken).points()[0];
    EXPECT_LT((half - (start + whole.points()[0]) / 2).norm(), 1e-6);

    EXPECT_TRUE(said().startsWith("With what is shown")) << said().toStdString();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !said().contains(QChar(0x2026)); }, 60000))
        << "figures are those of what is shown";
    EXPECT_NE(said().section('\n', 1), all.section('\n', 1));
    EXPECT_EQ(said().count('\n'), all.count('\n')) << "the list below keeps its place";
    EXPECT_TRUE(said().contains("Over the fabrics' limits")) << "however little there is";

    const auto& solver = window.solver();
    ASSERT_TRUE(QTest::qWaitFor([&] { return solver.upToDate() && solver.status().resting; }, 60000))
        << "what is looked at comes to rest";
    const SurfaceMeshPtr shown = solver.surface();

    const int steps = window.document().history().count();
    pressIn(*dialog, "Take the changes");
    EXPECT_FALSE(window.document().gestureRunning());
    EXPECT_EQ(window.document().history().count(), steps + 1);
    ASSERT_TRUE(waitUntilAtRest());
    ASSERT_EQ(solver.surface()->positions.size(), shown->positions.size());
    double most = 0;
    for (std::size_t v = 0; v < shown->positions.size(); ++v)
        most = std::max(most, (solver.surface()->positions[v] - shown->positions[v]).norm());
    EXPECT_LT(most, 1e-6) << "the cover that was seen is the one that was taken";
    EXPECT_TRUE(outlineNow(left) == before.find<Patch>(left)->outline);
    EXPECT_LT((outlineNow(taken).points()[0] - half).norm(), 1e-9);
    expectUndone(*dialog, before);
}

TEST_F(BothWaysTest, ClosedAndOpenedAgainTheFitsWindowAsksForTheSame)
{
    openLargeCushion();
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    const auto box = [&](const char* words) {
        const QList<QCheckBox*> boxes = dialog->findChildren<QCheckBox*>();
        return *std::ranges::find_if(boxes, [&](const QCheckBox* each) { return each->text().contains(words); });
    };
    const auto limit = [&] {
        const QList<NumberBox*> numbers = dialog->findChildren<NumberBox*>();
        return *std::ranges::find(numbers, QString("Limit of strain"), &QWidget::accessibleName);
    };
    ASSERT_FALSE(box("Strain")->isChecked());
    box("Strain")->click();
    box("Fo&am")->click();
    limit()->display(3);
    dialog->close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.findChild<PatternFitWindow*>(); }, 10000));
    dialog = openFit();
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(box("Strain")->isChecked());
    EXPECT_TRUE(box("Fo&am")->isChecked());
    EXPECT_TRUE(box("lies on")->isChecked());
    EXPECT_EQ(limit()->value(), 3);

    ASSERT_TRUE(open(sample("pillow"))); // another design asks for what is usual
    dialog = openFit();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(limit()->value(), 8);
}

TEST_F(BothWaysTest, AScanThatPullsAtTheCoverIsSaidAndSwitchedOff)
{
    openLargeCushion(true);
    const Design before = design();
    const auto pulls = [&] {
        bool any = false;
        design().each<Scan>([&](ElementId, const Scan& scan) { any = any || scan.enabled; });
        return any;
    };
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    auto* note = dialog->findChild<QLabel*>("pull-note");
    ASSERT_TRUE(note);
    EXPECT_TRUE(note->isVisible());
    takeKeyboard(*dialog);
    note->setFocus();
    QTest::keyClick(note, Qt::Key_Tab); // to the link in it
    QTest::keyClick(note, Qt::Key_Return);
    EXPECT_FALSE(pulls());
    EXPECT_TRUE(note->isVisible());
    EXPECT_TRUE(note->text().contains("Pull again")) << note->text().toStdString();
    emit note->linkActivated({});
    EXPECT_TRUE(pulls());
    EXPECT_EQ(writeDesign(design()), writeDesign(before));
    dialog->close();
    takeKeyboard();
    designer.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(pulls()) << "it is a step";
}

TEST_F(BothWaysTest, WhatWasFoundStaysWhenAScanPullsNoLonger)
{
    openLargeCushion(true);
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->hasFound(); }, 120000));
    const auto outlines = [&] {
        std::vector<Vec2> points;
        design().each<Patch>([&](ElementId, const Patch& patch) {
            points.insert(points.end(), patch.outline.points().begin(), patch.outline.points().end());
        });
        return points;
    };
    auto* share = dialog->findChild<QSlider*>();
    share->setValue(60);
    const std::vector<Vec2> found = outlines();
    auto* note = dialog->findChild<QLabel*>("pull-note");
    for (int twice = 0; twice < 2; ++twice) { // off, and on again
        emit note->linkActivated({});
        EXPECT_EQ(share->value(), 60);
        EXPECT_TRUE(outlines() == found);
    }
    emit note->linkActivated({});
    EXPECT_TRUE(dialog->hasFound());
    EXPECT_TRUE(window.document().gestureRunning());
    EXPECT_TRUE(outlines() == found) << "it is shown again";
    pressIn(*dialog, "Take the changes");
    const auto says = [&](const char* words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().startsWith(words); });
    };
    EXPECT_TRUE(says("Taken. "));
    EXPECT_TRUE(QTest::qWaitFor([&] { return BothWaysTest::says(*dialog, "Over the fabrics' limits"); }, 60000))
        << "who takes it before it is measured is told afterwards";
    EXPECT_FALSE(dialog->hasFound());
    EXPECT_TRUE(lastStep().startsWith("Fit the pattern to Built")) << lastStep().toStdString();
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(says("Taken back."));
    EXPECT_TRUE(dialog->hasFound()) << "it need not be found again";
    EXPECT_EQ(share->value(), 0);
    const auto* list = dialog->findChild<QTreeWidget*>();
    EXPECT_EQ(list->topLevelItem(0)->text(1), "0.0 mm");
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(says("Taken. "));
    EXPECT_TRUE(outlines() == found);
    EXPECT_FALSE(dialog->hasFound());
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
    share->setValue(60);
    EXPECT_TRUE(outlines() == found);
    dialog->close();
}

TEST_F(BothWaysTest, WhatWasFoundComesBackWithItsDesign)
{
    openLargeCushion();
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->hasFound(); }, 120000));
    Fabric other;
    other.name = "Other";
    window.document().commit({{}, {{design().nextId(), nullptr, makeElement(other)}}});
    EXPECT_FALSE(dialog->hasFound());
    EXPECT_TRUE(says(*dialog, "The design has changed meanwhile"));
    window.document().undo();
    EXPECT_TRUE(dialog->hasFound());
    EXPECT_TRUE(says(*dialog, "move the slider"));
    QTest::keyClick(dialog, Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    auto* tolerances = window.findChild<SweepWindow*>();
    ASSERT_TRUE(tolerances) << "keys of its neighbours do what they do in the main window";
    tolerances->close();
    dialog->close();
}

TEST_F(BothWaysTest, StoppedItShowsTheBestThatWasFound)
{
    openLargeCushion();
    const Design before = design();
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    QTest::keyClick(dialog, Qt::Key_Return);
    const auto said = [&](const char* words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    };
    QString first;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            for (const auto* label : dialog->findChildren<QLabel*>())
                if (label->text().contains("(rms; before:")) {
                    first = first.isEmpty() ? label->text() : first;
                    return label->text() != first; // a round has made it better
                }
            return false;
        },
        120000));
    pressIn(*dialog, "Stop");
    EXPECT_TRUE(dialog->hasFound());
    EXPECT_TRUE(said("Stopped."));
    EXPECT_TRUE(window.document().gestureRunning()) << "it is seen, and not taken yet";
    EXPECT_FALSE(design() == before);
    dialog->close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return design() == before; }, 10000));
}

TEST_F(BothWaysTest, AnEditMeanwhileEndsTheSearchAndNothingIsLost)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    QTest::keyClick(dialog, Qt::Key_Return); // strain: there is no scan
    Fabric other;
    other.name = "Other";
    window.document().commit({{}, {{design().nextId(), nullptr, makeElement(other)}}});
    const Design edited = design();
    EXPECT_FALSE(QTest::qWaitFor([&] { return dialog->hasFound(); }, 3000));
    EXPECT_FALSE(window.document().gestureRunning());
    EXPECT_EQ(writeDesign(design()), writeDesign(edited));
    dialog->close();
}

TEST_F(BothWaysTest, TheWindowCanBeClosedWhileAChangeIsShown)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().contains('%'))
            box->setValue(3); // within reach
    QTest::keyClick(dialog, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->hasFound(); }, 120000));
    EXPECT_TRUE(window.document().gestureRunning()); // what follows ends with it
}

/// The brush paints over the cover, takes away with Shift, and is put away with Escape.
TEST_F(BothWaysTest, AnAreaIsPaintedOnTheCover)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    auto* dialog = openFit();
    ASSERT_TRUE(dialog);
    auto* area = dialog->findChild<AreaRow*>();
    ASSERT_TRUE(area);
    EXPECT_FALSE(area->wanted());
    pressIn(*area, "Paint");
    EXPECT_TRUE(area->wanted());
    EXPECT_EQ(window.coverView().tool(), CoverToolKind::PaintArea);
    EXPECT_TRUE(area->spots().empty());
    const SurfaceMeshPtr cover = window.solver().surface();
    const auto top = std::ranges::max_element(cover->positions, {}, [](const Vec3& at) { return at.z(); });
    window.coverView().navigation().setStandardView(CoverView::StandardView::Top);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window.coverView().navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-9); }, 10000));
    designer.clickCover(*top);
    ASSERT_FALSE(area->spots().empty());
    const SurfaceTopology& topology = *cover->topology;
    const auto v = static_cast<std::uint32_t>(top - cover->positions.begin());
    const auto range = std::ranges::find_if(topology.patches, [&](const SurfaceTopology::PatchRange& patch) {
        return v >= patch.firstVertex && v < patch.firstVertex + patch.vertexCount;
    });
    EXPECT_TRUE((FitArea{{}, area->spots()}.has(range->patch, topology.pattern[v])));
    EXPECT_TRUE(window.maps().hasGuest()) << "it is seen in colours";

    // A quick stroke is told of at its ends alone.
    pressIn(*area, "Clear");
    const Vec3 from = *top + Vec3(-150, 0, 0), to = *top + Vec3(150, 0, 0);
    const auto pixel = [&](const Vec3& at) {
        const Vec2 found = window.coverView().navigation().camera().pixel(at).value_or(Vec2::Zero());
        return QPoint(qRound(found.x()), qRound(found.y()));
    };
    QTest::mousePress(&window.coverView(), Qt::LeftButton, {}, pixel(from));
    QTest::mouseMove(&window.coverView(), pixel(to));
    QTest::mouseRelease(&window.coverView(), Qt::LeftButton, {}, pixel(to));
    EXPECT_TRUE((FitArea{{}, area->spots()}.has(range->patch, topology.pattern[v]))) << "what lies between";
    auto* radius = area->findChild<NumberBox*>();
    const double before = radius->value();
    takeKeyboard();
    window.coverView().setFocus();
    designer.key(Qt::Key_Plus);
    EXPECT_GT(radius->value(), before);
    designer.key(Qt::Key_Minus);
    EXPECT_NEAR(radius->value(), before, 0.5);
    takeKeyboard();
    window.coverView().setFocus();
    designer.key(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.coverView().tool() == CoverToolKind::Select; }, 5000));
    EXPECT_FALSE(area->spots().empty()) << "what was painted stays";
    pressIn(*area, "Clear");
    EXPECT_TRUE(area->spots().empty());
    takeKeyboard(*dialog);
    pressIn(*dialog, "Find changes");
    bool said = false;
    for (const auto* label : dialog->findChildren<QLabel*>())
        said = said || label->text().startsWith("Paint the area");
    EXPECT_TRUE(said) << "an area was wanted, and nothing is painted";
    dialog->close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.maps().hasGuest(); }, 5000));
}

/// As soon as it is chosen, while the frame is still being laid flat.
TEST_F(BothWaysTest, TheCoverIsAForm)
{
    ASSERT_TRUE(open(sample("car-seat")));
    ASSERT_TRUE(waitUntilAtRest());
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    auto* forms = dialog->findChild<QComboBox*>();
    const int cover = forms->findData(QStringLiteral("cover"));
    ASSERT_GE(cover, 0);
    forms->setCurrentIndex(cover);
    emit forms->activated(cover);
    const auto listed = [] {
        return std::ranges::any_of(Jobs::all().running(),
                                   [](const Jobs::Job& job) { return job.name.startsWith("Laying a form flat"); });
    };
    ASSERT_TRUE(listed());
    Jobs::all().cancelAll();
    EXPECT_FALSE(listed()) << "stopped";
    EXPECT_FALSE(dialog->made());
    emit forms->activated(cover); // again
    ASSERT_TRUE(listed());
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr; }, 120000));
    EXPECT_FALSE(listed()) << "done";
    for (const FlatPiece& piece : dialog->made()->flat)
        for (const Vec2& at : piece.at)
            ASSERT_TRUE(at.allFinite());
    dialog->close();
}

/// Far from where the designer looks; another file, and the first one, are still there to be chosen.
TEST_F(BothWaysTest, AFilesFormIsBroughtIntoThePicture)
{
    ASSERT_TRUE(open(sample("car-seat")));
    ASSERT_TRUE(waitUntilAtRest());
    CoverNavigation& view = window.coverView().navigation();
    view.fit(Box3(Vec3(4900, 0, 0), Vec3(5100, 200, 200)));
    designer.choose({"Pattern", "From a form"});
    auto* dialog = window.findChild<FormPatternWindow*>();
    ASSERT_TRUE(dialog);
    auto* forms = dialog->findChild<QComboBox*>();
    ASSERT_EQ(forms->itemText(forms->count() - 1), QString::fromUtf8("A file \u2026"));
    const int count = forms->count();
    const auto chooseLast = [&] {
        forms->setCurrentIndex(forms->count() - 1);
        emit forms->activated(forms->count() - 1);
    };
    designer.chooseFile(QFileInfo(sample("car-seat")).dir().filePath("car-seat-form.obj"));
    chooseLast();
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->made() != nullptr && forms->count() > count; }, 120000));
    EXPECT_EQ(forms->currentText(), "car-seat-form.obj");
    EXPECT_EQ(forms->itemText(forms->count() - 1), QString::fromUtf8("A file \u2026"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.inPicture(dialog->made()->form.boundingBox()); }, 5000));
    dialog->close();
}

TEST_F(BothWaysTest, AReliefIsMadeInOneStep)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    const Design before = design();
    designer.choose({"Pattern", "Relieve strain"});
    auto* dialog = window.findChild<ReliefWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    dialog->findChild<QCheckBox*>()->setChecked(true);
    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().contains('%'))
            box->setValue(1.5);
    const auto says = [&](const QString& words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    };
    pressIn(*dialog, "Look for changes");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found() != nullptr; }, 240000));
    EXPECT_FALSE(dialog->found()->reliefs.empty()) << "the first one is shown when it is solved";
    if (says("being solved")) {
        pressIn(*dialog, "Stop");
        EXPECT_TRUE(says("Stopped. These are solved"));
        EXPECT_TRUE(dialog->found());
        pressIn(*dialog, "Look for changes");
        ASSERT_TRUE(QTest::qWaitFor([&] { return says("Each is solved by itself"); }, 240000));
    }
    ASSERT_TRUE(dialog->found());
    const std::vector<Relief>& reliefs = dialog->found()->reliefs;
    ASSERT_FALSE(reliefs.empty());
    ASSERT_TRUE(reliefs.front().solved);
    EXPECT_GT(reliefs.front().solved->energy, 0.02);
    for (const Relief& relief : reliefs) {
        EXPECT_GT(relief.solved->energy, 0) << relief.text.english() << ": what makes it worse is not proposed";
        const auto* patch = design().find<Patch>(relief.place.patch);
        ASSERT_TRUE(patch) << relief.text.english();
        EXPECT_LT(patch->outline.closest(relief.place.at).distance, 0.01) << relief.text.english();
    }
    int pictures = 0;
    for (const auto* label : dialog->findChildren<QLabel*>())
        pictures += !label->pixmap().isNull();
    EXPECT_GE(pictures, 2) << "as it is, and as it would be";
    const Design wanted = before.with(reliefs.front().edit);
    const int steps = window.document().history().count();
    pressIn(*dialog, "Make it");
    EXPECT_EQ(window.document().history().count(), steps + 1);
    EXPECT_EQ(writeDesign(design()), writeDesign(wanted));
    EXPECT_EQ(dialog->found(), nullptr) << "what was proposed is of another design";
    QTest::keyClick(dialog, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(writeDesign(design()), writeDesign(before));
    ASSERT_TRUE(dialog->found()) << "it is the one again that they were found for";
    EXPECT_FALSE(says("Made."));
    EXPECT_TRUE(says("of the cover, then")) << "how much there is, not only by how much it becomes less";
    const std::size_t proposed = dialog->found()->reliefs.size();
    dialog->close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.findChild<ReliefWindow*>(); }, 10000));
    designer.choose({"Pattern", "Relieve strain"});
    dialog = window.findChild<ReliefWindow*>();
    ASSERT_TRUE(dialog && dialog->found()) << "closed and opened again it shows what was found";
    EXPECT_EQ(dialog->found()->reliefs.size(), proposed);
    EXPECT_TRUE(dialog->findChild<QCheckBox*>()->isChecked());
    takeKeyboard(*dialog);
    pressIn(*dialog, "Make it");
    EXPECT_EQ(writeDesign(design()), writeDesign(wanted));
    expectUndone(*dialog, before);
}

TEST_F(BothWaysTest, TheCauseOfAScannedPieceIsNamed)
{
    QFile file(sample("box-cushion"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    Design right = readDesign(file.readAll().toStdString()).design;
    const std::vector<Cause> causes = possibleCauses(withoutTwins(right));
    const auto wide = std::ranges::find(causes, Cause::Kind::Stretch, &Cause::kind);
    ASSERT_NE(wide, causes.end());
    const Design built = withCause(withoutTwins(right), *wide, Eigen::VectorXd::Constant(1, 4));
    const SolveResult solved = solveResting(built, {});
    ASSERT_TRUE(solved.surface);
    ASSERT_TRUE(exportPly(*solved.surface, built, folder.filePath("built.ply")).empty());
    Scan scan;
    scan.name = "Built";
    scan.file = "built.ply";
    scan.enabled = false;
    right = right.with({{}, {{right.nextId(), nullptr, makeElement(scan)}}});
    writeText(folder.filePath("cushion.json"), writeDesign(right));
    ASSERT_TRUE(open(folder.filePath("cushion.json")));
    ASSERT_TRUE(waitUntilAtRest());
    waitForBackground();

    designer.choose({"Pattern", "Why is it so?"});
    auto* dialog = window.findChild<CauseWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    pressIn(*dialog, "Look for the cause");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found().has_value(); }, 240000));
    const CauseWindow::Found& found = *dialog->found();
    ASSERT_FALSE(found.explained.ranked.empty());
    const Explanation& first = found.explained.ranked.front();
    EXPECT_EQ(found.causes[first.cause].element, wide->element);
    EXPECT_EQ(found.causes[first.cause].kind, Cause::Kind::Stretch);
    EXPECT_NEAR(first.values[0], 4, 1);
    auto* list = dialog->findChild<QTreeWidget*>();
    EXPECT_GE(list->topLevelItemCount(), 2);
    EXPECT_TRUE(list->topLevelItem(0)->text(1).endsWith("larger")) << list->topLevelItem(0)->text(1).toStdString();
    for (int row = 0; row < list->topLevelItemCount(); ++row)
        EXPECT_NE(list->topLevelItem(row)->text(2), "0 %") << "what explains nothing is no answer";
    EXPECT_TRUE(window.selection().elements().contains(wide->element)) << "the views show where";

    const int causesListed = list->topLevelItemCount();
    pressIn(*dialog, "Look for the cause"); // who wanted to press Stop a moment too late
    EXPECT_EQ(list->topLevelItemCount(), causesListed);
    waitAsAHandDoes();
    pressIn(*dialog, "Look for the cause");
    pressIn(*dialog, "Stop");
    EXPECT_TRUE(dialog->found().has_value());
    EXPECT_EQ(list->topLevelItemCount(), causesListed) << "what took long is not thrown away";
    dialog->close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.findChild<CauseWindow*>(); }, 10000));
    designer.choose({"Pattern", "Why is it so?"});
    dialog = window.findChild<CauseWindow*>();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->findChild<QTreeWidget*>()->topLevelItemCount(), causesListed) << "nor when it is closed";
    dialog->close();
}

TEST_F(BothWaysTest, TolerancesAreShownOnTheCoverUntilTheWindowIsClosed)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilAtRest());
    designer.choose({"Pattern", "Tolerances"});
    auto* dialog = window.findChild<SweepWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().isEmpty())
            box->setValue(10); // pieces
    pressIn(*dialog, "Draw pieces");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found() && dialog->found()->whole; }, 240000));
    EXPECT_EQ(dialog->found()->solved, 10);
    const SweepKnown before = dialog->found()->known;
    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().isEmpty())
            box->setValue(20); // more of them go on from there
    waitAsAHandDoes();
    pressIn(*dialog, "Draw pieces");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found()->whole && dialog->found()->solved == 20; }, 240000));
    EXPECT_EQ(dialog->found()->known.linear, before.linear);
    EXPECT_EQ(dialog->found()->known.pieces.front(), before.pieces.front());
    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().isEmpty()) {
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, "7000");
            QTest::keyClick(box, Qt::Key_Return);
            EXPECT_EQ(box->value(), 7000);
        }
    EXPECT_TRUE(std::ranges::none_of(dialog->findChildren<QPushButton*>(), [](const QPushButton* button) {
        return button->text().remove(u'&') == "Stop";
    })) << "Enter begins nothing";
    ASSERT_TRUE(window.maps().map());
    EXPECT_TRUE(window.maps().map()->fits(*window.solver().surface()->topology));
    float most = 0;
    for (const float value : window.maps().map()->values)
        most = std::max(most, value);
    EXPECT_GT(most, 0.2F);
    EXPECT_LT(most, 50.0F);
    auto* list = dialog->findChild<QTreeWidget*>();
    ASSERT_GT(list->topLevelItemCount(), 2);
    list->setCurrentItem(list->topLevelItem(0));
    EXPECT_FALSE(window.selection().elements().empty());
    window.command("map.strain")->setChecked(true); // another map takes its place
    EXPECT_FALSE(window.maps().hasGuest());
    auto* shown = dialog->findChild<QCheckBox*>();
    EXPECT_FALSE(shown->isChecked());
    shown->setChecked(true);
    EXPECT_TRUE(window.maps().hasGuest());

    for (auto* box : dialog->findChildren<NumberBox*>())
        if (box->suffix().isEmpty())
            box->setValue(10'000); // more than anybody waits for
    waitAsAHandDoes();
    pressIn(*dialog, "Draw pieces");
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found()->resting > 20; }, 240000));
    EXPECT_FALSE(dialog->found()->whole);
    pressIn(*dialog, "Stop");
    const auto says = [&](const QString& words) {
        return std::ranges::any_of(dialog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(words); });
    };
    EXPECT_TRUE(says("Stopped."));
    EXPECT_TRUE(says("95 % of the pieces do not exceed")) << "what was solved until then counts";
    EXPECT_TRUE(says("solved pieces. \u00b1 is what many more of them may change."));
    EXPECT_TRUE(says(" \u00b1 "));
    ASSERT_TRUE(window.maps().map()->mark);
    EXPECT_EQ(*window.maps().map()->mark, 3) << "the limit, on the scale";
    EXPECT_TRUE(window.maps().hasGuest());
    dialog->close();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window.maps().hasGuest(); }, 5000));
}

/// The file is asked for when it is needed, and the search goes on with it.
TEST_F(BothWaysTest, AFileThatIsChosenLateNeedsNoSecondPress)
{
    const QString path = sample("box-cushion");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const Design right = readDesign(file.readAll().toStdString()).design;
    const SolveResult solved = solveResting(right, {});
    ASSERT_TRUE(solved.surface);
    ASSERT_TRUE(exportPly(*solved.surface, right, folder.filePath("built.ply")).empty());
    ASSERT_TRUE(open(path));
    ASSERT_TRUE(waitUntilAtRest());
    designer.choose({"Pattern", "Why is it so?"});
    auto* dialog = window.findChild<CauseWindow*>();
    ASSERT_TRUE(dialog);
    takeKeyboard(*dialog);
    pressIn(*dialog, "Look for the cause");
    designer.chooseFile(folder.filePath("built.ply"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->found().has_value(); }, 240000));
    auto* scans = dialog->findChild<QComboBox*>();
    EXPECT_EQ(scans->currentText(), "built.ply");
    EXPECT_EQ(scans->itemText(scans->count() - 1), QString::fromUtf8("A file \u2026")) << "for another one";
    dialog->close();
}

} // namespace
} // namespace bolster
