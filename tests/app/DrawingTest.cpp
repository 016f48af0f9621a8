// Drawing in the real window.
#include "NextStep.h"
#include "OutlineEdits.h"
#include "PatternGrid.h"
#include "PatternRulers.h"
#include "StartHint.h"
#include "WindowTest.h"

namespace bolster {
namespace {

using DrawingWindowTest = WindowTest;

TEST_F(DrawingWindowTest, GuidesAreRemovedWhereThereAreSome)
{
    QAction* remove = window.command("draw.remove-guides");
    EXPECT_FALSE(remove->isEnabled());
    window.patternView().aids().setGuides({{100}, {}});
    EXPECT_TRUE(remove->isEnabled());
    remove->trigger();
    EXPECT_TRUE(window.patternView().aids().guides().x.empty());
    EXPECT_FALSE(remove->isEnabled());
}

TEST_F(DrawingWindowTest, AnEmptyDesignLetsOneDraw)
{
    const auto* hint = window.findChild<StartHint*>();
    ASSERT_TRUE(hint);
    EXPECT_TRUE(hint->isVisible());
    window.patternView().setTool(PatternToolKind::Rectangle);
    EXPECT_FALSE(hint->isVisible()) << "it would take the pointer";
    PatternView& view = window.patternView();
    const QPoint from(200, 200), to(400, 350);
    move(view, from, Qt::NoButton);
    press(view, from);
    move(view, to, Qt::LeftButton);
    release(view, to);
    QCoreApplication::processEvents();
    EXPECT_EQ(view.tool(), PatternToolKind::Select);
    int patches = 0;
    window.document().design().each<Patch>([&](ElementId, const Patch&) { ++patches; });
    EXPECT_EQ(patches, 1);
    EXPECT_FALSE(hint->isVisible());
}

TEST_F(DrawingWindowTest, HintsCoverNeitherRulersNorTheScaleBar)
{
    PatternView& view = window.patternView();
    const auto expectFree = [&](const QWidget& hint) {
        ASSERT_TRUE(hint.isVisible());
        EXPECT_FALSE(scaleBarPlace(view.navigation().transform(), view.size()).intersects(hint.geometry()));
        for (const QWidget* ruler : view.findChildren<PatternRuler*>())
            EXPECT_FALSE(ruler->isVisible() && ruler->geometry().intersects(hint.geometry()));
    };
    window.command("window.reset-layout")->trigger();
    auto& hint = *window.findChild<StartHint*>();
    auto& next = *window.findChild<NextStep*>();
    for (const int width : {1400, 900}) {
        window.resize(width, 640);
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.width() == width; }));
        for (const bool rulers : {true, false}) {
            window.command("draw.rulers")->setChecked(rulers);
            expectFree(hint);
        }
    }
    const BSpline2 outline(1, true, {{0, 0}, {300, 0}, {300, 200}, {0, 200}});
    window.document().commit(edits::addPatch(window.document().design(), outline, "Seat"));
    window.patternView().navigation().fitAll();
    for (const bool rulers : {true, false}) {
        window.command("draw.rulers")->setChecked(rulers);
        expectFree(next);
    }
    window.resize(1400, 640);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.width() == 1400; }));
    expectFree(next);
}

TEST_F(DrawingWindowTest, WhatIsLargerThanTheViewIsBroughtIntoIt)
{
    PatternView& view = window.patternView();
    view.setTool(PatternToolKind::Rectangle);
    move(view, {300, 200}, Qt::NoButton);
    press(view, {300, 200});
    release(view, {300, 200});
    QTest::keyClicks(&view, QStringLiteral("3 m x 2 m"));
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.tool() == PatternToolKind::Select; }));
    const Box2 seen = view.navigation().transform().visible(view.size());
    EXPECT_GT(seen.sizes().x(), 3000);
    EXPECT_GT(seen.sizes().y(), 2000);
}

TEST_F(DrawingWindowTest, SnappingStaysAsItWasLeft)
{
    const bool before = window.command("draw.snapping")->isChecked();
    window.command("draw.snapping")->trigger();
    EXPECT_EQ(window.patternView().aids().snapping(), !before);
    MainWindow next;
    EXPECT_EQ(next.command("draw.snapping")->isChecked(), !before);
    window.command("draw.snapping")->trigger();
    EXPECT_EQ(window.patternView().aids().snapping(), before);
}

} // namespace
} // namespace bolster
