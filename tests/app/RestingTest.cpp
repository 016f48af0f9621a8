// Whatever is shown, exported or measured follows from the design alone: not from the way that led there.
#include "CommandList.h"
#include "ElidedLabel.h"
#include "WindowTest.h"

#include "CurveEdits.h"
#include "MapLink.h"
#include "RestingSolve.h"
#include "StatusLine.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QToolButton>
#include <QWhatsThis>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <random>

namespace bolster {
namespace {

constexpr ElementId crease{43}; // "Back insert crease" of the car seat

bool explained()
{
    const QWidgetList windows = QApplication::topLevelWidgets();
    return QApplication::activePopupWidget() || std::ranges::any_of(windows, [](const QWidget* window) {
               return window->isVisible() && window->inherits("QWhatsThat");
           });
}

double largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    if (a.size() != b.size())
        return 1e30;
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

std::vector<Vec3> pointsOfObj(const QString& path)
{
    std::vector<Vec3> points;
    std::ifstream file(path.toStdString());
    for (std::string word; file >> word; file.ignore(1000, '\n'))
        if (Vec3 p; word == "v" && file >> p.x() >> p.y() >> p.z())
            points.push_back(p);
    return points;
}

class RestingTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample(QStringLiteral("car-seat"))));
        ASSERT_TRUE(waitUntilAtRest());
    }

    /// Takes the 9th point of the crease some 600 mm away, and waits for the cover to follow. Returns where the
    /// pointer is then.
    QPoint dragCreaseFarAway()
    {
        CoverView& view = window.coverView();
        view.setFocus();
        window.selection().set({crease});
        const Vec3 point = window.document().design().find<FixationCurve>(crease)->curve.points()[8];
        const auto pixelOf = [&](const Vec3& p) {
            const Vec2 pixel = *view.navigation().camera().pixel(p);
            return QPoint(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
        };
        const QPoint from = pixelOf(point);
        const CoverHit hit = view.hit(from);
        EXPECT_EQ(hit.element, crease);
        const double scale =
            (Vec2(from.x(), from.y()) - *view.navigation().camera().pixel(point + Vec3(0, 0, 10))).norm() / 10;
        const QPoint to = from + QPoint(0, static_cast<int>(600 * scale));
        move(view, from, Qt::NoButton);
        press(view, from);
        for (int i = 1; i <= 20; ++i) {
            move(view, from + (to - from) * i / 20, Qt::LeftButton);
            waitForPicture();
        }
        EXPECT_TRUE(window.document().gestureRunning());
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                return window.solver().upToDate() &&
                       largestDifference(window.solver().surface()->positions, before) > 50;
            },
            20000));
        return to;
    }

    void lookAtPictures(int count)
    {
        for (int i = 0; i < count; ++i)
            waitForPicture();
    }

    std::vector<Vec3> before; ///< of the surface
};

TEST_F(RestingTest, EscapeBringsTheCoverOfBeforeBack)
{
    before = window.solver().surface()->positions;
    const Design design = window.document().design();
    const QPoint at = dragCreaseFarAway();
    QTest::keyClick(&window.coverView(), Qt::Key_Escape);
    ASSERT_TRUE(window.document().design() == design);
    ASSERT_TRUE(waitUntilAtRest());
    EXPECT_EQ(largestDifference(window.solver().surface()->positions, before), 0);
    EXPECT_EQ(window.coverView().shown().surface(), window.solver().surface()) << "at once";
    release(window.coverView(), at);
}

TEST_F(RestingTest, AfterADragAndAfterUndoTheCoverIsThatOfTheDesign)
{
    before = window.solver().surface()->positions;
    const QPoint at = dragCreaseFarAway();
    QSignalSpy sprang(&window.solver(), &SolverLink::sprang);
    release(window.coverView(), at);
    ASSERT_FALSE(window.document().gestureRunning());
    ASSERT_TRUE(waitUntilAtRest());
    const SolveResult alone =
        solveResting({window.document().design(), window.session().files()}, {.lenient = true});
    EXPECT_EQ(largestDifference(window.solver().surface()->positions, alone.surface->positions), 0);
    window.command("edit.undo")->trigger();
    ASSERT_TRUE(waitUntilAtRest());
    EXPECT_EQ(largestDifference(window.solver().surface()->positions, before), 0);
    EXPECT_LE(sprang.count(), 1) << "undo is no surprise";
    // What is seen gets there soon, and smoothly.
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.coverView().shown().surface() == window.solver().surface(); }));
    window.document().jumpTo(1);
    ASSERT_TRUE(waitUntilAtRest());
    EXPECT_EQ(largestDifference(window.solver().surface()->positions, alone.surface->positions), 0);
}

/// What is on the screen is the picture of the cover that is called solved, however the drag before the undo ended
/// and whatever else the machine is doing.
TEST_F(RestingTest, ThePictureFollowsUndo)
{
    CoverView& view = window.coverView();
    std::mt19937 random(7);
    const auto upTo = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    for (int round = 0; round < 2; ++round) {
        SCOPED_TRACE(round);
        before = window.solver().surface()->positions;
        const QPoint at = dragCreaseFarAway();
        lookAtPictures(upTo(20));
        release(view, at);
        lookAtPictures(upTo(60));
        bool green = false, seen = false;
        QTest::keyClick(&view, Qt::Key_Z, Qt::ControlModifier);
        ASSERT_TRUE(waitUntilAtRest());
        EXPECT_EQ(largestDifference(window.solver().surface()->positions, before), 0);
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                green = window.statusLine().mood() == StatusLine::Mood::Good;
                seen = view.shownSurface() == window.solver().surface();
                EXPECT_TRUE(seen || !green) << "what is not seen is not called good";
                return green && seen;
            },
            60000));
    }
}

TEST_F(RestingTest, WhatSprangIsSaidOnceWithItsReason)
{
    StatusLine& line = window.statusLine();
    auto* why = line.findChild<QToolButton*>(QStringLiteral("why"));
    ASSERT_TRUE(why);
    EXPECT_FALSE(why->isVisible());
    emit window.solver().sprang(217);
    EXPECT_TRUE(line.findChild<ElidedLabel*>()->fullText().contains(QStringLiteral("217")));
    ASSERT_TRUE(why->isVisible());
    why->click();
    EXPECT_TRUE(QTest::qWaitFor(explained));
    QWhatsThis::hideText();
    line.flash(QStringLiteral("Something else"));
    EXPECT_FALSE(why->isVisible());
    line.flash({});
    emit window.solver().sprang(217);
    ASSERT_TRUE(why->isVisible());
    emit window.document().changed({});
    EXPECT_FALSE(why->isVisible()) << "it was another design's";
}

TEST_F(RestingTest, ACoverThatFindsNoRestSaysWhatCanBeDone)
{
    StatusLine& line = window.statusLine();
    auto* why = line.findChild<QToolButton*>(QStringLiteral("why-unrest"));
    ASSERT_TRUE(why);
    SolverStatus status = window.solver().status();
    line.setSolver(status, false);
    EXPECT_FALSE(why->isVisible());
    status.reason = {"The surface still moves after %1 iterations.", {"5000"}};
    line.setSolver(status, false);
    EXPECT_TRUE(line.solverText().contains(QStringLiteral("5000")));
    ASSERT_TRUE(why->isVisible());
    why->click();
    EXPECT_TRUE(QTest::qWaitFor(explained));
    QWhatsThis::hideText();
    status.reason = {};
    line.setSolver(status, false);
    EXPECT_FALSE(why->isVisible());
}

TEST_F(RestingTest, WithWarningsItIsNotCalledSolvedEitherBeforeItIsSeen)
{
    StatusLine& line = window.statusLine();
    SolverStatus status = window.solver().status();
    for (const Severity severity : {Severity::Warning, Severity::Error}) {
        status.problems = {{crease, "Crease", "curve", {"Something about it.", {}}, severity}};
        line.setSolver(status, false);
        line.setFindings({}, false);
        EXPECT_EQ(line.mood(), StatusLine::Mood::Busy);
        EXPECT_FALSE(line.solverText().contains(QStringLiteral("olved"))) << line.solverText().toStdString();
        line.setFindings({}, true);
        EXPECT_EQ(line.mood(), StatusLine::Mood::Worried);
        EXPECT_TRUE(line.solverText().contains(QStringLiteral("olved"))) << line.solverText().toStdString();
    }
}

TEST_F(RestingTest, AnExportWaitsForTheCoverOfTheDesign)
{
    const Vec3 delta(0, 0, 12);
    window.document().commit(edits::moveCurvePoints(window.document().design(), crease, std::array{8}, delta));
    ASSERT_FALSE(window.solver().atRest());
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seat.obj"));
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible())
            return;
        answer.stop();
        dialog->findChild<QLineEdit*>()->setText(path);
        QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    });
    answer.start(50);
    window.command("file.export-surface")->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, 60000));
    const SolveResult alone =
        solveResting({window.document().design(), window.session().files()}, {.lenient = true});
    const std::vector<Vec3> expected = alone.surface->positions;
    ASSERT_TRUE(QTest::qWaitFor([&] { return pointsOfObj(path).size() == expected.size(); }, 20000));
    EXPECT_LT(largestDifference(pointsOfObj(path), expected), 1e-3);
}

TEST_F(RestingTest, WhileThePauseLastsAnExportSaysWhatIsMissing)
{
    window.command("surface.pause")->trigger();
    window.document().commit(
        edits::moveCurvePoints(window.document().design(), crease, std::array{8}, Vec3(0, 0, 12)));
    window.command("file.export-surface")->trigger();
    EXPECT_TRUE(window.statusLine().findChild<ElidedLabel*>()->fullText().contains(QStringLiteral("Pause")));
    EXPECT_FALSE(QApplication::activeModalWidget());
    window.command("surface.pause")->trigger();
    EXPECT_TRUE(waitUntilAtRest());
}

TEST_F(RestingTest, ThereIsNoCommandToSettle)
{
    for (const QAction* action : window.commands().findChildren<QAction*>())
        EXPECT_FALSE(action->text().contains(QStringLiteral("ettle"))) << action->text().toStdString();
}

} // namespace
} // namespace bolster
