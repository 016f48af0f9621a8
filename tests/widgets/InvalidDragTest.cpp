// Drags that would break something: shown as invalid while they last, taken back on release.
#include "CurvePath.h"
#include "Document.h"
#include "Gesture.h"
#include "PatternView.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "TestDesigns.h"
#include "ViewColors.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <random>

namespace bolster {
namespace {

constexpr ElementId handle{7};
constexpr ElementId fancy{8};
constexpr ElementId topSeam{9};

/// The two squares; a handle curve and a fancy seam in the first, a second seam along the tops of both.
Design squaresWithCurves()
{
    Edit edit;
    const auto add = [&](ElementId id, auto element) {
        edit.changes.push_back({id, nullptr, makeElement(element)});
    };
    add(handle, HandleCurve{{"Ridge", firstSquare, BSpline2(1, false, {{20, 30}, {50, 30}, {80, 30}})},
                            BSpline3(1, false, {{0, 0, 0}, {60, 0, 0}}),
                            Match::Length});
    add(fancy, FancySeam{{"Groove", firstSquare, BSpline2(1, false, {{20, 60}, {80, 60}})}, 6, 2});
    add(topSeam, Seam{{firstSquare, 2, 3}, {secondSquare, 2, 3}});
    return twoSquares().with(edit);
}

class InvalidDragTest : public testing::Test {
protected:
    InvalidDragTest()
    {
        document.reset(squaresWithCurves());
        view.resize(900, 700);
        view.show();
        view.navigation().fitAll();
        QObject::connect(&document, &Document::refused, [this](const Message& why) { refused = why.english(); });
    }

    QPoint pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout).toPoint(); }

    void move(const Vec2& to) { moveTo(pixel(to)); }
    void moveTo(QPoint to)
    {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, pressed, {});
        QApplication::sendEvent(&view, &event);
    }
    void press(const Vec2& at)
    {
        move(at);
        pressed = Qt::LeftButton;
        QTest::mousePress(&view, Qt::LeftButton, {}, pixel(at));
    }
    void release(const Vec2& at)
    {
        pressed = Qt::NoButton;
        QTest::mouseRelease(&view, Qt::LeftButton, {}, pixel(at));
    }

    /// Whether the colour for errors is where a line of the pattern is drawn.
    bool red(const Vec2& at)
    {
        const QImage picture = view.grab().toImage();
        const QColor error = ViewColors::of(view.palette()).error;
        const QPoint centre = pixel(at);
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y) {
                const QColor seen = picture.pixelColor(centre + QPoint(x, y));
                if (std::abs(seen.red() - error.red()) + std::abs(seen.green() - error.green()) +
                        std::abs(seen.blue() - error.blue()) <
                    60)
                    return true;
            }
        return false;
    }

    /// Everything is as before, and the reason was said.
    void expectTakenBack(const char* reason)
    {
        EXPECT_FALSE(document.gestureRunning());
        EXPECT_FALSE(document.breakage());
        EXPECT_EQ(document.history().count(), 1);
        EXPECT_TRUE(document.design() == squaresWithCurves());
        EXPECT_NE(refused.find(reason), std::string::npos) << refused;
        EXPECT_FALSE(view.prompt().contains(QStringLiteral("Let go here"))) << view.prompt().toStdString();
    }

    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    Qt::MouseButtons pressed = Qt::NoButton;
    std::string refused;
};

TEST_F(InvalidDragTest, AnOutlineThatCrossesItselfGoesBack)
{
    selection.set({secondSquare});
    press({200, 0});
    move({250, 20});
    EXPECT_FALSE(document.breakage());
    EXPECT_FALSE(red({250, 100}));
    move({320, 60}); // beyond the right side
    ASSERT_TRUE(document.breakage());
    EXPECT_EQ(document.breakage()->elements, std::set<ElementId>{secondSquare});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("The outline of Second would cross or touch itself.")))
        << view.prompt().toStdString();
    EXPECT_TRUE(red({250, 100})) << "its whole outline is";
    EXPECT_FALSE(red({50, 100}));
    keepPicture(view, QStringLiteral("invalid-outline"));
    release({320, 60});
    expectTakenBack("The outline of Second would cross or touch itself.");
    EXPECT_FALSE(red({250, 100}));
}

TEST_F(InvalidDragTest, ADragThatComesBackToSoundGroundIsKept)
{
    selection.set({secondSquare});
    press({200, 0});
    move({320, 60});
    ASSERT_TRUE(document.breakage());
    move({230, 10});
    EXPECT_FALSE(document.breakage());
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("Moved by"))) << view.prompt().toStdString();
    release({230, 10});
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(refused, "");
    const Vec2 moved = document.design().find<Patch>(secondSquare)->outline.points()[0];
    EXPECT_LT((moved - Vec2(30, 10)).norm(), 1);
    document.undo();
    EXPECT_TRUE(document.design() == squaresWithCurves());
}

TEST_F(InvalidDragTest, EscapeTakesAnInvalidDragBackWithoutAWord)
{
    selection.set({secondSquare});
    press({200, 0});
    move({320, 60});
    QTest::keyClick(&view, Qt::Key_Escape);
    release({320, 60});
    expectTakenBack("");
    EXPECT_EQ(refused, "");
}

TEST_F(InvalidDragTest, AHandleCurveStaysInItsPatch)
{
    selection.set({handle});
    press({50, 30});
    move({50, 10});
    EXPECT_FALSE(document.breakage());
    move({50, -30});
    ASSERT_TRUE(document.breakage());
    EXPECT_EQ(document.breakage()->elements, std::set<ElementId>{handle});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("Ridge would not lie inside First any more.")))
        << view.prompt().toStdString();
    EXPECT_TRUE(red({35, 0})) << "the curve, where it crosses the outline";
    keepPicture(view, QStringLiteral("invalid-handle"));
    release({50, -30});
    expectTakenBack("Ridge would not lie inside First any more.");
}

TEST_F(InvalidDragTest, AFancySeamMayEndAtTheOutlineButNotLieOutside)
{
    selection.set({fancy});
    press({80, 60});
    move({130, 60});
    EXPECT_FALSE(document.breakage()) << "it is cut off at the outline";
    release({130, 60});
    EXPECT_EQ(document.history().count(), 2);
    document.jumpTo(0);

    selection.set({fancy});
    press({50, 60}); // the whole curve
    move({50, 140});
    ASSERT_TRUE(document.breakage());
    EXPECT_TRUE(document.breakage()->elements.contains(fancy));
    release({50, 140});
    EXPECT_TRUE(document.design() == squaresWithCurves());
    EXPECT_EQ(refused, "Groove would not lie inside First any more.");
}

TEST_F(InvalidDragTest, AnOutlineDoesNotLoseTheCurvesInIt)
{
    selection.set({firstSquare}, {{firstSquare, 0}, {firstSquare, 1}});
    press({0, 0});
    move({0, 45}); // past the handle, not past the fancy seam
    ASSERT_TRUE(document.breakage());
    EXPECT_EQ(document.breakage()->elements, std::set<ElementId>{handle});
    release({0, 45});
    expectTakenBack("Ridge would not lie inside First any more.");
}

TEST_F(InvalidDragTest, ASewnEdgeKeepsALength)
{
    selection.set({secondSquare});
    press({300, 100});
    move({200, 100}); // onto its neighbour: the top, which is sewn, has no length
    ASSERT_TRUE(document.breakage());
    EXPECT_TRUE(document.breakage()->elements.contains(topSeam));
    release({200, 100});
    expectTakenBack("would have no length");
}

TEST_F(InvalidDragTest, WhatWasBrokenBeforeCanBeMendedStepByStep)
{
    Patch crossed = *document.design().find<Patch>(secondSquare);
    crossed.outline = crossed.outline.withPoint(0, {120, 60});
    document.commit({{}, {{secondSquare, nullptr, makeElement(crossed)}}});
    selection.set({secondSquare});
    press({320, 60});
    move({330, 50});
    EXPECT_FALSE(document.breakage());
    release({330, 50});
    EXPECT_EQ(document.history().count(), 3);
}

TEST_F(InvalidDragTest, ArrowKeysDoNotBreakAnythingEither)
{
    selection.set({secondSquare}, {{secondSquare, 0}});
    for (int i = 0; i < 11; ++i)
        QTest::keyPress(&view, Qt::Key_Right, Qt::ShiftModifier);
    for (int i = 0; i < 6; ++i)
        QTest::keyPress(&view, Qt::Key_Up, Qt::ShiftModifier);
    ASSERT_TRUE(document.breakage());
    QTest::keyRelease(&view, Qt::Key_Up);
    expectTakenBack("The outline of Second would cross or touch itself.");
}

TEST_F(InvalidDragTest, TheEndOfASeamIsDraggedAlongTheOutline)
{
    const auto seamNow = [this] { return *document.design().find<Seam>(squareSeam); };
    selection.set({squareSeam});
    keepPicture(view, QStringLiteral("seam-ends"));
    press({100, 97}); // the upper end of the first side
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("along the outline"))) << view.prompt().toStdString();
    move({104, 82});
    move({104, 57});
    EXPECT_NEAR(seamNow().a.to, 1.6, 0.02);
    EXPECT_TRUE(view.prompt().contains(QStringLiteral(" mm long, the other side 100 mm: ease +40")))
        << view.prompt().toStdString();
    keepPicture(view, QStringLiteral("seam-end-drag"));
    release({104, 57});
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(seamNow().b, (Stretch{secondSquare, 3, 4}));
    document.undo();
    EXPECT_TRUE(document.design() == squaresWithCurves());

    press({100, 97});
    move({100, 40});
    move({100, -20});
    move({60, -60}); // past the other end: it stops there
    EXPECT_NEAR(seamNow().a.to, 1.01, 0.002);
    EXPECT_FALSE(document.breakage());
    QTest::keyClick(&view, Qt::Key_Escape);
    release({60, -60});
    EXPECT_TRUE(document.design() == squaresWithCurves());
}

TEST_F(InvalidDragTest, AnEndThatIsDraggedOverAnotherSeamGoesBack)
{
    selection.set({squareSeam});
    press({100, 97});
    move({100, 105});
    move({60, 105});
    ASSERT_TRUE(document.breakage());
    EXPECT_EQ(document.breakage()->elements, std::set<ElementId>{squareSeam});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("The stretch would overlap the seam of First and Second.")))
        << view.prompt().toStdString();
    EXPECT_TRUE(red({99, 50}));
    keepPicture(view, QStringLiteral("invalid-seam-end"));
    release({60, 105});
    expectTakenBack("The stretch would overlap the seam of First and Second.");
}

TEST_F(InvalidDragTest, EndsOfStretchesSnap)
{
    view.aids().setSnapping(true);
    Seam shorter = *document.design().find<Seam>(topSeam);
    shorter.a.from = 2.5;
    document.commit({{}, {{topSeam, nullptr, makeElement(shorter)}}});
    const auto to = [this] { return document.design().find<Seam>(squareSeam)->a.to; };
    selection.set({squareSeam});
    press({100, 97});
    move({95, 105});
    move({52, 104});
    EXPECT_DOUBLE_EQ(to(), 2.5) << "the end of the other seam";
    move({97.5, 105});
    EXPECT_DOUBLE_EQ(to(), 2) << "the corner";
    release({97.5, 105});
    EXPECT_EQ(document.history().count(), 2) << "as it was";

    selection.set({topSeam});
    press({3, 100});
    move({5, 90});
    move({-5, 50}); // as long as the top of the other square
    EXPECT_NEAR(document.design().find<Seam>(topSeam)->a.to, 3.5, 1e-9);
    EXPECT_TRUE(view.prompt().contains(QStringLiteral("100 mm long, the other side 100 mm")))
        << view.prompt().toStdString();
    release({-5, 50});
    EXPECT_EQ(document.history().count(), 3);
}

TEST_F(InvalidDragTest, TheEndOfAFixationIsDraggedToo)
{
    const auto stretch = [this] { return document.design().find<FixationSeam>(squareFixation)->stretch; };
    selection.set({squareFixation});
    press({300, 3});
    move({305, 30});
    EXPECT_TRUE(view.prompt().contains(QStringLiteral(" mm long"))) << view.prompt().toStdString();
    release({305, 30});
    EXPECT_NEAR(stretch().from, 1.27, 0.02);
    EXPECT_EQ(document.history().count(), 2);
    document.undo();
    EXPECT_TRUE(document.design() == squaresWithCurves());
}

TEST_F(InvalidDragTest, HiddenCurvesAreNeitherDrawnNorHit)
{
    const auto hits = [this](const Vec2& at) { return view.hit(QPointF(pixel(at))).element(); };
    ASSERT_EQ(hits({40, 30}), handle);
    ASSERT_EQ(hits({40, 60}), fancy);
    const QImage shown = view.grab().toImage();
    PatternLayers layers = view.shown().layers();
    layers.handles = false;
    view.shown().setLayers(layers);
    EXPECT_EQ(hits({40, 30}), firstSquare);
    EXPECT_EQ(hits({40, 60}), fancy);
    const QImage without = view.grab().toImage();
    EXPECT_NE(shown.pixelColor(pixel({40, 30})), without.pixelColor(pixel({40, 30})));
    EXPECT_EQ(shown.pixelColor(pixel({40, 60})), without.pixelColor(pixel({40, 60})));
    layers.fancySeams = false;
    view.shown().setLayers(layers);
    EXPECT_EQ(hits({40, 60}), firstSquare);
    selection.set({handle});
    EXPECT_EQ(hits({20, 30}), firstSquare) << "nor are its points";
}

TEST_F(InvalidDragTest, RandomDragsLeaveADesignThatEqualsItsReplay)
{
    std::mt19937 random(7);
    const auto pick = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const auto somewhere = [&] { return QPoint(pick(view.width()), pick(view.height())); };
    const ElementId all[] = {firstSquare, secondSquare, squareSeam, topSeam, handle, fancy, squareFixation};
    int invalid = 0, kept = 0;
    for (int i = 0; i < 300; ++i) {
        const ElementId id = all[pick(7)];
        selection.set({id});
        QPoint from = somewhere();
        PatternScene scene;
        scene.reset(document.design());
        const PatternPatch* patch = scene.patch(id);
        const auto line = scene.lines().find(id);
        if (patch)
            from = pixel(patch->points[static_cast<std::size_t>(pick(static_cast<int>(patch->points.size())))]);
        else if (line != scene.lines().end())
            from = pixel(line->second.points.front());
        else if (const auto stretch = scene.stretches().find(id); stretch != scene.stretches().end())
            from =
                view.navigation().transform().toPixels(toVec(stretch->second.path.pointAtPercent(0.03))).toPoint();
        moveTo(from);
        pressed = Qt::LeftButton;
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        QPoint at = from;
        for (int k = pick(4); k >= 0; --k)
            moveTo(at = pick(3) == 0 ? somewhere() : from + QPoint(pick(80) - 40, pick(80) - 40));
        const bool breaks = document.breakage().has_value();
        invalid += breaks;
        const int way = pick(5);
        if (way == 0)
            QTest::keyClick(&view, Qt::Key_Escape);
        else if (way == 1)
            document.undo();
        const int count = document.history().count();
        pressed = Qt::NoButton;
        QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
        kept += document.history().count() > count;
        EXPECT_FALSE(document.gestureRunning());
        EXPECT_FALSE(document.breakage());
        if (pick(6) == 0)
            document.undo();
        Design replay = squaresWithCurves();
        for (const NodeId node : document.history().pathTo(document.history().current()))
            replay = replay.with(document.history().node(node).edit);
        ASSERT_TRUE(document.design() == replay) << i;
        ASSERT_TRUE(document.committed() == replay) << i;
    }
    EXPECT_GT(invalid, 10);
    EXPECT_GT(kept, 20);
}

} // namespace
} // namespace bolster
