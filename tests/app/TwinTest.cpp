// Mirror twins from the menu.
#include "TwinEdits.h"
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
    EXPECT_FALSE(window.command("twin.make")->isEnabled());
    const Design before = window.document().design();
    const ElementId patch = anyPatch();
    window.selection().set({patch});
    ASSERT_TRUE(window.command("twin.make")->isEnabled());
    window.command("twin.make")->trigger();
    const ElementId twin = twinOf(window.document().design(), patch);
    ASSERT_NE(twin, noElement);
    EXPECT_EQ(window.document().history().count(), 2) << "one step";
    EXPECT_TRUE(window.selection().contains(twin));
    EXPECT_FALSE(window.command("twin.make")->isEnabled());
    EXPECT_FALSE(window.command("twin.release-points")->isEnabled());

    window.selection().set({patch}, {{patch, 0}});
    ASSERT_TRUE(window.command("twin.release-points")->isEnabled());
    EXPECT_FALSE(window.command("twin.relink-points")->isEnabled());
    window.command("twin.release-points")->trigger();
    EXPECT_EQ(releasedPoints(window.document().design(), twin), std::vector{0});
    ASSERT_TRUE(window.command("twin.relink-points")->isEnabled());
    window.command("twin.relink-points")->trigger();
    EXPECT_TRUE(releasedPoints(window.document().design(), twin).empty());

    window.command("twin.unlink")->trigger();
    EXPECT_EQ(twinOf(window.document().design(), patch), noElement);
    const auto nameOf = [&](ElementId id) { return window.document().design().find<Patch>(id)->name; };
    window.selection().set({patch});
    window.command("twin.make")->trigger();
    EXPECT_NE(nameOf(twinOf(window.document().design(), patch)), nameOf(twin)) << "that name is taken";
    window.command("edit.undo")->trigger();
    window.selection().set({patch, twin});
    ASSERT_TRUE(window.command("twin.link")->isEnabled());
    window.command("twin.link")->trigger();
    EXPECT_EQ(twinOf(window.document().design(), patch), twin);
    for (int i = 0; i < 5; ++i)
        window.command("edit.undo")->trigger();
    EXPECT_TRUE(window.document().design() == before);
}

TEST_F(TwinTest, SeamsFollowAreReleasedAndRelinked)
{
    ASSERT_TRUE(open(sample("box-cushion")));
    Document& document = window.document();
    std::vector<ElementId> patches;
    document.design().each<Patch>([&](ElementId id, const Patch&) { patches.push_back(id); });
    window.selection().set({patches.begin(), patches.end()});
    window.command("twin.make")->trigger();
    ElementId seam{};
    document.design().each<Seam>([&](ElementId id, const Seam&) {
        if (seam == noElement)
            seam = id;
    });
    const ElementId mirrored = edits::mirroredElement(document.design(), seam);
    ASSERT_TRUE(document.design().find<Seam>(mirrored));
    const auto continuity = [&](ElementId id) { return document.design().find<Seam>(id)->continuity; };

    window.selection().set({seam});
    window.command("seam.continuity-g1")->trigger();
    EXPECT_EQ(continuity(mirrored), Continuity::G1);
    window.command("edit.undo")->trigger();
    EXPECT_EQ(continuity(seam), Continuity::C0) << "one step for both";
    EXPECT_EQ(continuity(mirrored), Continuity::C0);

    ASSERT_TRUE(window.command("twin.release-points")->isEnabled());
    window.command("twin.release-points")->trigger();
    EXPECT_TRUE(edits::sewingReleased(document.design(), seam));
    window.command("seam.continuity-g1")->trigger();
    EXPECT_EQ(continuity(mirrored), Continuity::C0);
    ASSERT_TRUE(window.command("twin.relink-points")->isEnabled());
    window.command("twin.relink-points")->trigger();
    EXPECT_EQ(continuity(seam), Continuity::C0);
    EXPECT_FALSE(window.command("twin.relink-points")->isEnabled());
}

} // namespace
} // namespace bolster
