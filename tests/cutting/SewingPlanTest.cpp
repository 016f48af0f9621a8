// What the sewing room is told.
#include "SewingPlan.h"

#include "Panels.h"

#include <gtest/gtest.h>

namespace bolster {

namespace {

using namespace test;

} // namespace

TEST(SewingPlan, SaysLengthsAllowancesAndMaterials)
{
    Design design = twoPanels();
    Seam seam = *design.find<Seam>(between);
    seam.trim.stitch = SeamTrim::Stitch::Twin;
    seam.trim.thread = "#112233";
    seam.trim.pipingRadius = 3;
    design = with(design, between, seam);
    Patch pair = *design.find<Patch>(left);
    pair.cutting.pair = true;
    pair.cutting.quantity = 2;
    design = with(design, left, pair);
    CutOptions options;
    options.allowance = 10;
    const SewingPlan plan = sewingPlan(design, options);
    ASSERT_EQ(plan.seams.size(), 1u);
    EXPECT_NEAR(plan.seams[0].lengthA, 100, 1e-9);
    EXPECT_NEAR(plan.seams[0].ease, 0, 1e-9);
    EXPECT_EQ(plan.seams[0].allowanceA, 10);
    EXPECT_FALSE(plan.seams[0].closes);
    ASSERT_EQ(plan.fabrics.size(), 1u);
    EXPECT_NEAR(plan.fabrics[0].area, 5 * 220 * 120, 1e-6) << "four of one, one of the other";
    EXPECT_NEAR(plan.thread.at(""), 300, 1e-9);
    EXPECT_NEAR(plan.thread.at("#112233"), 600, 1e-9) << "two rows";
    EXPECT_NEAR(plan.piping, 100, 1e-9);
}

TEST(SewingPlan, ClosesRingsWhenTheyHangTogetherAndTheCoverLast)
{
    // Three panels in a ring: left to right, right to third, third to left.
    Design design = twoPanels();
    const ElementId third{10};
    Patch patch = *design.find<Patch>(left);
    patch.name = "Third";
    design = with(design, third, patch);
    design = with(design, ElementId(11), Seam{{right, 1, 2}, {third, 3, 4}});
    design = with(design, ElementId(12), Seam{{third, 1, 2}, {left, 3, 4}});
    const SewingPlan plan = sewingPlan(design, {});
    ASSERT_EQ(plan.seams.size(), 3u);
    EXPECT_FALSE(plan.seams[0].closes);
    EXPECT_FALSE(plan.seams[1].closes);
    EXPECT_TRUE(plan.seams[2].closes);
}

} // namespace bolster
