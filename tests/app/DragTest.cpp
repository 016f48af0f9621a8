// The surface follows a drag in either window, and the drag is one edit.
#include "PatchEdits.h"
#include "WindowTest.h"

#include <QElapsedTimer>
#include <QMouseEvent>

#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace bolster {
namespace {

constexpr ElementId seat{6};

class DragTest : public WindowTest {
protected:
    struct Seen {
        std::set<std::uint64_t> revisions; ///< of meshes that arrived while the button was down
        WatchedApplication::Longest block;
        WatchedApplication::Longest paint;
        double seconds = 0;
    };

    /// Drags from `from` by `by` in steps, as a hand does, with the events of a real pointer.
    Seen drag(QWidget& view, QPoint from, QPoint by, int steps = 40)
    {
        Seen seen;
        const auto connection = QObject::connect(&window.solver(), &SolverLink::surfaceChanged, &window,
                                                 [&](const SurfaceMeshPtr& surface) {
                                                     if (surface)
                                                         seen.revisions.insert(surface->revision);
                                                 });
        move(view, from, Qt::NoButton);
        waitForPicture();
        application().startWatching();
        QElapsedTimer clock;
        clock.start();
        press(view, from);
        for (int i = 1; i <= steps; ++i) {
            move(view, from + by * i / steps, Qt::LeftButton);
            waitForPicture();
        }
        // However slow the machine is, it follows.
        QPoint last = from + by, tremor(0, 1);
        (void)QTest::qWaitFor(
            [&] {
                move(view, last += std::exchange(tremor, -tremor), Qt::LeftButton);
                return seen.revisions.size() >= 3;
            },
            20000);
        move(view, from + by, Qt::LeftButton);
        seen.seconds = 1e-3 * static_cast<double>(clock.elapsed());
        seen.block = application().longestBlock();
        seen.paint = application().longestPaint();
        QObject::disconnect(connection);
        return seen;
    }

    void report(const char* what, const Seen& seen)
    {
        std::printf("%s: %zu meshes during the drag of %.2f s\n", what, seen.revisions.size(), seen.seconds);
        std::printf("    longest block other than painting: %.1f ms, computing for %.1f ms (%s)\n", seen.block.wall,
                    seen.block.cpu, seen.block.what.c_str());
        std::printf("    longest painting: %.1f ms, computing for %.1f ms (%s)\n", seen.paint.wall, seen.paint.cpu,
                    seen.paint.what.c_str());
        RecordProperty(std::string(what) + "BlockMs", std::to_string(seen.block.cpu));
    }
};

TEST_F(DragTest, MovesAControlPointOfAnOutline)
{
    ASSERT_TRUE(open(sample("armchair")));
    ASSERT_TRUE(waitUntilSolved());
    const Design before = window.document().design();
    PatternView& view = window.patternView();
    window.selection().set({seat});
    view.navigation().fitSelection();

    view.aids().setSnapping(false); // the point goes exactly where the pointer goes
    const QPoint from = patternPixel(seat, 3);
    const QPoint by(18, -12);
    const Seen seen = drag(view, from, by);
    report("Pattern", seen);
    EXPECT_GE(seen.revisions.size(), 3U);
    EXPECT_TRUE(window.document().gestureRunning());
    EXPECT_EQ(window.document().history().count(), 1);
    EXPECT_LT(seen.block.cpu, 500);

    release(view, from + by);
    EXPECT_FALSE(window.document().gestureRunning());
    ASSERT_EQ(window.document().history().count(), 2);
    const Vec2 moved = toLayout(*window.document().design().find<Patch>(seat),
                                window.document().design().find<Patch>(seat)->outline.points()[3]) -
                       toLayout(*before.find<Patch>(seat), before.find<Patch>(seat)->outline.points()[3]);
    const double scale = view.navigation().transform().scale();
    EXPECT_NEAR(moved.x(), by.x() / scale, 1e-6);
    EXPECT_NEAR(moved.y(), -by.y() / scale, 1e-6);

    window.command("edit.undo")->trigger();
    EXPECT_TRUE(window.document().design() == before);
    EXPECT_FALSE(window.document().dirty());
}

TEST_F(DragTest, MovesAControlPointOfAFixationCurve)
{
    ASSERT_TRUE(open(sample("armchair")));
    ASSERT_TRUE(waitUntilSolved());
    const Design before = window.document().design();
    CoverView& view = window.coverView();

    // A point of a curve that the view itself says can be grabbed there.
    ElementId curve{};
    QPoint from;
    before.each<FixationCurve>([&](ElementId id, const FixationCurve& fixation) {
        for (int i = 0; i < fixation.curve.pointCount() && curve == noElement; ++i) {
            window.selection().set({id});
            const auto pixel =
                view.navigation().camera().pixel(fixation.curve.points()[static_cast<std::size_t>(i)]);
            if (!pixel ||
                !view.rect().adjusted(30, 30, -30, -30).contains(QPoint(int(pixel->x()), int(pixel->y()))))
                continue;
            const QPoint at(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
            const CoverHit hit = view.hit(at);
            if (hit.kind == CoverHit::Kind::Point && hit.element == id) {
                curve = id;
                from = at;
            }
        }
    });
    ASSERT_NE(curve, ElementId{});

    const QPoint by(14, 10);
    const Seen seen = drag(view, from, by);
    report("Cover", seen);
    EXPECT_GE(seen.revisions.size(), 3U);
    EXPECT_TRUE(window.document().gestureRunning());
    EXPECT_LT(seen.block.cpu, 500);
    release(view, from + by);
    ASSERT_EQ(window.document().history().count(), 2);
    EXPECT_FALSE(*window.document().design().find<FixationCurve>(curve) == *before.find<FixationCurve>(curve));

    window.command("edit.undo")->trigger();
    EXPECT_TRUE(window.document().design() == before);

    // Undo by its keys, in the middle of a drag: Z alone would keep it to an axis.
    press(view, from);
    move(view, from + by, Qt::LeftButton);
    EXPECT_FALSE(window.document().design() == before);
    QTest::keyClick(&view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(window.document().gestureRunning());
    EXPECT_TRUE(window.document().design() == before);
    release(view, from + by);
    EXPECT_TRUE(window.document().design() == before);
}

TEST_F(DragTest, EscapeTakesItBack)
{
    ASSERT_TRUE(open(sample("armchair")));
    const Design before = window.document().design();
    PatternView& view = window.patternView();
    view.setFocus();
    window.selection().set({seat});
    view.navigation().fitSelection();
    const QPoint from = patternPixel(seat, 3);
    move(view, from, Qt::NoButton);
    press(view, from);
    move(view, from + QPoint(20, 20), Qt::LeftButton);
    EXPECT_FALSE(window.document().design() == before);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(window.document().design() == before);
    release(view, from + QPoint(20, 20));
    EXPECT_TRUE(window.document().design() == before);
    EXPECT_EQ(window.document().history().count(), 1);
}

TEST_F(DragTest, UndoDuringADragTakesItBackFirst)
{
    ASSERT_TRUE(open(sample("armchair")));
    PatternView& view = window.patternView();
    window.selection().set({seat});
    view.navigation().fitSelection();
    window.document().commit(edits::movePatchPoints(window.document().design(), seat, std::array{5}, Vec2(3, 0)));
    const Design before = window.document().design();
    const QPoint from = patternPixel(seat, 3);
    move(view, from, Qt::NoButton);
    press(view, from);
    move(view, from + QPoint(20, 20), Qt::LeftButton);
    window.document().undo();
    EXPECT_TRUE(window.document().design() == before) << "only the drag";
    move(view, from + QPoint(30, 20), Qt::LeftButton);
    release(view, from + QPoint(30, 20));
    EXPECT_TRUE(window.document().design() == before);
}

TEST_F(DragTest, LayoutLeavesTheSurfaceAlone)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    ASSERT_TRUE(waitUntilSolved());
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.solver().status().resting; }, 60000));
    const std::uint64_t revision = meshRevision();
    ElementId patch{};
    window.document().design().each<Patch>([&](ElementId id, const Patch&) { patch = id; });
    PatternView& view = window.patternView();
    const Patch start = *window.document().design().find<Patch>(patch);
    const QPoint from = patternPixel(toLayout(start, start.outline.boundingBox().center()));
    move(view, from, Qt::NoButton);
    press(view, from);
    for (int i = 1; i <= 10; ++i) {
        move(view, from + QPoint(4 * i, 3 * i), Qt::LeftButton);
        waitForPicture();
    }
    release(view, from + QPoint(40, 30));
    ASSERT_EQ(window.document().history().count(), 2);
    EXPECT_NE(window.document().design().find<Patch>(patch)->position, start.position);
    EXPECT_TRUE(waitUntilAtRest());
    EXPECT_EQ(meshRevision(), revision);
}

} // namespace
} // namespace bolster
