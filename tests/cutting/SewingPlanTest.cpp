// What the sewing room is told.
#include "SewingPlan.h"

#include "Panels.h"
#include "SewingOrder.h"

#include <gtest/gtest.h>

#include <cmath>

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
    seam.zip = true;
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
    EXPECT_NEAR(plan.zips, 100, 1e-9);
}

TEST(CutPattern, TakesNoWidthThatNoFieldTakes)
{
    Design design = twoPanels();
    Patch patch = *design.find<Patch>(left);
    for (const double width : {1e9, -5.0, std::nan("")}) {
        patch.allowance = CutAllowance{width};
        const CutPattern pattern = cutPattern(with(design, left, patch), {});
        ASSERT_EQ(pattern.pieces.size(), 2u);
        EXPECT_LE(pattern.pieces[0].box().sizes().maxCoeff(), 600) << width;
    }
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

namespace {

std::vector<ElementId> orderOf(const Design& design)
{
    std::vector<ElementId> order;
    for (const SewingStep& step : sewingOrder(design))
        order.push_back(step.seam);
    return order;
}

/// Three panels in a ring, and two beside it that are sewn to each other.
Design ringAndPair()
{
    Design design = twoPanels();
    const Patch panel = *design.find<Patch>(left);
    for (const int id : {10, 20, 21})
        design = with(design, ElementId(id), panel);
    design = with(design, ElementId(11), Seam{{right, 1, 2}, {ElementId(10), 3, 4}});
    design = with(design, ElementId(12), Seam{{ElementId(10), 1, 2}, {left, 3, 4}});
    return with(design, ElementId(22), Seam{{ElementId(20), 1, 2}, {ElementId(21), 3, 4}});
}

} // namespace

TEST(SewingOrder, IsWhatTheDesignerSaysAndGoesBackToWhatIsProposed)
{
    const Design design = ringAndPair();
    const std::vector<ElementId> proposed = orderOf(design);
    ASSERT_EQ(proposed.size(), 4u);

    const std::vector<ElementId> last{proposed[3]};
    const Design earlier = design.with(edits::moveInSewingOrder(design, last, edits::SewingMove::Earlier));
    EXPECT_EQ(orderOf(earlier), (std::vector{proposed[0], proposed[1], proposed[3], proposed[2]}));
    EXPECT_EQ(earlier.find<Seam>(proposed[0])->step, 1) << "the whole order is the designer's now";
    const std::vector<ElementId> first{proposed[0]};
    EXPECT_TRUE(edits::moveInSewingOrder(earlier, first, edits::SewingMove::Earlier).empty());

    const std::vector<ElementId> two{proposed[0], proposed[1]};
    const Design later = earlier.with(edits::moveInSewingOrder(earlier, two, edits::SewingMove::Later));
    EXPECT_EQ(orderOf(later), (std::vector{proposed[3], proposed[0], proposed[1], proposed[2]}));
    EXPECT_EQ(orderOf(later.with(edits::proposeSewingOrder(later))), proposed);
    EXPECT_TRUE(edits::proposeSewingOrder(design).empty()) << "nothing to be changed";
}

TEST(SewingOrder, FinishesACoverBeforeItBeginsAnother)
{
    const std::vector<SewingStep> order = sewingOrder(ringAndPair());
    ASSERT_EQ(order.size(), 4u);
    EXPECT_TRUE(order[2].closes);
    EXPECT_EQ(order[2].seam, ElementId(12)) << "it closes the ring";
    EXPECT_EQ(order[3].seam, ElementId(22));
}

TEST(SewingOrder, SeamsWithANumberComeFirst)
{
    Design design = ringAndPair();
    Seam seam = *design.find<Seam>(ElementId(12));
    seam.step = 1;
    design = with(design, ElementId(12), seam);
    EXPECT_EQ(orderOf(design).front(), ElementId(12));
    EXPECT_EQ(orderOf(design).size(), 4u);
}

} // namespace bolster
