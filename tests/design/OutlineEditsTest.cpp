// Adding patches from drawn outlines.
#include "OutlineEdits.h"
#include "DesignCheck.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

BSpline2 square(const Vec2& corner, double size)
{
    return BSpline2(1, true, {corner, corner + Vec2(size, 0), corner + Vec2(size, size), corner + Vec2(0, size)});
}

TEST(AddPatch, MakesAFabricWhenThereIsNone)
{
    const Design empty;
    const Edit edit = edits::addPatch(empty, square({100, 50}, 200), "Seat");
    ASSERT_EQ(edit.changes.size(), 2u);
    EXPECT_EQ(edit.verb.english(), "Add patch Seat");
    const Design design = empty.with(edit);
    const Patch* patch = design.find<Patch>(edit.changes.back().id);
    ASSERT_TRUE(patch);
    EXPECT_TRUE(design.find<Fabric>(patch->fabric));
    EXPECT_FALSE(hasErrors(checkDesign(design)));
    for (int i = 0; i < 4; ++i)
        EXPECT_LT((toLayout(*patch, patch->outline.at(i)) - square({100, 50}, 200).at(i)).norm(), 1e-9);
    EXPECT_EQ(design.with(edit.inverse()), empty);

    const Edit second = edits::addPatch(design, square({400, 0}, 10), "Side", ElementId{77});
    ASSERT_EQ(second.changes.size(), 1u);
    EXPECT_EQ(std::get<Patch>(*second.changes.back().after).fabric, patch->fabric);
}

TEST(AddPatch, RunsCounterClockwise)
{
    const BSpline2 clockwise = square({0, 0}, 100).reversed();
    ASSERT_LT(clockwise.signedArea(), 0);
    const Edit edit = edits::addPatch(Design(), clockwise, "Seat");
    EXPECT_NEAR(std::get<Patch>(*edit.changes.back().after).outline.signedArea(), 1e4, 1e-6);
}

TEST(AddPatch, RefusesWhatIsNoOutline)
{
    EXPECT_TRUE(edits::addPatch(Design(), BSpline2(), "Nothing").empty());
    EXPECT_TRUE(edits::addPatch(Design(), BSpline2(1, false, {{0, 0}, {1, 0}, {0, 1}}), "Open").empty());
    const BSpline2 crossed(1, true, {{0, 0}, {100, 100}, {100, 0}, {0, 100}});
    EXPECT_TRUE(edits::addPatch(Design(), crossed, "Bow").empty());
}

} // namespace
} // namespace bolster
