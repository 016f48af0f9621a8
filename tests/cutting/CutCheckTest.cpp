#include "CutCheck.h"

#include "DartEdits.h"
#include "ElementEdits.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bolster {

namespace {

using namespace test;

/// What is found in a design that was sound.
std::vector<CutFinding> findings(const Design& design)
{
    return checkCutting(design, cutPattern(design, {}));
}

bool says(const std::vector<CutFinding>& found, const std::string& words)
{
    return std::ranges::any_of(found, [&](const CutFinding& finding) {
        return finding.problem.message.english().find(words) != std::string::npos;
    });
}

} // namespace

TEST(CutCheck, HasNothingToSayOfASoundPattern)
{
    for (const CutFinding& finding : findings(twoPanels()))
        ADD_FAILURE() << finding.problem.english();
}

TEST(CutCheck, ComparesSidesOfSeamsWithTheEaseThatIsWanted)
{
    Design design = twoPanels();
    Patch taller = *design.find<Patch>(right);
    taller.outline = rectangle(200, 106);
    design = with(design, right, taller);
    EXPECT_TRUE(says(findings(design), "100 mm and 106 mm"));
    Seam seam = *design.find<Seam>(between);
    seam.ease = 6;
    EXPECT_FALSE(says(findings(with(design, between, seam)), "its sides"));
    seam.ease = -6;
    EXPECT_TRUE(says(findings(with(design, between, seam)), "its sides"));
}

TEST(CutCheck, OneNotchIsForBothSeamsBesideADart)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 1.3, 1.5, {140, 40}}));
    EXPECT_FALSE(says(findings(cut), "no partner"));
}

TEST(CutCheck, FindsNotchesThatNobodyMeetsOrThatCutTheSeam)
{
    Notch notch;
    notch.place = {left, 0.5};
    const auto alone = findings(with(twoPanels(), ElementId{9}, notch));
    ASSERT_TRUE(says(alone, "no partner"));
    EXPECT_EQ(alone.front().problem.element, ElementId{9});
    EXPECT_EQ(alone.front().patch, left);
    EXPECT_TRUE(alone.front().place.isApprox(Vec2(100, 0)) || alone.front().place == Vec2(100, 0));
    notch.place = {left, 1.5};
    EXPECT_FALSE(says(findings(with(twoPanels(), ElementId{9}, notch)), "no partner"));
    notch.shape.depth = 9.5;
    EXPECT_TRUE(says(findings(with(twoPanels(), ElementId{9}, notch)), "reaches the sewing line"));
}

TEST(CutCheck, FindsNotchesThatCutIntoThePiece)
{
    Design design = with(twoPanels(), ElementId{9}, Notch{{left, 0.5}, {}});
    EXPECT_FALSE(says(findings(design), "cut into the piece"));
    design = with(design, ElementId{10}, EdgeAllowance{{left, 0, 1}, 0});
    EXPECT_TRUE(says(findings(design), "cut into the piece"));
}

TEST(CutCheck, FindsWhatDoesNotFit)
{
    Design design = twoPanels();
    Patch wide = *design.find<Patch>(left);
    wide.outline = rectangle(1500, 100);
    EXPECT_TRUE(says(findings(with(design, left, wide)), "wide across the grain"));
    wide.cutting.nap = Nap::Any;
    EXPECT_FALSE(says(findings(with(design, left, wide)), "wide across the grain")) << "it may be turned";
    Patch strip = *design.find<Patch>(left);
    strip.outline = rectangle(200, 3);
    EXPECT_TRUE(says(findings(with(design, left, strip)), "no room"));
}

TEST(CutCheck, FindsWhatReachesOutOfThePiece)
{
    const Design design = twoPanels();
    const auto withHole = [&](double x) {
        return design.with(edits::addElement(design, makeElement(DrillHole{"Hole", {left, Vec2(x, 50)}, 8})));
    };
    EXPECT_FALSE(says(findings(withHole(100)), "breaks through"));
    EXPECT_TRUE(says(findings(withHole(-9)), "breaks through")) << "10 mm of allowance, a hole of 8";
    const Design cut = design.with(edits::addDart(design, {left, 0.4, 0.6, {100, 99}}));
    EXPECT_TRUE(says(findings(cut), "are left of the piece"));
    EXPECT_FALSE(says(findings(design.with(edits::addDart(design, {left, 0.4, 0.6, {100, 60}}))), "are left of"));
}

TEST(CutCheck, BeginsWithWhatIsWorst)
{
    Design design = twoPanels();
    Patch taller = *design.find<Patch>(right);
    taller.outline = rectangle(200, 106);
    Patch wide = *design.find<Patch>(left);
    wide.outline = rectangle(1500, 100);
    Notch alone;
    alone.place = {left, 0.5};
    const auto found = findings(with(with(with(design, left, wide), right, taller), ElementId{9}, alone));
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].harm, CutHarm::CannotBeCut);
    EXPECT_EQ(found[0].problem.element, left);
    EXPECT_EQ(found[1].problem.element, between) << "its sides have different lengths";
    EXPECT_EQ(found[2].problem.element, ElementId{9});
}

TEST(CutCheck, SaysWhereOnTheOutlineItIsWhateverTheFabricShrinks)
{
    Design design = twoPanels();
    Fabric fabric = *design.find<Fabric>(leather);
    fabric.cutting.shrinkAlong = 20;
    fabric.cutting.shrinkAcross = 50;
    Notch alone;
    alone.place = {left, 0.5};
    const auto found = findings(with(with(design, leather, fabric), ElementId{9}, alone));
    const auto notch =
        std::ranges::find(found, ElementId{9}, [](const CutFinding& f) { return f.problem.element; });
    ASSERT_NE(notch, found.end());
    EXPECT_TRUE((notch->place - Vec2(100, 0)).isZero(1e-6)) << notch->place.transpose();
}

TEST(CutCheck, LeavesTipsOfDartsAloneAndCountsNotches)
{
    Design design = twoPanels();
    Patch dart = *design.find<Patch>(left);
    dart.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 100}, {110, 100}, {100, 20}, {90, 100}, {0, 100}});
    design = with(design, left, dart);
    EXPECT_TRUE(says(findings(design), "too sharp")) << "a slit that nobody sews";
    Seam legs;
    legs.a = {left, 3, 4};
    legs.b = {left, 4, 5};
    legs.reversed = true;
    design = with(design, ElementId{10}, legs);
    EXPECT_FALSE(says(findings(design), "too sharp"));
    Notch notch;
    for (const int k : {0, 1, 2}) {
        notch.place = {right, 2.25 + 0.2 * k};
        design = with(design, static_cast<ElementId>(20 + k), notch);
    }
    const auto found = findings(design);
    EXPECT_TRUE(says(found, "of its notches are")) << "one row";
    EXPECT_EQ(std::ranges::count(found, right, [](const CutFinding& f) { return f.patch; }), 1);
}

TEST(CutCheck, FindsCornersThatCannotBeSewnAndCutLinesThatMeet)
{
    Design design = twoPanels();
    Patch slit = *design.find<Patch>(left);
    slit.outline = BSpline2(1, true, {{0, 0}, {200, 0}, {200, 100}, {104, 100}, {100, 20}, {96, 100}, {0, 100}});
    EXPECT_TRUE(says(findings(with(design, left, slit)), "too sharp"));
    Patch ring = *design.find<Patch>(left);
    ring.outline = BSpline2(1, true,
                            {{0, 0},
                             {200, 0},
                             {200, 200},
                             {105, 200},
                             {105, 150},
                             {150, 150},
                             {150, 50},
                             {50, 50},
                             {50, 150},
                             {95, 150},
                             {95, 200},
                             {0, 200}});
    EXPECT_TRUE(says(findings(with(design, left, ring)), "cut lines meet"));
}

} // namespace bolster
