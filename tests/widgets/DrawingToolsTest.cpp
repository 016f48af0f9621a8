// Patches drawn by hand, with the events of a real pointer.
#include "DesignCheck.h"
#include "Document.h"
#include "PatternRulers.h"
#include "PatternView.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "TestDesigns.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cmath>

namespace bolster {
namespace {

class DrawingTest : public testing::Test {
protected:
    DrawingTest()
    {
        document.reset(twoSquares());
        view.resize(1000, 800);
        view.show();
        Box2 box(Vec2(-100, -400));
        box.extend(Vec2(900, 400));
        view.navigation().setTransform(
            PatternTransform::fitting(box, view.size(), 0)); // a millimetre is a pixel wide
    }

    QPoint pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout).toPoint(); }
    void move(const Vec2& to, Qt::KeyboardModifiers modifiers = {})
    {
        const QPoint at = pixel(to);
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, pressed, modifiers);
        QApplication::sendEvent(&view, &event);
    }
    void press(const Vec2& at, Qt::KeyboardModifiers modifiers = {})
    {
        move(at, modifiers);
        pressed = Qt::LeftButton;
        QTest::mousePress(&view, Qt::LeftButton, modifiers, pixel(at));
    }
    void release(const Vec2& at, Qt::KeyboardModifiers modifiers = {})
    {
        pressed = Qt::NoButton;
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, pixel(at));
        QCoreApplication::processEvents();
    }
    void click(const Vec2& at, Qt::KeyboardModifiers modifiers = {})
    {
        press(at, modifiers);
        release(at, modifiers);
    }
    void drag(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {})
    {
        press(from, modifiers);
        move((from + to) / 2, modifiers);
        move(to, modifiers);
        release(to, modifiers);
    }
    void key(Qt::Key code)
    {
        QTest::keyClick(&view, code);
        QCoreApplication::processEvents();
    }
    void type(const char* text)
    {
        QTest::keyClicks(&view, QString::fromUtf8(text));
        key(Qt::Key_Return);
    }

    const Patch* drawn() const
    {
        const ElementId last = document.design().elements().rbegin()->first;
        return document.design().elements().size() > twoSquares().elements().size()
                   ? document.design().find<Patch>(last)
                   : nullptr;
    }
    std::vector<Vec2> drawnPoints() const
    {
        std::vector<Vec2> points;
        if (const Patch* patch = drawn())
            for (const Vec2& p : patch->outline.points())
                points.push_back(toLayout(*patch, p));
        return points;
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    Qt::MouseButtons pressed = Qt::NoButton;
};

TEST_F(DrawingTest, APolygonClosesOnItsFirstPoint)
{
    view.setTool(PatternToolKind::Outline);
    for (const Vec2& corner : {Vec2(400, 0), Vec2(600, 0), Vec2(650, 150), Vec2(400, 200)})
        click(corner);
    EXPECT_FALSE(drawn());
    click({402, 1});
    ASSERT_TRUE(drawn());
    EXPECT_EQ(drawn()->outline.degree(), 1);
    EXPECT_EQ(drawn()->name, "Patch 3");
    ASSERT_EQ(drawnPoints().size(), 4U);
    EXPECT_LT((drawnPoints()[2] - Vec2(650, 150)).norm(), 0.6);
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_EQ(selection.elements(), Selection::Elements{document.design().elements().rbegin()->first});
    EXPECT_EQ(document.history().count(), 2) << "one edit";
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(DrawingTest, APressAndDragMakesASmoothPoint)
{
    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    click({600, 0});
    drag({500, 150}, {440, 150});
    move({450, 100});
    keepPicture(view, QStringLiteral("draw-outline"));
    key(Qt::Key_Return);
    ASSERT_TRUE(drawn());
    const BSpline2& outline = drawn()->outline;
    EXPECT_EQ(outline.degree(), 3);
    EXPECT_EQ(outline.corners().size(), 2U);
    EXPECT_LT(outline.closest(fromLayout(*drawn(), {500, 150})).distance, 0.6);
    EXPECT_LT(outline.closest(fromLayout(*drawn(), {530, 0})).distance, 0.01) << "straight between corners";
    EXPECT_FALSE(outlineProblem(outline));
}

TEST_F(DrawingTest, ADoubleClickClosesToo)
{
    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    click({600, 0});
    click({600, 200});
    QTest::mouseDClick(&view, Qt::LeftButton, {}, pixel({600, 200}));
    QCoreApplication::processEvents();
    ASSERT_TRUE(drawn());
    EXPECT_EQ(drawn()->outline.pointCount(), 3);
}

TEST_F(DrawingTest, BackspaceAndEscapeGoBackStepByStep)
{
    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    click({600, 0});
    click({700, 300});
    key(Qt::Key_Backspace);
    click({600, 200});
    key(Qt::Key_Return);
    ASSERT_EQ(drawnPoints().size(), 3U);
    EXPECT_LT((drawnPoints()[2] - Vec2(600, 200)).norm(), 0.6);
    document.undo();

    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    QTest::keyClicks(&view, QStringLiteral("12"));
    key(Qt::Key_Escape); // the number
    key(Qt::Key_Escape); // the outline
    EXPECT_EQ(view.tool(), PatternToolKind::Outline);
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(DrawingTest, AnOutlineThatCrossesItselfIsShownAndRefused)
{
    QSignalSpy failed(&view, &PatternView::failed);
    view.setTool(PatternToolKind::Outline);
    for (const Vec2& corner : {Vec2(400, 0), Vec2(600, 0), Vec2(600, 200), Vec2(500, 200)})
        click(corner);
    const QString fine = view.prompt();
    move({500, -100});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("cross"))) << view.prompt().toStdString();
    const QColor line = view.grab().toImage().pixelColor(pixel({500, 100}));
    EXPECT_GT(line.red(), line.blue() + 60) << "in the colour of errors";
    click({500, -100});
    key(Qt::Key_Return);
    EXPECT_EQ(failed.count(), 1);
    EXPECT_FALSE(drawn());
    key(Qt::Key_Backspace);
    move({450, 150});
    EXPECT_EQ(view.prompt(), fine);
    key(Qt::Key_Return);
    EXPECT_TRUE(drawn()) << "nothing was lost";
}

TEST_F(DrawingTest, TypedLengthsSetPointsExactly)
{
    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    const Vec2 first = view.navigation().transform().toLayout(pixel({400, 0}));
    move({500, 0});
    type("250");
    type("100<90");
    move({300, 200});
    keepPicture(view, QStringLiteral("draw-typed"));
    type("-25 cm, 2*10");
    key(Qt::Key_Return);
    const std::vector<Vec2> expected = {first, first + Vec2(250, 0), first + Vec2(250, 100), first + Vec2(0, 120)};
    ASSERT_EQ(drawnPoints().size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT((drawnPoints()[i] - expected[i]).norm(), 1e-6) << i;
}

TEST_F(DrawingTest, WhatIsNoLengthIsReported)
{
    QSignalSpy failed(&view, &PatternView::failed);
    view.setTool(PatternToolKind::Outline);
    click({400, 0});
    move({500, 0});
    type("25 kg");
    EXPECT_EQ(failed.count(), 1);
    for (int i = 0; i < 3; ++i)
        key(Qt::Key_Backspace);
    key(Qt::Key_Return); // 25
    click({500, 200});
    key(Qt::Key_Return);
    ASSERT_EQ(drawnPoints().size(), 3U);
    EXPECT_NEAR((drawnPoints()[1] - drawnPoints()[0]).norm(), 25, 1e-6);
}

TEST_F(DrawingTest, RectanglesByDragClicksAndNumbers)
{
    view.setTool(PatternToolKind::Rectangle);
    drag({400, 0}, {600, 150});
    ASSERT_TRUE(drawn());
    EXPECT_TRUE(drawn()->outline.boundingBox().sizes().isApprox(Vec2(200, 150), 1e-6));
    document.undo();

    view.setTool(PatternToolKind::Rectangle);
    click({400, 0});
    click({700, -100});
    ASSERT_TRUE(drawn());
    EXPECT_TRUE(drawn()->outline.boundingBox().sizes().isApprox(Vec2(300, 100), 1e-6));
    document.undo();

    view.setTool(PatternToolKind::Rectangle);
    click({400, 0});
    move({380, 30});
    type("300x20 cm");
    ASSERT_TRUE(drawn());
    EXPECT_TRUE(drawn()->outline.boundingBox().sizes().isApprox(Vec2(300, 200), 1e-9));
    EXPECT_NEAR(drawn()->position.x(), view.navigation().transform().toLayout(pixel({400, 0})).x() - 300, 1e-6)
        << "towards the pointer";
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
}

TEST_F(DrawingTest, AClickTakesTheSizeThatIsShownAndTabSeparatesItsNumbers)
{
    view.setTool(PatternToolKind::Rectangle);
    click({400, 0});
    move({450, 30});
    for (const char key : std::string("300"))
        QTest::keyClick(&view, key);
    QTest::keyClick(&view, Qt::Key_Tab);
    for (const char key : std::string("200"))
        QTest::keyClick(&view, key);
    click({470, 60});
    ASSERT_TRUE(drawn());
    EXPECT_TRUE(drawn()->outline.boundingBox().sizes().isApprox(Vec2(300, 200), 1e-9));
}

TEST_F(DrawingTest, EllipsesAndCircles)
{
    view.setTool(PatternToolKind::Ellipse);
    press({400, 0});
    move({500, 40}, Qt::ShiftModifier);
    release({500, 40}, Qt::ShiftModifier);
    ASSERT_TRUE(drawn());
    EXPECT_NEAR(drawn()->outline.signedArea(), M_PI * 50 * 50, 10);
    EXPECT_TRUE(drawn()->outline.corners().empty());
}

TEST_F(DrawingTest, DrawsSnappedUnlessCtrlIsHeld)
{
    view.aids().setSnapping(true);
    view.setTool(PatternToolKind::Outline);
    click({304, 3}); // the corner of the second square
    move({403, 4});
    keepPicture(view, QStringLiteral("draw-snapped"));
    click({403, 4}); // level, and as long as an edge of the squares
    click({450, 203}, Qt::ControlModifier);
    key(Qt::Key_Return);
    ASSERT_EQ(drawnPoints().size(), 3U);
    EXPECT_LT((drawnPoints()[0] - Vec2(300, 0)).norm(), 1e-9);
    EXPECT_LT((drawnPoints()[1] - Vec2(400, 0)).norm(), 1e-6);
    EXPECT_LT((drawnPoints()[2] - view.navigation().transform().toLayout(pixel({450, 203}))).norm(), 1e-9);
}

TEST_F(DrawingTest, CurvesInPatchesAreDrawnSnappedToo)
{
    view.aids().setSnapping(true);
    view.setTool(PatternToolKind::FancySeam);
    click({20, 30});
    click({75, 33}); // nearly level
    key(Qt::Key_Return);
    const FancySeam* seam = document.design().find<FancySeam>(document.design().elements().rbegin()->first);
    ASSERT_TRUE(seam);
    EXPECT_NEAR(seam->curve.points()[0].y(), seam->curve.points()[1].y(), 1e-9);
}

TEST_F(DrawingTest, DraggedPointsAndPatchesSnap)
{
    view.aids().setSnapping(true);
    selection.set({firstSquare});
    drag({100, 100}, {203, 104});
    EXPECT_LT((document.design().find<Patch>(firstSquare)->outline.points()[2] - Vec2(200, 100)).norm(), 1e-9)
        << "onto the corner of the other square";
    document.undo();
    selection.set({firstSquare});
    drag({100, 100}, {203, 104}, Qt::AltModifier);
    EXPECT_GT((document.design().find<Patch>(firstSquare)->outline.points()[2] - Vec2(200, 100)).norm(), 1);
    document.undo();
    selection.clear();
    drag({50, 50}, {146, 54});
    EXPECT_EQ(document.design().find<Patch>(firstSquare)->position, Vec2(100, 0)) << "edge to edge";
}

TEST_F(DrawingTest, MeasuresBetweenPointsAndAlongEdges)
{
    view.aids().setSnapping(true);
    view.setTool(PatternToolKind::Measure);
    move({40, 0});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("100 mm"))) << "the edge";
    click({1, 1});
    click({299, 101});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("316.23 mm"))) << view.prompt().toStdString();
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("dx 300 mm, dy 100 mm")));
    keepPicture(view, QStringLiteral("measure"));
    key(Qt::Key_Escape);
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_EQ(document.history().count(), 1);
}

TEST_F(DrawingTest, AMeasurementIsKeptFollowsItsCornerAndIsSelectedByItsLine)
{
    view.aids().setSnapping(true);
    view.setTool(PatternToolKind::Measure);
    click({1, 1});
    click({600, 300});
    key(Qt::Key_Return);
    EXPECT_EQ(document.history().count(), 1) << "it ends beside the patches";
    click({1, 1});
    click({299, 101});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("Enter"))) << view.prompt().toStdString();
    key(Qt::Key_Return);
    ASSERT_EQ(document.history().count(), 2);
    ASSERT_EQ(selection.elements().size(), 1U);
    const ElementId kept = *selection.elements().begin();
    const auto measured = [&] { return *document.design().find<Measurement>(kept); };
    EXPECT_EQ(measured().name, "Measurement 1");
    EXPECT_EQ(measured().from, (PatchPoint{firstSquare, Vec2(0, 0)}));
    EXPECT_EQ(measured().to.patch, secondSquare);
    key(Qt::Key_Escape);
    view.aids().setSnapping(false);
    keepPicture(view, QStringLiteral("measurement"));

    selection.clear();
    click({150, 50});
    EXPECT_EQ(selection.elements(), Selection::Elements{kept}) << "between the patches";
    selection.set({firstSquare});
    drag({0, 0}, {-20, -30});
    EXPECT_LT((measured().from.position - Vec2(-20, -30)).norm(), 1e-9) << "it holds the corner";
    EXPECT_EQ(document.history().count(), 3) << "in one edit";
    document.undo();
    EXPECT_EQ(measured().from.position, Vec2(0, 0));
    PatternLayers layers = view.shown().layers();
    layers.measurements = false;
    view.shown().setLayers(layers);
    selection.clear();
    click({150, 50});
    EXPECT_TRUE(selection.elements().empty()) << "what is not shown is not hit";
}

TEST_F(DrawingTest, ALoopSelectsWhatItHolds)
{
    press({-20, -20}, Qt::AltModifier);
    for (const Vec2& p : {Vec2(120, -20), Vec2(120, 120), Vec2(-20, 120)})
        move(p, Qt::AltModifier);
    release({-20, -10}, Qt::AltModifier);
    EXPECT_EQ(selection.elements(), Selection::Elements{firstSquare});
    view.aids().setLasso(true);
    selection.clear();
    press({-20, -20});
    for (const Vec2& p : {Vec2(320, -20), Vec2(50, 50), Vec2(-20, 320)}) // cuts off the second square
        move(p);
    release({-20, -10});
    EXPECT_TRUE(selection.elements().empty());
}

TEST_F(DrawingTest, TheCornersOfTheBoxScale)
{
    selection.set({firstSquare});
    const auto box = [&] {
        const Patch& patch = *document.design().find<Patch>(firstSquare);
        const Box2 own = patch.outline.boundingBox();
        return Box2(toLayout(patch, own.min()), toLayout(patch, own.max()));
    };
    const Vec2 handle(112, 112);
    drag(handle, handle + Vec2(50, -40));
    EXPECT_LT((box().min() - Vec2(0, 0)).norm(), 1e-6) << "the opposite corner stays";
    EXPECT_LT((box().max() - Vec2(150, 60)).norm(), 1e-6);
    EXPECT_EQ(document.history().count(), 2);
    document.undo();
    drag(handle, handle + Vec2(30, 30), Qt::ShiftModifier);
    EXPECT_LT((box().max() - Vec2(130, 130)).norm(), 1e-6);
    document.undo();
    drag(handle, handle + Vec2(-400, -400)); // no further than to a hundredth, and not mirrored
    EXPECT_GT(box().sizes().minCoeff(), 0.9);
    document.undo();
    EXPECT_TRUE(document.design() == twoSquares());
}

TEST_F(DrawingTest, GuidesComeOutOfTheRulersAndGoBack)
{
    view.setRulersShown(true);
    QWidget* top = nullptr;
    QWidget* left = nullptr;
    for (PatternRuler* ruler : view.findChildren<PatternRuler*>())
        (ruler->width() > ruler->height() ? top : left) = ruler;
    ASSERT_TRUE(top && left);
    const auto dragFrom = [&](QWidget* ruler, QPoint from, QPoint to) {
        QTest::mousePress(ruler, Qt::LeftButton, {}, from - ruler->pos());
        QMouseEvent event(QEvent::MouseMove, to - ruler->pos(), view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QApplication::sendEvent(ruler, &event);
        QTest::mouseRelease(ruler, Qt::LeftButton, {}, to - ruler->pos());
    };
    dragFrom(top, {500, 10}, pixel({400, 150}));
    ASSERT_EQ(view.aids().guides().y.size(), 1U);
    EXPECT_NEAR(view.aids().guides().y[0], 150, 0.6);
    dragFrom(left, {10, 500}, pixel({420, 150}));
    ASSERT_EQ(view.aids().guides().x.size(), 1U);
    EXPECT_NEAR(view.aids().guides().x[0], 420, 0.6);
    keepPicture(view, QStringLiteral("rulers"));
    // The level guide is moved by its mark on the left ruler.
    dragFrom(left, {10, pixel({0, 150}).y()}, pixel({0, 90}));
    ASSERT_EQ(view.aids().guides().y.size(), 1U);
    EXPECT_NEAR(view.aids().guides().y[0], 90, 0.6);
    dragFrom(left, {10, pixel({0, 90}).y()}, {300, 5});
    EXPECT_TRUE(view.aids().guides().y.empty());
    EXPECT_EQ(view.aids().guides().x.size(), 1U);
    EXPECT_EQ(document.history().count(), 1);
}

TEST_F(DrawingTest, APictureIsScaledByTwoPoints)
{
    BackgroundPicture picture;
    picture.image = QImage(200, 100, QImage::Format_RGB32);
    picture.image.fill(Qt::red);
    picture.corner = {400, 300};
    const auto redness = [&](const Vec2& at) {
        const QColor color = view.grab().toImage().pixelColor(pixel(at));
        return color.red() - color.blue();
    };
    EXPECT_LT(redness({500, 250}), 20);
    view.aids().setBackground(picture);
    EXPECT_GT(redness({500, 250}), 100);
    view.setTool(PatternToolKind::BackgroundScale);
    click({400, 300});
    click({500, 300});
    type("30 cm");
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_NEAR(view.aids().background().pixelSize, 3, 0.01);
    EXPECT_LT((view.aids().background().corner - Vec2(400, 300)).norm(), 1);
    view.setTool(PatternToolKind::BackgroundMove);
    drag({500, 250}, {510, 230});
    EXPECT_LT((view.aids().background().corner - Vec2(410, 280)).norm(), 1);
    EXPECT_EQ(document.history().count(), 1) << "no part of the design";
}

TEST(BackgroundPicture, IsReadIntoTheMiddleOrSaysWhyNot)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pattern.png"));
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(Qt::white);
    ASSERT_TRUE(image.save(path));
    Box2 into(Vec2(0, 0));
    into.extend(Vec2(1000, 1000));
    const BackgroundPicture picture = readBackground(path, into, nullptr);
    ASSERT_FALSE(picture.empty());
    EXPECT_LT((picture.box().center() - into.center()).norm(), 1e-9);
    EXPECT_NEAR(picture.box().sizes().x(), 800, 1e-9);
    QString problem;
    EXPECT_TRUE(readBackground(folder.filePath(QStringLiteral("none.png")), into, &problem).empty());
    EXPECT_TRUE(problem.contains(QStringLiteral("none.png")));

    // Reading a pipe would wait for whoever writes into it, for ever.
    const QString pipe = folder.filePath(QStringLiteral("pipe.png"));
    ASSERT_EQ(::mkfifo(pipe.toUtf8().constData(), 0600), 0);
    EXPECT_TRUE(readBackground(pipe, into, &problem).empty());
    EXPECT_TRUE(problem.contains(QStringLiteral("not an ordinary file"))) << problem.toStdString();
}

} // namespace
} // namespace bolster
