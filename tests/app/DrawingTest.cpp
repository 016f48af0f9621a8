// Drawing in the real window.
#include "StartHint.h"
#include "WindowTest.h"

namespace bolster {
namespace {

using DrawingWindowTest = WindowTest;

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

TEST_F(DrawingWindowTest, SnappingStaysAsItWasLeft)
{
    const bool before = window.actions().snapping->isChecked();
    window.actions().snapping->trigger();
    EXPECT_EQ(window.patternView().snapping(), !before);
    MainWindow next;
    EXPECT_EQ(next.actions().snapping->isChecked(), !before);
    window.actions().snapping->trigger();
    EXPECT_EQ(window.patternView().snapping(), before);
}

} // namespace
} // namespace bolster
