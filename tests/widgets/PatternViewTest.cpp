#include "PatternView.h"
#include "DesignFile.h"
#include "Document.h"
#include "ElementEdits.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "TestDesigns.h"
#include "TestPaths.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace bolster {
namespace {

class PatternViewTest : public testing::Test {
protected:
    PatternViewTest()
    {
        document.reset(twoSquares());
        view.resize(900, 700);
        view.show();
        view.navigation().fitAll();
    }

    QPoint pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout).toPoint(); }

    void move(QPoint to, Qt::KeyboardModifiers modifiers = {})
    {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, pressed, modifiers);
        QApplication::sendEvent(&view, &event);
    }

    void press(QPoint at, Qt::KeyboardModifiers modifiers = {})
    {
        move(at);
        pressed = Qt::LeftButton;
        QTest::mousePress(&view, Qt::LeftButton, modifiers, at);
    }

    void release(QPoint at, Qt::KeyboardModifiers modifiers = {})
    {
        pressed = Qt::NoButton;
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, at);
    }

    void click(QPoint at, Qt::KeyboardModifiers modifiers = {})
    {
        press(at, modifiers);
        release(at, modifiers);
    }

    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {})
    {
        press(from, modifiers);
        move((from + to) / 2, modifiers);
        move(to, modifiers);
        release(to, modifiers);
    }

    const Patch& patch(ElementId id) const { return *document.design().find<Patch>(id); }
    Vec2 mm(QPoint pixels) const { return Vec2(pixels.x(), -pixels.y()) / view.navigation().transform().scale(); }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    Qt::MouseButtons pressed = Qt::NoButton;
};

TEST_F(PatternViewTest, TheLetterOfASeamSelectsIt)
{
    view.grab(); // painted
    ASSERT_FALSE(view.shown().badges().empty());
    const SeamBadge badge = view.shown().badges().front();
    EXPECT_EQ(badge.seam, squareSeam);
    move(badge.box.center().toPoint());
    EXPECT_EQ(selection.hovered(), squareSeam);
    click(badge.box.center().toPoint());
    EXPECT_EQ(selection.elements(), Selection::Elements{squareSeam});
    const auto outline = patch(badge.patch).outline;
    QTest::mouseDClick(&view, Qt::LeftButton, {}, badge.box.center().toPoint());
    EXPECT_EQ(patch(badge.patch).outline, outline) << "no place of the outline is meant";
}

TEST_F(PatternViewTest, ClicksAtOnePlaceGoThroughWhatIsSewnAndFixedThere)
{
    FixationSeam fixation = *document.design().find<FixationSeam>(squareFixation);
    fixation.stretch = {secondSquare, 3, 4}; // where it is sewn, too
    document.commit(edits::replaceElement(document.design(), squareFixation, makeElement(fixation), {"Fix"}));
    const QPoint at = pixel({200, 40});
    for (const ElementId expected : {squareFixation, squareSeam, secondSquare, squareFixation}) {
        click(at);
        EXPECT_EQ(selection.elements(), Selection::Elements{expected});
    }
    click(pixel({200, 70})); // at another place one begins anew
    EXPECT_EQ(selection.elements(), Selection::Elements{squareFixation});
}

TEST_F(PatternViewTest, WhatTheCoverViewHidesIsFaintUntilItIsSelected)
{
    const auto cloth = [&](const Vec2& at) { return view.grab().toImage().pixelColor(pixel(at)); };
    const QColor canvas = cloth({150, 50});
    const auto strength = [&](const Vec2& at) {
        const QColor color = cloth(at);
        return std::abs(color.red() - canvas.red()) + std::abs(color.green() - canvas.green()) +
               std::abs(color.blue() - canvas.blue());
    };
    const int first = strength({30, 20}), second = strength({230, 20});
    view.shown().setHidden({secondSquare});
    EXPECT_EQ(strength({30, 20}), first);
    EXPECT_LT(strength({230, 20}), second / 2);
    selection.set({secondSquare});
    EXPECT_GE(strength({230, 20}), second);
    selection.clear();
    view.shown().setHidden({});
    EXPECT_EQ(strength({230, 20}), second);
}

TEST_F(PatternViewTest, SelectsByClickAndAddsWithShift)
{
    click(pixel({50, 50}));
    EXPECT_EQ(selection.elements(), Selection::Elements{firstSquare});
    click(pixel({250, 50}), Qt::ShiftModifier);
    EXPECT_EQ(selection.elements(), (Selection::Elements{firstSquare, secondSquare}));
    click(pixel({250, 50}));
    EXPECT_EQ(selection.elements(), Selection::Elements{secondSquare});
    click(pixel({100, 50}));
    EXPECT_EQ(selection.elements(), Selection::Elements{squareSeam});
    click(pixel({150, 50}));
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(PatternViewTest, HoversInStepWithTheSelection)
{
    move(pixel({50, 50}));
    EXPECT_EQ(selection.hovered(), firstSquare);
    move(pixel({100, 50}));
    EXPECT_EQ(selection.hovered(), squareSeam);
    move(pixel({150, 50}));
    EXPECT_EQ(selection.hovered(), noElement);
}

TEST_F(PatternViewTest, DragsAControlPointAsOneEdit)
{
    selection.set({firstSquare});
    const QPoint by(24, -30);
    drag(pixel({0, 100}), pixel({0, 100}) + by);
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_TRUE(patch(firstSquare).outline.points()[3].isApprox(Vec2(0, 100) + mm(by), 1e-9));
    EXPECT_TRUE(selection.contains(Selection::Point{firstSquare, 3}));
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(PatternViewTest, TakesAGestureBackThatThrows)
{
    selection.set({firstSquare});
    QSignalSpy failed(&view, &PatternView::failed);
    bool thrown = false;
    QObject::connect(&document, &Document::changed, &view, [&] {
        if (document.gestureRunning() && !std::exchange(thrown, true))
            throw std::runtime_error("no memory left");
    });
    press(pixel({0, 100}));
    move(pixel({0, 100}) + QPoint(20, 20));
    ASSERT_TRUE(thrown);
    EXPECT_FALSE(document.gestureRunning());
    EXPECT_TRUE(document.design() == twoSquares());
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed.front().front().toString().contains(QStringLiteral("no memory left")));
    release(pixel({0, 100}) + QPoint(30, 30));
    EXPECT_EQ(document.history().count(), 1);
    drag(pixel({0, 100}), pixel({0, 100}) + QPoint(20, 20));
    EXPECT_EQ(document.history().count(), 2) << "the next one works";
}

TEST_F(PatternViewTest, DragsSelectedPointsTogetherInTurnedPatches)
{
    Patch turned = patch(firstSquare);
    turned.rotation = 90;
    document.commit({{}, {{firstSquare, nullptr, makeElement(turned)}}});
    const auto corner = [&](std::size_t i) {
        return toLayout(patch(firstSquare), patch(firstSquare).outline.points()[i]);
    };
    const Vec2 first = corner(1);
    const Vec2 second = corner(2);
    selection.set({firstSquare}, {{firstSquare, 1}, {firstSquare, 2}});
    const QPoint by(-20, 10);
    drag(pixel(second), pixel(second) + by);
    EXPECT_LT((corner(1) - first - mm(by)).norm(), 1e-9);
    EXPECT_LT((corner(2) - second - mm(by)).norm(), 1e-9);
}

TEST_F(PatternViewTest, KeepsToOneAxisWithShift)
{
    selection.set({firstSquare}, {{firstSquare, 3}});
    const QPoint from = pixel({0, 100});
    press(from);
    move(from + QPoint(40, 9), Qt::ShiftModifier);
    release(from + QPoint(40, 9), Qt::ShiftModifier);
    EXPECT_NEAR(patch(firstSquare).outline.points()[3].y(), 100, 1e-9);
    EXPECT_NEAR(patch(firstSquare).outline.points()[3].x(), mm({40, 0}).x(), 1e-9);
}

TEST_F(PatternViewTest, MovesAndTurnsPatchesInTheLayout)
{
    const QPoint by(0, 60);
    drag(pixel({50, 50}), pixel({50, 50}) + by);
    EXPECT_TRUE(patch(firstSquare).position.isApprox(mm(by), 1e-9));
    EXPECT_EQ(patch(firstSquare).outline, twoSquares().find<Patch>(firstSquare)->outline);

    document.undo();
    selection.set({firstSquare});
    const QPoint handle = pixel({50, 100}) - QPoint(0, 26);
    // To the right of the middle is a quarter turn clockwise.
    drag(handle, pixel({50, 50}) + QPoint(200, 0), Qt::ShiftModifier);
    EXPECT_EQ(document.history().count(), 3);
    EXPECT_NEAR(std::remainder(patch(firstSquare).rotation + 90, 360), 0, 1e-9);
    EXPECT_LT((toLayout(patch(firstSquare), {50, 50}) - Vec2(50, 50)).norm(), 1e-9);
}

TEST_F(PatternViewTest, SelectsWhatABoxHolds)
{
    drag(pixel({-20, 120}), pixel({320, -20}));
    EXPECT_EQ(selection.elements(), (Selection::Elements{firstSquare, secondSquare}));
    selection.set({firstSquare});
    drag(pixel({-20, 120}), pixel({50, -20}));
    EXPECT_EQ(selection.points(), (Selection::Points{{firstSquare, 0}, {firstSquare, 3}}));
}

TEST_F(PatternViewTest, AddsAPointWithADoubleClick)
{
    QTest::mouseDClick(&view, Qt::LeftButton, {}, pixel({40, 0}));
    EXPECT_EQ(patch(firstSquare).outline.pointCount(), 5);
    ASSERT_EQ(selection.points().size(), 1U);
    const Vec2 added =
        patch(firstSquare).outline.points()[static_cast<std::size_t>(selection.points().begin()->second)];
    EXPECT_LT((added - Vec2(40, 0)).norm(), 2);
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(PatternViewTest, MovesWithTheArrowKeysAsOneEditPerSeries)
{
    selection.set({firstSquare}, {{firstSquare, 0}});
    QTest::keyPress(&view, Qt::Key_Right);
    QTest::keyPress(&view, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyRelease(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Down);
    EXPECT_TRUE(patch(firstSquare).outline.points()[0].isApprox(Vec2(12, -1)));
    selection.set({secondSquare}); // another series
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_TRUE(patch(secondSquare).position.isApprox(Vec2(200, 1)));
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.history().count() == 3; })) << "a pause ends it";
    document.undo();
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(PatternViewTest, NothingOfASeriesOfArrowKeysIsLost)
{
    selection.set({firstSquare});
    const auto nudge = [&] {
        QTest::keyClick(&view, Qt::Key_Right);
        QTest::keyClick(&view, Qt::Key_Right);
    };
    const auto x = [&] { return patch(firstSquare).position.x(); };
    const double start = x();
    nudge();
    document.cancelGesture(); // as commands and dialogs do first
    EXPECT_EQ(x(), start + 2);
    nudge();
    document.undo();
    EXPECT_EQ(x(), start + 2) << "the series is what is undone";
    document.redo();
    EXPECT_EQ(x(), start + 4);
    nudge();
    document.jumpTo(0);
    EXPECT_EQ(x(), start);
    EXPECT_EQ(document.history().count(), 4);
    document.jumpTo(3);
    EXPECT_EQ(x(), start + 6);

    nudge();
    QTest::keyClick(&view, Qt::Key_Escape); // leaves the selection, not the place
    EXPECT_EQ(x(), start + 8);
    EXPECT_FALSE(document.gestureRunning());
}

TEST_F(PatternViewTest, EscapeGoesBackStepByStep)
{
    selection.set({firstSquare}, {{firstSquare, 0}});
    const QPoint from = pixel({0, 0});
    press(from);
    move(from + QPoint(30, 0));
    EXPECT_FALSE(document.design() == twoSquares());
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(document.design() == twoSquares());
    release(from + QPoint(30, 0));
    EXPECT_EQ(document.history().count(), 1);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(selection.points().empty());
    EXPECT_FALSE(selection.elements().empty());
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(PatternViewTest, ZoomsAtThePointerAndPans)
{
    const QPointF at(200, 300);
    const Vec2 under = view.navigation().transform().toLayout(at);
    const double scale = view.navigation().transform().scale();
    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view, &wheel);
    EXPECT_GT(view.navigation().transform().scale(), scale);
    EXPECT_TRUE(view.navigation().transform().toLayout(at).isApprox(under, 1e-9));

    for (const bool withSpace : {false, true}) {
        const Vec2 before = view.navigation().transform().toLayout(at);
        if (withSpace)
            QTest::keyPress(&view, Qt::Key_Space);
        const Qt::MouseButton button = withSpace ? Qt::LeftButton : Qt::MiddleButton;
        QTest::mousePress(&view, button, {}, at.toPoint());
        pressed = button;
        move(at.toPoint() + QPoint(50, 20));
        QTest::mouseRelease(&view, button, {}, at.toPoint() + QPoint(50, 20));
        QTest::keyRelease(&view, Qt::Key_Space);
        EXPECT_TRUE(view.navigation().transform().toLayout(at + QPointF(50, 20)).isApprox(before, 1e-9));
    }
    EXPECT_EQ(document.history().count(), 1);
    QTest::keyClick(&view, Qt::Key_Home);
    EXPECT_EQ(view.navigation().transform().scale(), scale);
}

TEST_F(PatternViewTest, StaysFittedInAnySizeUntilTheUserMovesIt)
{
    const auto whole = [&] {
        const QRect inside = view.rect().adjusted(20, 20, -20, -20);
        PatternScene scene;
        scene.reset(document.design());
        const Box2 box = scene.boundingBox();
        return inside.contains(pixel(box.min())) && inside.contains(pixel(box.max()));
    };
    for (const QSize size : {QSize(300, 200), QSize(200, 600), QSize(900, 700)}) {
        view.resize(size);
        EXPECT_TRUE(whole()) << size.width();
    }
    view.navigation().setTransform(view.navigation().transform().zoomed({450, 350}, 4));
    const double scale = view.navigation().transform().scale();
    view.resize(400, 300);
    EXPECT_EQ(view.navigation().transform().scale(), scale);
}

TEST_F(PatternViewTest, TellsWhatCanBeDone)
{
    QSignalSpy prompts(&view, &PatternView::promptChanged);
    move(pixel({150, 50}));
    const QString outside = view.prompt();
    move(pixel({50, 50}));
    EXPECT_NE(view.prompt(), outside);
    EXPECT_GE(prompts.count(), 1);
}

TEST_F(PatternViewTest, RemovesPointsOrElementsWithTheirSeams)
{
    selection.set({firstSquare}, {{firstSquare, 0}});
    document.commit(removeSelected(document.design(), selection, nullptr));
    EXPECT_EQ(patch(firstSquare).outline.pointCount(), 3);
    document.undo();
    selection.set({firstSquare});
    document.commit(removeSelected(document.design(), selection, nullptr));
    pruneSelection(selection, document.design());
    EXPECT_FALSE(document.design().element(firstSquare));
    EXPECT_FALSE(document.design().element(squareSeam));
    EXPECT_TRUE(document.design().element(squareFixation));
    EXPECT_TRUE(selection.elements().empty());

    QString problem;
    selection.set({testFabric});
    EXPECT_TRUE(removeSelected(document.design(), selection, &problem).empty());
    EXPECT_FALSE(problem.isEmpty());
}

TEST_F(PatternViewTest, ShowsProblemsInRed)
{
    const auto redness = [&] {
        const QColor inside = view.grab().toImage().pixelColor(pixel({50, 20}));
        return inside.red() - inside.blue();
    };
    const int before = redness();
    problems.set({{firstSquare, "", "outline", {"the outline crosses itself", {}}, Severity::Error}});
    EXPECT_GT(redness(), before);
}

TEST_F(PatternViewTest, DrawsTheArmchair)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(test::samplesFolder() + "/armchair/armchair.json"));
    ASSERT_TRUE(opened.readable);
    document.reset(opened.design);
    view.navigation().fitAll();
    keepPicture(view, QStringLiteral("armchair"));
    selection.set({ElementId{6}});
    view.navigation().fitSelection();
    keepPicture(view, QStringLiteral("armchair-seat"));
    selection.set({ElementId{48}});
    view.navigation().fitSelection();
    keepPicture(view, QStringLiteral("armchair-seam"));
}

/// The first square as two triangles, lying 50 mm up.
SurfaceMeshPtr firstSquareSurface()
{
    auto topology = std::make_shared<SurfaceTopology>();
    topology->serial = 1;
    topology->pattern = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    topology->triangles = {{0, 1, 2}, {0, 2, 3}};
    topology->unknown = {0, 1, 2, 3};
    topology->unknownCount = 4;
    topology->patches = {{firstSquare, testFabric, 0, 4, 0, 2, 4}};
    auto surface = std::make_shared<SurfaceMesh>();
    for (const Vec2& p : topology->pattern)
        surface->positions.emplace_back(p.x(), p.y(), 50);
    surface->normals.assign(4, Eigen::Vector3f::UnitZ());
    surface->topology = std::move(topology);
    return surface;
}

class PatternDrawTest : public PatternViewTest {
protected:
    void doubleClick(QPoint at)
    {
        click(at);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, at);
        QCoreApplication::processEvents();
    }
    void key(Qt::Key code)
    {
        QTest::keyClick(&view, code);
        QCoreApplication::processEvents();
    }
    template <class T>
    std::vector<T> all() const
    {
        std::vector<T> found;
        document.design().each<T>([&](ElementId, const T& element) { found.push_back(element); });
        return found;
    }
};

TEST_F(PatternDrawTest, DrawsAHandleOnTheSurfaceAndGoesBackToSelecting)
{
    view.shown().setSurface(firstSquareSurface());
    QSignalSpy changed(&view, &PatternView::toolChanged);
    view.setTool(PatternToolKind::HandleCurve);
    EXPECT_EQ(view.tool(), PatternToolKind::HandleCurve);
    click(pixel({20, 20}));
    click(pixel({50, 70}));
    click(pixel({60, 30}));
    doubleClick(pixel({80, 80}));
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_EQ(changed.count(), 2);
    ASSERT_EQ(all<HandleCurve>().size(), 1u);
    const HandleCurve handle = all<HandleCurve>().front();
    EXPECT_EQ(handle.patch, firstSquare);
    EXPECT_EQ(handle.curve.degree(), 3);
    EXPECT_EQ(handle.curve.pointCount(), 4);
    for (const double t : {0.0, 0.3, 1.0}) {
        const Vec2 p = handle.curve.at(t);
        EXPECT_LT((handle.target.at(t) - Vec3(p.x(), p.y(), 50)).norm(), 0.2);
    }
    EXPECT_EQ(selection.elements(), Selection::Elements{document.design().elements().rbegin()->first});
    EXPECT_EQ(document.history().count(), 2) << "one edit";
}

TEST_F(PatternDrawTest, DrawsAFancySeamFromBorderToBorder)
{
    view.setTool(PatternToolKind::FancySeam);
    click(pixel({50, 2}));
    click(pixel({50, 50}));
    click(pixel({70, 97}));
    key(Qt::Key_Return);
    ASSERT_EQ(all<FancySeam>().size(), 1u);
    const BSpline2 curve = all<FancySeam>().front().curve;
    EXPECT_EQ(curve.degree(), 1);
    EXPECT_NEAR(curve.points().front().y(), 0, 1e-9) << "snapped to the outline";
    EXPECT_NEAR(curve.points().back().y(), 100, 1e-9);
    EXPECT_NEAR(curve.points()[1].x(), 50, 0.5);
}

TEST_F(PatternDrawTest, ClosesOnTheFirstPointAndTakesPointsBack)
{
    view.setTool(PatternToolKind::FancySeam);
    for (const Vec2& p : {Vec2(30, 30), Vec2(70, 30), Vec2(90, 90), Vec2(70, 70), Vec2(30, 70)}) {
        click(pixel(p));
        if (p == Vec2(90, 90))
            key(Qt::Key_Backspace);
    }
    click(pixel({30, 30}) + QPoint(2, 2));
    ASSERT_EQ(all<FancySeam>().size(), 1u);
    EXPECT_TRUE(all<FancySeam>().front().curve.closed());
    EXPECT_EQ(all<FancySeam>().front().curve.pointCount(), 4);
}

TEST_F(PatternDrawTest, EscapeGivesUpTheCurveThenTheTool)
{
    QSignalSpy failed(&view, &PatternView::failed);
    view.setTool(PatternToolKind::HandleCurve);
    click(pixel({150, 50}));
    EXPECT_EQ(failed.count(), 1) << "begins in a patch only";
    click(pixel({20, 20}));
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), PatternToolKind::HandleCurve);
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_TRUE(document.design() == twoSquares());

    view.setTool(PatternToolKind::HandleCurve);
    click(pixel({20, 20}));
    doubleClick(pixel({80, 80}));
    EXPECT_EQ(failed.count(), 2) << "no surface to lie on";
    EXPECT_TRUE(document.design() == twoSquares());
}

class PatternLineTest : public PatternDrawTest {
protected:
    PatternLineTest()
    {
        FancySeam seam{{"Pipe", firstSquare, BSpline2(1, false, {{20, 20}, {80, 20}, {80, 80}})}};
        document.reset(twoSquares().with({{}, {{line, nullptr, makeElement(seam)}}}));
        view.navigation().fitAll();
    }
    const BSpline2& curve() const { return document.design().find<FancySeam>(line)->curve; }

    const ElementId line{9};
};

TEST_F(PatternLineTest, IsSelectedMovedAndEditedLikeAnOutline)
{
    click(pixel({50, 20}));
    EXPECT_EQ(selection.elements(), Selection::Elements{line});
    const QPoint by(6, -9);
    drag(pixel({80, 80}), pixel({80, 80}) + by);
    EXPECT_LT((curve().points()[2] - Vec2(80, 80) - mm(by)).norm(), 1e-9);
    EXPECT_EQ(curve().points()[1], Vec2(80, 20));
    const QPoint middle = pixel({50, 20});
    QTest::mouseDClick(&view, Qt::LeftButton, {}, middle);
    EXPECT_EQ(curve().pointCount(), 4);
    EXPECT_EQ(selection.points(), (Selection::Points{{line, 1}}));
    const Edit removal = removeSelected(document.design(), selection, nullptr);
    removeAndForget(document, selection, removal);
    EXPECT_EQ(curve().pointCount(), 3);
    selection.set({line});
    drag(pixel({30, 20}), pixel({30, 20}) + by);
    EXPECT_LT((curve().points()[0] - Vec2(20, 20) - mm(by)).norm(), 1e-9) << "dragged as a whole";
}

TEST_F(PatternLineTest, GoesWithItsPatch)
{
    const Edit edit = [&] {
        selection.set({firstSquare});
        return removeSelected(document.design(), selection, nullptr);
    }();
    document.commit(edit);
    EXPECT_FALSE(document.design().element(line));
    document.undo();
    EXPECT_TRUE(document.design().element(line));
}

TEST_F(PatternLineTest, ShowsItsWidth)
{
    view.shown().setLayers({false, false, false, false, false});
    const QImage narrow = view.grab().toImage();
    FancySeam wide = *document.design().find<FancySeam>(line);
    wide.width = 30;
    document.commit({{}, {{line, document.design().element(line), makeElement(wide)}}});
    const QImage broad = view.grab().toImage();
    const QPoint beside = pixel({50, 30});
    EXPECT_NE(narrow.pixelColor(beside), broad.pixelColor(beside));
    EXPECT_EQ(narrow.pixelColor(pixel({40, 60})), broad.pixelColor(pixel({40, 60})));
}

TEST(SelectionPoints, AHandleHasPointsInThePatternAndInSpace)
{
    HandleCurve handle{{"H", firstSquare, BSpline2(1, false, {{20, 20}, {80, 20}})},
                       BSpline3(1, false, {{20, 20, 50}, {80, 20, 50}, {90, 20, 50}})};
    const ElementId id{9};
    const Design design = twoSquares().with({{}, {{id, nullptr, makeElement(handle)}}});
    EXPECT_EQ(planePoint(design, {id, 1}), 1);
    EXPECT_EQ(spacePoint(design, {id, 1}), -1);
    const int inSpace = selectionPoint(*design.element(id), 2);
    EXPECT_EQ(spacePoint(design, {id, inSpace}), 2);
    EXPECT_EQ(planePoint(design, {id, inSpace}), -1);
    EXPECT_EQ(spacePoint(design, {testCurve, 1}), 1);
    EXPECT_EQ(spacePoint(design, {testCurve, 2}), -1);
    EXPECT_EQ(planePoint(design, {firstSquare, 3}), 3);
}

} // namespace
} // namespace bolster
