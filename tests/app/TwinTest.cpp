// Mirror twins from the menu.
#include "Twins.h"
#include "WindowTest.h"

namespace bolster {
namespace {

class TwinTest : public WindowTest {
protected:
    ElementId anyPatch()
    {
        ElementId found{};
        window.document().design().each<Patch>([&](ElementId id, const Patch&) { found = id; });
        return found;
    }
};

TEST_F(TwinTest, MakesReleasesAndUnlinksTwins)
{
    ASSERT_TRUE(open(sample("pillow")));
    Actions& actions = window.actions();
    EXPECT_FALSE(actions.makeTwin->isEnabled());
    const Design before = window.document().design();
    const ElementId patch = anyPatch();
    window.selection().set({patch});
    ASSERT_TRUE(actions.makeTwin->isEnabled());
    actions.makeTwin->trigger();
    const ElementId twin = twinOf(window.document().design(), patch);
    ASSERT_NE(twin, settingsId);
    EXPECT_EQ(window.document().history().count(), 2) << "one step";
    EXPECT_TRUE(window.selection().contains(twin));
    EXPECT_FALSE(actions.makeTwin->isEnabled());
    EXPECT_FALSE(actions.releasePoints->isEnabled());

    window.selection().set({patch}, {{patch, 0}});
    ASSERT_TRUE(actions.releasePoints->isEnabled());
    EXPECT_FALSE(actions.relinkPoints->isEnabled());
    actions.releasePoints->trigger();
    EXPECT_EQ(releasedPoints(window.document().design(), twin), std::vector{0});
    ASSERT_TRUE(actions.relinkPoints->isEnabled());
    actions.relinkPoints->trigger();
    EXPECT_TRUE(releasedPoints(window.document().design(), twin).empty());

    actions.unlinkTwins->trigger();
    EXPECT_EQ(twinOf(window.document().design(), patch), settingsId);
    window.selection().set({patch, twin});
    ASSERT_TRUE(actions.linkTwins->isEnabled());
    actions.linkTwins->trigger();
    EXPECT_EQ(twinOf(window.document().design(), patch), twin);
    for (int i = 0; i < 5; ++i)
        actions.undo->trigger();
    EXPECT_TRUE(window.document().design() == before);
}

} // namespace
} // namespace bolster
