// A designer cuts, drags and rotates darts in the real window.
#include "WindowTest.h"

#include "DartEdits.h"
#include "Selection.h"

#include <QStatusBar>

namespace bolster {
namespace {

class DartsTest : public WindowTest {
protected:
    void SetUp() override
    {
        WindowTest::SetUp();
        ASSERT_TRUE(open(sample("box-cushion")));
        design().each<Patch>([&](ElementId id, const Patch& patch) {
            if (patch.name == "Top")
                top = id;
        });
        window.selection().set({top});
        window.patternView().navigation().fitSelection();
        window.selection().clear();
    }

    const Design& design() { return window.document().design(); }
    const Patch& patch() { return *design().find<Patch>(top); }

    /// Of the outline of the top, which is 500 mm wide and deep.
    QPoint at(double x, double y) { return patternPixel(toLayout(patch(), {x, y})); }

    void click(QPoint pixel)
    {
        move(window.patternView(), pixel, Qt::NoButton);
        press(window.patternView(), pixel);
        release(window.patternView(), pixel);
    }

    void drag(QPoint from, QPoint to)
    {
        move(window.patternView(), from, Qt::NoButton);
        press(window.patternView(), from);
        move(window.patternView(), (from + to) / 2, Qt::LeftButton);
        move(window.patternView(), to, Qt::LeftButton);
        release(window.patternView(), to);
    }

    void key(int code) { QTest::keyClick(&window.patternView(), static_cast<Qt::Key>(code)); }
    void type(const char* text)
    {
        QTest::keyClicks(&window.patternView(), QString::fromUtf8(text));
        key(Qt::Key_Return);
    }

    std::vector<std::pair<ElementId, edits::DartShape>> darts()
    {
        std::vector<std::pair<ElementId, edits::DartShape>> found;
        design().each<Seam>([&](ElementId id, const Seam&) {
            if (const auto dart = edits::dartOf(design(), id))
                found.emplace_back(id, *dart);
        });
        return found;
    }

    /// 20 mm wide in the middle of the lower edge, 100 mm deep.
    void cutOne()
    {
        window.command("tool.dart")->trigger();
        click(at(240, 0));
        move(window.patternView(), at(300, 0), Qt::NoButton);
        type("20");
        move(window.patternView(), at(250, 60), Qt::NoButton);
        type("100");
        ASSERT_EQ(darts().size(), 1u);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    }

    ElementId top{};
};

TEST_F(DartsTest, AreCutByThreeClicks)
{
    const Design before = design();
    window.patternView().setFocus();
    QTest::keyClick(&window.patternView(), Qt::Key_D, Qt::ShiftModifier);
    ASSERT_EQ(window.patternView().tool(), PatternToolKind::Dart);
    click(at(230, 0));
    click(at(262, 0));
    click(at(248, 90));
    ASSERT_EQ(darts().size(), 1u);
    const auto [id, dart] = darts().front();
    EXPECT_EQ(dart.patch, top);
    EXPECT_TRUE(window.selection().contains(id)) << "to go on with it";
    const BSpline2& outline = patch().outline;
    EXPECT_NEAR((dart.tip - outline.at(dart.from)).norm(), (dart.tip - outline.at(dart.to)).norm(), 1e-6)
        << "near the axis the legs become equally long";
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    window.command("edit.undo")->trigger();
    EXPECT_EQ(design(), before);
}

TEST_F(DartsTest, HaveTheTypedWidthAndDepth)
{
    cutOne();
    const auto [id, dart] = darts().front();
    const BSpline2& outline = patch().outline;
    const Vec2 a = outline.at(dart.from), b = outline.at(dart.to);
    EXPECT_NEAR((b - a).norm(), 20, 1e-6);
    EXPECT_NEAR(((a + b) / 2 - dart.tip).norm(), 100, 1e-6);
}

TEST_F(DartsTest, EscapeTakesBackAClickAndThenTheTool)
{
    const Design before = design();
    window.command("tool.dart")->trigger();
    click(at(230, 0));
    click(at(262, 0));
    key(Qt::Key_Escape);
    click(at(290, 0)); // the mouth's end again
    click(at(260, -80));
    EXPECT_EQ(design(), before) << "the tip lies outside";
    EXPECT_EQ(window.patternView().tool(), PatternToolKind::Dart) << "and can be clicked again";
    for (int step = 0; step < 3; ++step)
        key(Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.patternView().tool() == PatternToolKind::Select; }));
    EXPECT_EQ(design(), before);
}

} // namespace
} // namespace bolster
