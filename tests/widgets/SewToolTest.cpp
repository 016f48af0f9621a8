// Sewing by pointer and keys.
#include "Document.h"
#include "PatternView.h"
#include "Picture.h"
#include "ProblemSet.h"
#include "SeamColors.h"
#include "Selection.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace bolster {
namespace {

constexpr ElementId leather{1}, wide{2}, left{3}, right{4};

/// A piece of 200 x 100 mm above two of 100 x 80 mm, 60 mm apart from it.
Design threePieces()
{
    const auto rectangle = [](const char* name, const Vec2& position, double width, double height) {
        Patch patch;
        patch.name = name;
        patch.fabric = leather;
        patch.position = position;
        patch.outline = BSpline2(1, true, {{0, 0}, {width, 0}, {width, height}, {0, height}});
        return patch;
    };
    Edit edit;
    edit.changes = {{leather, nullptr, makeElement(Fabric{"Leather"})},
                    {wide, nullptr, makeElement(rectangle("Wide", {0, 0}, 200, 100))},
                    {left, nullptr, makeElement(rectangle("Left", {-20, -140}, 100, 80))},
                    {right, nullptr, makeElement(rectangle("Right", {120, -140}, 100, 80))}};
    return Design().with(edit);
}

class SewToolTest : public testing::Test {
protected:
    SewToolTest()
    {
        document.reset(threePieces());
        view.resize(900, 700);
        view.show();
        view.navigation().fitAll();
        view.setTool(PatternToolKind::Sew);
        view.setFocus();
        (void)QTest::qWaitForWindowActive(&view);
    }

    QPoint pixel(const Vec2& layout) const { return view.navigation().transform().toPixels(layout).toPoint(); }

    void move(const Vec2& to, Qt::KeyboardModifiers modifiers = {})
    {
        QMouseEvent event(QEvent::MouseMove, pixel(to), view.mapToGlobal(pixel(to)), Qt::NoButton, pressed,
                          modifiers);
        QApplication::sendEvent(&view, &event);
    }

    void click(const Vec2& at, Qt::KeyboardModifiers modifiers = {})
    {
        move(at, modifiers);
        QTest::mouseClick(&view, Qt::LeftButton, modifiers, pixel(at));
    }

    void drag(const std::vector<Vec2>& way)
    {
        move(way.front());
        QTest::mousePress(&view, Qt::LeftButton, {}, pixel(way.front()));
        pressed = Qt::LeftButton;
        for (const Vec2& at : way)
            move(at);
        pressed = Qt::NoButton;
        QTest::mouseRelease(&view, Qt::LeftButton, {}, pixel(way.back()));
    }

    void key(Qt::Key key) { QTest::keyClick(&view, key); }

    std::vector<Seam> seams() const
    {
        std::vector<Seam> all;
        document.design().each<Seam>([&](ElementId, const Seam& seam) { all.push_back(seam); });
        return all;
    }

    /// Of a stretch along the lower edge of the wide piece.
    void expectOnLowerEdge(const Stretch& stretch, double from, double to)
    {
        EXPECT_EQ(stretch.patch, wide);
        EXPECT_NEAR(200 * stretch.from, from, 1.5);
        EXPECT_NEAR(200 * stretch.to, to, 1.5);
    }

    const Vec2 lowerEdge{150, 0}, upperEdge{60, 100}, leftTop{20, -60}, rightTop{170, -60}, nowhere{-15, -30};
    Document document;
    Selection selection;
    ProblemSet problems;
    PatternView view{document, selection, problems};
    Qt::MouseButtons pressed = Qt::NoButton;
};

TEST_F(SewToolTest, TwoClicksSewTwoEdges)
{
    click(lowerEdge);
    EXPECT_TRUE(seams().empty());
    move(leftTop);
    keepPicture(view, "sew-preview");
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_EQ(seams()[0], (Seam{{wide, 0, 1}, {left, 2, 3}, true}));
    EXPECT_EQ(document.history().count(), 2);
    EXPECT_EQ(view.tool(), PatternToolKind::Sew) << "there is more to sew";
    EXPECT_TRUE(document.design().find<Seam>(*selection.elements().begin()));
    document.undo();
    EXPECT_TRUE(document.design() == threePieces());
}

TEST_F(SewToolTest, FlipsBeforeItSews)
{
    click(lowerEdge);
    key(Qt::Key_F);
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_FALSE(seams()[0].reversed);
    click(rightTop);
    click(upperEdge);
    EXPECT_TRUE(seams()[1].reversed) << "only that one was flipped";
}

TEST_F(SewToolTest, AButtonBesideTheFirstSideFlips)
{
    click(lowerEdge);
    const QPoint button = pixel({100, 0}) - QPoint(0, 26);
    QMouseEvent hover(QEvent::MouseMove, button, view.mapToGlobal(button), Qt::NoButton, pressed, {});
    QApplication::sendEvent(&view, &hover);
    EXPECT_TRUE(view.prompt().contains("other way round"));
    QTest::mouseClick(&view, Qt::LeftButton, {}, button);
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_FALSE(seams()[0].reversed);
}

TEST_F(SewToolTest, ADragAlongTheOutlineTakesAPart)
{
    drag({{50, 0}, {80, 2}, {120, -1}});
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    expectOnLowerEdge(seams()[0].a, 50, 120);
    click({20, 0}); // what is left of the edge beside it
    click(rightTop);
    expectOnLowerEdge(seams()[1].a, 0, 50);
    EXPECT_EQ(seams()[1].a.to, seams()[0].a.from);
}

TEST_F(SewToolTest, ADragGoesRoundCornersAndSnapsToThem)
{
    drag({{60, 0}, {20, 0}, {2, 0}, {0, 40}, {0, 80}, {0, 98}});
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_EQ(seams()[0].a.from, 3) << "the upper left corner";
    EXPECT_NEAR(200 * seams()[0].a.to, 60, 1.5);
}

TEST_F(SewToolTest, ShiftTakesTwoPoints)
{
    click({120, 0}, Qt::ShiftModifier);
    EXPECT_TRUE(view.prompt().contains("stretch ends"));
    click({40, 0});
    click(leftTop);
    ASSERT_EQ(seams().size(), 1U);
    expectOnLowerEdge(seams()[0].a, 40, 120);
}

TEST_F(SewToolTest, EdgesThatLieOnEachOtherAreSewn)
{
    Patch below = *document.design().find<Patch>(left);
    below.position = {50, -80}; // touches the wide one
    document.commit({{}, {{left, nullptr, makeElement(below)}}});
    click({100, 1});
    click({100, 1});
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_EQ(seams()[0], (Seam{{wide, 0, 1}, {left, 2, 3}, true}));
}

TEST_F(SewToolTest, BothSidesGetTheSameLetter)
{
    click(lowerEdge);
    click(leftTop);
    view.setTool(PatternToolKind::Select);
    selection.clear();
    const QColor color = seamColors(document.design(), false).at(ElementId{5});
    const auto colored = [&](const Vec2& at, bool letters) {
        PatternLayers layers = view.shown().layers();
        layers.labels = letters;
        view.shown().setLayers(layers);
        const QImage picture = view.grab().toImage();
        int count = 0;
        for (int y = -12; y <= 12; ++y)
            for (int x = -40; x <= 40; ++x)
                count += picture.pixelColor(pixel(at) + QPoint(x, y)) == color;
        return count;
    };
    for (const Vec2& inside : {Vec2(60, 6), Vec2(10, -66)}) // where the arrows are
        EXPECT_GT(colored(inside, true), colored(inside, false) + 30);
    keepPicture(view, "sew-letters");
}

TEST_F(SewToolTest, SeveralInARow)
{
    click(lowerEdge);
    click(leftTop, Qt::ControlModifier);
    EXPECT_TRUE(seams().empty());
    click(rightTop, Qt::ControlModifier);
    move(nowhere);
    keepPicture(view, "sew-row");
    EXPECT_TRUE(seams().empty());
    key(Qt::Key_Return);
    ASSERT_EQ(seams().size(), 2U);
    EXPECT_EQ(document.history().count(), 2) << "one edit";
    expectOnLowerEdge(seams()[0].a, 0, 100);
    EXPECT_EQ(seams()[0].b, (Stretch{left, 2, 3}));
    expectOnLowerEdge(seams()[1].a, 100, 200);
    EXPECT_EQ(seams()[1].b, (Stretch{right, 2, 3}));
}

TEST_F(SewToolTest, MoreByKey)
{
    click(lowerEdge);
    key(Qt::Key_M);
    click(rightTop);
    click(leftTop);
    EXPECT_TRUE(seams().empty());
    key(Qt::Key_Backspace);
    click(leftTop);
    key(Qt::Key_Enter);
    ASSERT_EQ(seams().size(), 2U);
    EXPECT_EQ(seams()[0].b.patch, left) << "the nearer one is at the nearer end";
}

TEST_F(SewToolTest, RefusesWhatIsSewnAndSaysWhy)
{
    click(lowerEdge);
    click(leftTop);
    QSignalSpy failures(&view, &PatternView::failed);
    move(lowerEdge);
    EXPECT_TRUE(view.prompt().contains("Wide is already sewn to Left"));
    EXPECT_EQ(selection.hovered(), ElementId{5}) << "shows with what";
    click(lowerEdge);
    ASSERT_EQ(failures.count(), 1);
    EXPECT_TRUE(failures[0][0].toString().contains("already sewn"));
    drag({{0, 50}, {0, 10}, {10, 0}, {30, 0}});
    EXPECT_EQ(failures.count(), 2) << "a part of it is sewn";
    click(rightTop);
    click(leftTop);
    EXPECT_EQ(failures.count(), 3);
    EXPECT_EQ(seams().size(), 1U);
}

TEST_F(SewToolTest, AnEdgeIsNotSewnToItself)
{
    click(lowerEdge);
    QSignalSpy failures(&view, &PatternView::failed);
    click({60, 0});
    EXPECT_EQ(failures.count(), 1);
    drag({{50, 0}, {80, 0}, {120, 0}});
    EXPECT_EQ(failures.count(), 2);
    click(upperEdge);
    EXPECT_EQ(seams().size(), 1U) << "but a tube has its edges on one piece";
}

TEST_F(SewToolTest, EscapeAndBackspaceGoBackOneStep)
{
    click(lowerEdge);
    key(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), PatternToolKind::Sew);
    click(leftTop);
    EXPECT_TRUE(seams().empty()) << "that is the first side now";
    key(Qt::Key_Backspace);
    click({50, 0}, Qt::ShiftModifier);
    key(Qt::Key_Escape);
    click(rightTop);
    EXPECT_TRUE(seams().empty());
    key(Qt::Key_Escape);
    key(Qt::Key_Escape);
    QCoreApplication::processEvents();
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    EXPECT_TRUE(document.design() == threePieces());
}

TEST_F(SewToolTest, ForgetsWhatIsGone)
{
    click(lowerEdge);
    Edit removal{{}, {{wide, document.design().element(wide), nullptr}}};
    document.commit(removal);
    click(leftTop);
    click(rightTop);
    ASSERT_EQ(seams().size(), 1U);
    EXPECT_EQ(seams()[0], (Seam{{left, 2, 3}, {right, 2, 3}, true}));
}

} // namespace
} // namespace bolster
