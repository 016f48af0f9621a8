#include "CoverView.h"
#include "CoverSetup.h"
#include "Crosshair.h"
#include "Document.h"
#include "ElementEdits.h"
#include "Picture.h"
#include "PointerNote.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "ViewCube.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace bolster::test {
namespace {

class CoverViewTest : public testing::Test {
protected:
    CoverViewTest()
    {
        document.reset(twoSquares());
        view.setSoftwareRenderer(std::make_unique<StubRenderer>(log));
        view.resize(800, 600);
        view.show();
        view.shown().setSurface(twoSquaresCover());
        lookFromAbove();
    }

    void lookFromAbove()
    {
        Camera camera = view.navigation().camera();
        camera.azimuth = 0;
        camera.elevation = 1.2;
        camera.fit(Box3(Vec3(0, 0, 0), Vec3(400, 200, 50)));
        view.navigation().setCamera(camera);
    }

    QPointF pixel(const Vec3& point) const
    {
        const Vec2 at = *view.navigation().camera().pixel(point);
        return {at.x(), at.y()};
    }
    const BSpline3& curve() const { return document.design().find<FixationCurve>(curveId)->curve; }
    Vec3 point(int i) const { return curve().points()[static_cast<std::size_t>(i)]; }
    /// The point, selected with its curve.
    QPointF selectPoint(int i)
    {
        selection.set({curveId}, {{curveId, i}});
        return pixel(point(i));
    }

    std::shared_ptr<StubRenderer::Log> log = std::make_shared<StubRenderer::Log>();
    Document document;
    Selection selection;
    CoverView view{document, selection};
    Mouse mouse{view};
};

TEST_F(CoverViewTest, DrawsInSoftwareWithoutOpenGl)
{
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return log->count() > 0 && log->last().scene.surface == view.shown().surface(); }));
    EXPECT_NE(log->thread, std::this_thread::get_id());
    ASSERT_EQ(log->last().scene.patches.size(), 2u);
    EXPECT_EQ(log->last().scene.patches[0].patch, leftPatch);
    keepPicture(view, QStringLiteral("surface-software"));
}

TEST_F(CoverViewTest, SaysHowItDraws)
{
    CoverView other(document, selection);
    QSignalSpy notes(&other, &CoverView::rendererNote);
    other.resize(300, 200);
    other.show(); // without a renderer, too
    ASSERT_EQ(notes.count(), 1);
    EXPECT_FALSE(notes[0][0].toString().isEmpty());
    EXPECT_EQ(other.grabPicture().size(), QSize(300, 200));
}

TEST_F(CoverViewTest, IsCoarseWhileItMovesAndFineAtRest)
{
    mouse.drag({300, 300}, {340, 300}, Qt::MiddleButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return log->count() > 0 && log->last().moving; }));
    EXPECT_EQ(log->last().camera.size, Vec2(400, 300));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !log->last().moving; }));
    EXPECT_EQ(log->last().camera.size, Vec2(800, 600));
    EXPECT_EQ(log->last().camera.azimuth, view.navigation().camera().azimuth);
}

TEST_F(CoverViewTest, GrabsTheWholePicture)
{
    const QImage picture = view.grabPicture();
    EXPECT_EQ(picture.size(), QSize(800, 600));
    EXPECT_EQ(log->last().camera.size, Vec2(800, 600));
    EXPECT_FALSE(log->last().moving);
}

TEST_F(CoverViewTest, MiddleAndRightButtonTurn)
{
    for (const Qt::MouseButton button : {Qt::MiddleButton, Qt::RightButton}) {
        const Camera before = view.navigation().camera();
        mouse.drag({400, 300}, {500, 340}, button);
        EXPECT_LT(view.navigation().camera().azimuth, before.azimuth - 0.3);
        EXPECT_GT(view.navigation().camera().elevation, before.elevation);
        EXPECT_DOUBLE_EQ(view.navigation().camera().distance, before.distance);
    }
}

TEST_F(CoverViewTest, TurningIsAboutThePlaceUnderThePointer)
{
    const Vec3 place(50, 40, 0);
    const QPointF before = pixel(place);
    mouse.drag(before, before + QPointF(80, -30), Qt::MiddleButton);
    EXPECT_LT((pixel(place) - before).manhattanLength(), 0.05);
}

TEST_F(CoverViewTest, NeverTurnsUpsideDown)
{
    for (int i = 0; i < 5; ++i)
        mouse.drag({400, 50}, {400, 550}, Qt::MiddleButton);
    EXPECT_LE(view.navigation().camera().elevation, std::numbers::pi / 2 + 1e-9);
    EXPECT_GE(view.navigation().camera().upward().z(), -1e-9);
}

TEST_F(CoverViewTest, ShiftPans)
{
    const Vec3 place(50, 40, 0);
    const QPointF from = pixel(place), to = from + QPointF(120, -45);
    mouse.drag(from, to, Qt::MiddleButton, Qt::ShiftModifier);
    EXPECT_LT((pixel(place) - to).manhattanLength(), 0.05);
}

TEST_F(CoverViewTest, WheelZoomsAtThePointer)
{
    const Vec3 place(50, 40, 0);
    const QPointF at = pixel(place);
    const double before = view.navigation().camera().distance;
    mouse.wheel(at, 3);
    EXPECT_LT(view.navigation().camera().distance, 0.8 * before);
    EXPECT_LT((pixel(place) - at).manhattanLength(), 0.05);
    mouse.wheel(at, -3);
    EXPECT_NEAR(view.navigation().camera().distance, before, 1e-6);
}

TEST_F(CoverViewTest, LeftDragOnTheCoverTurnsAndSelectsNothing)
{
    const double before = view.navigation().camera().azimuth;
    mouse.drag(pixel({50, 40, 0}), pixel({50, 40, 0}) + QPointF(90, 0));
    EXPECT_NE(view.navigation().camera().azimuth, before);
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(CoverViewTest, ClickSelectsThePatch)
{
    mouse.click(pixel({50, 40, 0}));
    EXPECT_EQ(selection.elements(), Selection::Elements{leftPatch});
    mouse.click(pixel({350, 40, 0}), Qt::ShiftModifier);
    EXPECT_EQ(selection.elements(), (Selection::Elements{leftPatch, rightPatch}));
    mouse.click(pixel({350, 40, 0}));
    EXPECT_EQ(selection.elements(), Selection::Elements{rightPatch});
    mouse.click({5, 5});
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(CoverViewTest, ClickSelectsSeamsAndCurves)
{
    mouse.click(pixel({200, 30, 0}));
    EXPECT_EQ(selection.elements(), Selection::Elements{seamId});
    mouse.click(pixel(curve().at(0.3)));
    EXPECT_EQ(selection.elements(), Selection::Elements{curveId});
}

TEST_F(CoverViewTest, WhatIsHiddenIsNotHit)
{
    Camera camera = view.navigation().camera();
    camera.elevation = -1.2; // the curve lies behind the cover now
    view.navigation().setCamera(camera);
    mouse.click(pixel(curve().at(0.3)));
    EXPECT_EQ(selection.elements(), Selection::Elements{leftPatch});
    selection.set({curveId});
    mouse.click(pixel(curve().at(0.3))); // but a selected one is
    EXPECT_EQ(selection.elements(), Selection::Elements{curveId});
}

TEST_F(CoverViewTest, HoverIsShared)
{
    QSignalSpy places(&view, &CoverView::pointerMoved);
    mouse.move(pixel({350, 40, 0}));
    EXPECT_EQ(selection.hovered(), rightPatch);
    ASSERT_EQ(places.count(), 1);
    const auto place = places[0][0].value<std::optional<Vec3>>();
    ASSERT_TRUE(place);
    EXPECT_LT((*place - Vec3(350, 40, 0)).norm(), 0.1);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&view, &leave);
    EXPECT_EQ(selection.hovered(), noElement);
    EXPECT_FALSE(places.last()[0].value<std::optional<Vec3>>());
}

TEST_F(CoverViewTest, PromptSaysWhatCanBeDone)
{
    QSignalSpy prompts(&view, &CoverView::promptChanged);
    mouse.move(pixel({350, 40, 0}));
    const QString overCover = view.prompt();
    mouse.move(pixel(curve().at(0.3)));
    EXPECT_NE(view.prompt(), overCover);
    EXPECT_EQ(prompts.last()[0].toString(), view.prompt());
}

TEST_F(CoverViewTest, TakesAGestureBackThatThrows)
{
    const Design before = document.design();
    const QPointF from = selectPoint(1);
    QSignalSpy failed(&view, &CoverView::failed);
    bool thrown = false;
    QObject::connect(&document, &Document::changed, &view, [&] {
        if (document.gestureRunning() && !std::exchange(thrown, true))
            throw std::runtime_error("no memory left");
    });
    mouse.press(from);
    mouse.move(from + QPointF(30, 20));
    ASSERT_TRUE(thrown);
    EXPECT_FALSE(document.gestureRunning());
    EXPECT_TRUE(document.design() == before);
    EXPECT_EQ(failed.count(), 1);
    mouse.release(from + QPointF(30, 20));
    EXPECT_TRUE(document.design() == before);
}

TEST_F(CoverViewTest, DraggingAControlPointChangesTheDesign)
{
    const Vec3 before = point(1);
    const QPointF from = selectPoint(1);
    const std::uint64_t revision = document.revision();
    const NodeId node = document.history().current();
    mouse.press(from);
    mouse.move(from + QPointF(30, 20));
    EXPECT_TRUE(document.gestureRunning());
    EXPECT_GT(document.revision(), revision);
    const Vec3 during = point(1);
    EXPECT_GT((during - before).norm(), 5);
    mouse.move(from + QPointF(60, 40));
    EXPECT_GT((point(1) - before).norm(), (during - before).norm());
    EXPECT_EQ(document.history().current(), node); // nothing is committed yet
    mouse.release(from + QPointF(60, 40));
    EXPECT_FALSE(document.gestureRunning());
    EXPECT_EQ(document.history().count(), node + 2);
    // Parallel to the screen, and under the pointer.
    EXPECT_NEAR(view.navigation().camera().depth(point(1)), view.navigation().camera().depth(before), 1e-6);
    EXPECT_LT((pixel(point(1)) - from - QPointF(60, 40)).manhattanLength(), 0.05);
    document.undo();
    EXPECT_EQ(point(1), before);
}

TEST_F(CoverViewTest, PointIsSelectedByPressingIt)
{
    selection.set({curveId});
    const QPointF from = pixel(point(2));
    mouse.drag(from, from + QPointF(20, 0));
    EXPECT_EQ(selection.points(), (Selection::Points{{curveId, 2}}));
    EXPECT_LT((pixel(point(2)) - from - QPointF(20, 0)).manhattanLength(), 0.05);
}

TEST_F(CoverViewTest, EscapeRestoresTheDesign)
{
    const Design before = document.design();
    const QPointF from = selectPoint(1);
    mouse.press(from);
    mouse.move(from + QPointF(50, 0));
    EXPECT_FALSE(document.design() == before);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(document.design() == before);
    mouse.move(from + QPointF(70, 0));
    mouse.release(from + QPointF(70, 0));
    EXPECT_TRUE(document.design() == before);
    EXPECT_FALSE(document.history().canUndo());
}

TEST_F(CoverViewTest, EscapeGoesBackStepByStep)
{
    selectPoint(1);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(selection.points().empty());
    EXPECT_TRUE(selection.contains(curveId));
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(CoverViewTest, UndoDuringADragEndsIt)
{
    const Design before = document.design();
    const QPointF from = selectPoint(1);
    mouse.press(from);
    mouse.move(from + QPointF(50, 0));
    document.cancelGesture();
    EXPECT_TRUE(document.design() == before);
    mouse.move(from + QPointF(80, 0));
    mouse.release(from + QPointF(80, 0));
    EXPECT_TRUE(document.design() == before);
}

TEST_F(CoverViewTest, KeysKeepToAnAxis)
{
    const Vec3 before = point(1);
    const QPointF from = selectPoint(1);
    mouse.press(from);
    mouse.move(from + QPointF(60, 35));
    QTest::keyClick(&view, Qt::Key_X);
    const Vec3 alongX = point(1) - before;
    EXPECT_GT(alongX.x(), 5);
    EXPECT_NEAR(alongX.y(), 0, 1e-9);
    EXPECT_NEAR(alongX.z(), 0, 1e-9);
    EXPECT_NEAR(pixel(point(1)).x(), from.x() + 60, 6);
    QTest::keyClick(&view, Qt::Key_Y);
    EXPECT_NEAR((point(1) - before).x(), 0, 1e-9);
    EXPECT_LT((point(1) - before).y(), -5);
    QTest::keyClick(&view, Qt::Key_Y); // free again
    EXPECT_GT((point(1) - before).x(), 5);
    mouse.release(from + QPointF(60, 35));
}

TEST_F(CoverViewTest, ShiftKeepsToTheDominantAxis)
{
    const Vec3 before = point(1);
    const QPointF from = selectPoint(1);
    mouse.press(from);
    mouse.move(from + QPointF(60, 8), Qt::ShiftModifier);
    const Vec3 moved = point(1) - before;
    EXPECT_GT(moved.x(), 5);
    EXPECT_NEAR(moved.tail<2>().norm(), 0, 1e-9);
    mouse.release(from + QPointF(60, 8), Qt::ShiftModifier);
}

TEST_F(CoverViewTest, SelectedPointsMoveTogether)
{
    const Vec3 one = point(1), two = point(2), three = point(3);
    selection.set({curveId}, {{curveId, 1}, {curveId, 2}});
    const QPointF from = pixel(one);
    mouse.drag(from, from + QPointF(40, -10));
    const Vec3 moved = point(1) - one;
    EXPECT_GT(moved.norm(), 5);
    EXPECT_LT((point(2) - two - moved).norm(), 1e-9);
    EXPECT_EQ(point(3), three);
    EXPECT_EQ(document.history().count(), 2);
}

TEST_F(CoverViewTest, ArrowKeysNudge)
{
    const Vec3 before = point(1);
    selectPoint(1);
    QTest::keyPress(&view, Qt::Key_Right);
    QTest::keyPress(&view, Qt::Key_Right);
    QTest::keyPress(&view, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_LT((point(1) - before - Vec3(12, 0, 0)).norm(), 1e-9);
    QTest::keyRelease(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Up); // seen from above, up is +y and away is -z
    QTest::keyClick(&view, Qt::Key_PageUp);
    EXPECT_LT((point(1) - before - Vec3(12, 1, -1)).norm(), 1e-9);
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.history().count() == 2; })) << "one edit for the series";
}

TEST_F(CoverViewTest, DeleteRemovesPointsAndDoubleClickAddsThem)
{
    const double t = 0.31;
    const Vec3 place = curve().at(t);
    const int count = curve().pointCount();
    mouse.doubleClick(pixel(place));
    EXPECT_EQ(curve().pointCount(), count + 1);
    EXPECT_LT((curve().at(t) - place).norm(), 1e-9); // the same shape
    ASSERT_EQ(selection.points().size(), 1u);
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_EQ(curve().pointCount(), count);
    EXPECT_LT((curve().at(t) - place).norm(), 1e-6);
}

TEST_F(CoverViewTest, WhatCannotBeRemovedIsReported)
{
    QSignalSpy problems(&view, &CoverView::failed);
    selectPoint(1);
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_EQ(curve().pointCount(), 4);
    ASSERT_EQ(problems.count(), 1);
    EXPECT_FALSE(problems[0][0].toString().isEmpty());
}

/// A box of foam beside the cover, selected, with handles around it.
class CoverViewGizmo : public CoverViewTest {
protected:
    CoverViewGizmo()
    {
        Cushion cushion;
        Foam foam;
        foam.name = "Block";
        foam.cushion = ElementId{20};
        foam.position = Vec3(200, 100, 0);
        document.reset(twoSquares().with(
            {{}, {{ElementId{20}, nullptr, makeElement(cushion)}, {foamId, nullptr, makeElement(foam)}}}));
        lookFromAbove();
        selection.set({foamId});
    }

    Foam foam() const { return *document.design().find<Foam>(foamId); }
    /// A place on the handle, by pixels along an axis.
    QPointF onArrow(int axis, double pixels) const
    {
        const Vec3 at = foam().position;
        return pixel(at + pixels * view.navigation().camera().pixelSize(at) * Vec3::Unit(axis));
    }

    const ElementId foamId{21};
};

TEST_F(CoverViewGizmo, ArrowsMoveAlongTheirAxis)
{
    mouse.drag(onArrow(0, 60), onArrow(0, 60) + (pixel(Vec3(237, 100, 0)) - pixel(Vec3(200, 100, 0))));
    EXPECT_NEAR(foam().position.x(), 237, 1);
    EXPECT_EQ(foam().position.tail<2>(), Vec2(100, 0));
    EXPECT_EQ(document.history().node(document.history().current()).edit.verb.english(), "Move Block");
    document.undo();
    EXPECT_EQ(foam().position, Vec3(200, 100, 0)) << "the whole drag is one edit";
}

TEST_F(CoverViewGizmo, ControlSnaps)
{
    mouse.drag(onArrow(1, 60), onArrow(1, 60) + (pixel(Vec3(200, 127, 0)) - pixel(Vec3(200, 100, 0))),
               Qt::LeftButton, Qt::ControlModifier);
    EXPECT_NEAR(foam().position.y(), 130, 1e-9);
}

TEST_F(CoverViewGizmo, TheMiddleMovesWithThePointer)
{
    const QPointF middle = pixel(foam().position);
    mouse.drag(middle, middle + QPointF(40, -25));
    const QPointF after = pixel(foam().position);
    EXPECT_NEAR(after.x(), middle.x() + 40, 1);
    EXPECT_NEAR(after.y(), middle.y() - 25, 1);
}

TEST_F(CoverViewGizmo, RingsTurnAboutTheMiddle)
{
    // On the ring about z, away from the arrows.
    const Vec3 at = foam().position;
    const double radius = 74 * view.navigation().camera().pixelSize(at);
    const auto onRing = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return pixel(at + radius * Vec3(std::cos(angle), std::sin(angle), 0));
    };
    mouse.drag(onRing(-50), onRing(-20), Qt::LeftButton, Qt::ControlModifier);
    EXPECT_EQ(foam().position, at);
    const Eigen::AngleAxisd turn(foam().rotation);
    EXPECT_NEAR(turn.angle() * 180 / std::numbers::pi, 30, 1e-6);
    EXPECT_LT((turn.axis() - Vec3::UnitZ()).norm(), 1e-9);
}

TEST_F(CoverViewGizmo, EscapeRestores)
{
    const Design before = document.design();
    mouse.press(onArrow(0, 60));
    mouse.move(onArrow(0, 90));
    EXPECT_NE(document.design(), before);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(document.design(), before);
    mouse.release(onArrow(0, 90));
    EXPECT_EQ(document.design(), before);
    EXPECT_FALSE(document.history().canUndo());
    EXPECT_TRUE(selection.contains(foamId));
}

TEST_F(CoverViewGizmo, IsThereOnlyForWhatHasAPlace)
{
    selection.set({curveId});
    const Camera before = view.navigation().camera();
    mouse.drag(onArrow(0, 60), onArrow(0, 60) + QPointF(30, 0));
    EXPECT_EQ(foam().position, Vec3(200, 100, 0));
    EXPECT_NE(view.navigation().camera(), before) << "the drag turned the view";
}

TEST_F(CoverViewGizmo, FoamIsSelectedByAClick)
{
    selection.clear();
    view.shown().setSurface(nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] {
        mouse.click(pixel(foam().position));
        return selection.contains(foamId);
    }));
}

TEST_F(CoverViewTest, StandardViewsFlyThere)
{
    view.navigation().setStandardView(CoverView::StandardView::Right);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return view.navigation().camera().backward().isApprox(Vec3(1, 0, 0), 1e-6); }));
    view.navigation().setStandardView(CoverView::StandardView::Top);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return view.navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-6); }));
    const QRectF seen(0, 0, 800, 600);
    EXPECT_TRUE(seen.contains(pixel({0, 0, 0})));
    EXPECT_TRUE(seen.contains(pixel({400, 200, 0})));
}

TEST_F(CoverViewTest, ShowingAllOnTheWayToAViewArrivesThere)
{
    view.navigation().setStandardView(CoverView::StandardView::Top);
    view.navigation().fitAll(); // as soon as a cover that nothing holds is there
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return view.navigation().camera().backward().isApprox(Vec3(0, 0, 1), 1e-6); }));
}

TEST_F(CoverViewTest, WhatComesBackIsSeenFromWhereItWasSeen)
{
    const Camera before = view.navigation().camera();
    std::vector<ElementId> all;
    for (const auto& [id, element] : document.design().elements())
        all.push_back(id);
    document.commit(edits::removeElements(document.design(), all));
    view.shown().setSurface(nullptr);
    document.undo(); // the curves are there at once, the cover comes later
    EXPECT_EQ(view.navigation().camera(), before);
    view.shown().setSurface(twoSquaresCover());
    EXPECT_EQ(view.navigation().camera(), before);
}

TEST_F(CoverViewTest, CubeTurnsTheView)
{
    Camera camera = view.navigation().camera();
    camera.azimuth = 0.2;
    camera.elevation = 0.2;
    view.navigation().setCamera(camera);
    auto* cube = view.findChild<ViewCube*>();
    ASSERT_TRUE(cube);
    Mouse onCube(*cube);
    onCube.click(QPointF(cube->rect().center()));
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return view.navigation().camera().backward().isApprox(Vec3(0, -1, 0), 1e-6); }));
    onCube.drag({50, 50}, {70, 40});
    EXPECT_LT(view.navigation().camera().azimuth, -0.1);
}

TEST_F(CoverViewTest, NothingCoversTheCube)
{
    const auto* cube = view.findChild<ViewCube*>();
    const QPoint middle = cube->geometry().center();
    const auto shown = [&] { return view.grab(QRect(middle - QPoint(4, 4), QSize(9, 9))).toImage(); };
    const QImage before = shown();
    auto* cross = view.findChild<Crosshair*>();
    cross->showAt(QPointF(middle));
    EXPECT_TRUE(cross->isVisible());
    EXPECT_EQ(shown(), before);
    auto* note = view.findChild<PointerNote*>();
    note->showNote(SceneNote{"Left patch", QPointF(middle) - QPointF(20, 20)});
    EXPECT_EQ(shown(), before);
}

TEST_F(CoverViewTest, FitSelectionComesCloser)
{
    const double whole = view.navigation().camera().distance;
    selection.set({leftPatch});
    view.navigation().fitSelection();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.navigation().camera().distance < 0.8 * whole; }));
}

TEST_F(CoverViewTest, OrthographicIsAnnounced)
{
    QSignalSpy changes(&view.navigation(), &CoverNavigation::perspectiveChanged);
    view.navigation().setPerspective(false);
    EXPECT_FALSE(view.navigation().perspective());
    EXPECT_EQ(changes.count(), 1);
    mouse.click(pixel({50, 40, 0}));
    EXPECT_EQ(selection.elements(), Selection::Elements{leftPatch});
}

TEST_F(CoverViewTest, HiddenLayersAreNotHit)
{
    view.visibility().setLayerVisible(CoverView::Layer::FixationCurves, false);
    mouse.click(pixel(curve().at(0.3)));
    EXPECT_EQ(selection.elements(), Selection::Elements{leftPatch});
    view.visibility().setLayerVisible(CoverView::Layer::Cover, false);
    mouse.click(pixel({50, 40, 0}));
    EXPECT_TRUE(selection.elements().empty());
    EXPECT_TRUE(view.shown().surface()); // only hidden
}

TEST_F(CoverViewTest, LivesWithBrokenSurfaces)
{
    auto broken = std::make_shared<SurfaceMesh>(*twoSquaresCover());
    for (Vec3& p : broken->positions)
        p.setConstant(std::numeric_limits<double>::quiet_NaN());
    view.shown().setSurface(broken);
    mouse.move({400, 300});
    QCoreApplication::processEvents();
    auto short_ = std::make_shared<SurfaceMesh>(*twoSquaresCover());
    short_->positions.pop_back();
    view.shown().setSurface(short_);
    EXPECT_FALSE(view.shown().surface());
    view.shown().setSurface(nullptr);
    mouse.move({400, 300});
    EXPECT_FALSE(view.grabPicture().isNull());
}

TEST_F(CoverViewTest, FollowsTheSurfaceWhenItMoves)
{
    auto moved = std::make_shared<SurfaceMesh>(*view.shown().surface());
    for (Vec3& p : moved->positions)
        p.x() += 1000;
    mouse.move(pixel({50, 40, 0}));
    EXPECT_EQ(selection.hovered(), leftPatch);
    view.shown().setSurface(moved);
    mouse.move(pixel({50, 40, 0}));
    EXPECT_EQ(selection.hovered(), noElement);
    EXPECT_EQ(view.hit(pixel({1050, 40, 0})).element, leftPatch);
}

TEST_F(CoverViewTest, TheTargetOfAHandleIsDraggedLikeAFixationCurve)
{
    const ElementId id{9};
    const BSpline2 drawn(1, false, {{40, 150}, {160, 150}});
    const HandleCurve handle{{"Handle", leftPatch, drawn}, BSpline3(1, false, {{40, 150, 0}, {160, 150, 0}})};
    document.commit({{}, {{id, nullptr, makeElement(handle)}}});
    const auto target = [&] { return document.design().find<HandleCurve>(id)->target; };
    mouse.click(pixel({100, 150, 0}));
    ASSERT_EQ(selection.elements(), Selection::Elements{id});
    const QPointF from = pixel({160, 150, 0});
    mouse.drag(from, from + QPointF(20, -15));
    EXPECT_LT((pixel(target().points()[1]) - from - QPointF(20, -15)).manhattanLength(), 0.05);
    EXPECT_EQ(target().points()[0], Vec3(40, 150, 0));
    EXPECT_TRUE(document.design().find<HandleCurve>(id)->curve == drawn) << "the pattern stays";
    EXPECT_EQ(selection.points(), (Selection::Points{{id, firstSpacePoint + 1}}));
    QTest::keyClick(&view, Qt::Key_Delete);
    EXPECT_EQ(target().pointCount(), 2) << "a line needs both";
}

TEST_F(CoverViewTest, FancySeamsAreHitOnTheCover)
{
    const ElementId id{9};
    document.commit(
        {{}, {{id, nullptr, makeElement(FancySeam{{"Seam", leftPatch, BSpline2(1, false, {{0, 0}, {1, 1}})}})}}});
    auto surface = std::make_shared<SurfaceMesh>(*view.shown().surface());
    auto topology = std::make_shared<SurfaceTopology>(*surface->topology);
    topology->lines.push_back({id, {}, 0});
    for (const std::uint32_t v : topology->triangles.front())
        topology->lines.back().vertices.push_back(v);
    ++topology->serial;
    const std::vector<std::uint32_t> vertices = topology->lines.back().vertices;
    surface->topology = std::move(topology);
    view.shown().setSurface(surface);
    const Vec3 middle = 0.5 * (surface->positions[vertices[1]] + surface->positions[vertices[2]]);
    mouse.click(pixel(middle));
    EXPECT_EQ(selection.elements(), Selection::Elements{id});
}

} // namespace
} // namespace bolster::test
