#include "SeamTruing.h"

#include "ArcLength.h"
#include "DartEdits.h"
#include "DesignCheck.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {

namespace {

using namespace test;

constexpr double degree = std::numbers::pi / 180;

/// Two panels whose lower edges lean by these angles: 90 degrees and so much more inside, at the lower end of the
/// seam.
Design leaningPanels(double a, double b, int raise = 1)
{
    Design design = twoPanels();
    Patch one = *design.find<Patch>(left), two = *design.find<Patch>(right);
    one.outline = BSpline2(1, true, {{0, -200 * std::tan(a * degree)}, {200, 0}, {200, 100}, {0, 100}});
    two.outline = BSpline2(1, true, {{0, 0}, {200, -200 * std::tan(b * degree)}, {200, 100}, {0, 100}});
    if (raise < 0) // the other way round, with the seam's stretches as they lie then
        for (Patch* patch : {&one, &two})
            patch->outline = patch->outline.reversed();
    design = with(with(design, left, one), right, two);
    if (raise > 0)
        return design;
    Seam seam = *design.find<Seam>(between);
    seam.a = {left, 2, 3};
    seam.b = {right, 0, 1};
    return with(design, between, seam);
}

const Seam& seamIn(const Design& design)
{
    return *design.find<Seam>(between);
}

/// Which end is the lower one: of the first side where it begins, the other way round where it ends.
double lowerKink(const Design& design, bool turned)
{
    return edits::kinkAtSeamEnd(design, seamIn(design), !turned).value();
}

} // namespace

TEST(SeamTruing, MeasuresTheKinkAtAnEnd)
{
    for (const bool turned : {false, true}) {
        const Design design = leaningPanels(10, 6, turned ? -1 : 1);
        EXPECT_NEAR(lowerKink(design, turned), -16, 1e-9) << "180 - 100 - 96";
        EXPECT_NEAR(*edits::kinkAtSeamEnd(design, seamIn(design), turned), 0, 1e-9) << "above all is straight";
    }
    Seam inside = seamIn(leaningPanels(0, 0));
    inside.a.from = 1.3;
    EXPECT_FALSE(edits::kinkAtSeamEnd(leaningPanels(0, 0), inside, true)) << "it begins inside an edge";
}

TEST(SeamTruing, GivesBothSidesTheMeanTangent)
{
    for (const bool turned : {false, true}) {
        const Design design = leaningPanels(10, 6, turned ? -1 : 1);
        Message problem;
        const Design now = design.with(edits::smoothAcrossSeamEnds(design, std::array{between}, &problem));
        EXPECT_EQ(problem.english(), "");
        for (const Problem& wrong : checkDesign(now))
            EXPECT_NE(wrong.severity, Severity::Error) << wrong.english();
        EXPECT_NEAR(lowerKink(now, turned), 0, 1e-9);
        // By half each: the left edge leaned by 10 degrees and now by 2; the right one from 6 to -2.
        const BSpline2& outline = now.find<Patch>(left)->outline;
        const double corner = turned ? seamIn(now).a.to : seamIn(now).a.from;
        const Vec2 along =
            turned ? outline.derivative(corner)
                   : Vec2(outline.reversed().derivative(outline.domainStart() + outline.domainEnd() - corner));
        EXPECT_NEAR(std::atan2(-along.y(), -along.x()) / degree, 2, 1e-6);
        for (const Stretch& side : {seamIn(now).a, seamIn(now).b})
            EXPECT_NEAR(ArcLength2(now.find<Patch>(side.patch)->outline).between(side.from, side.to), 100, 1e-9)
                << "the seam stays";
        EXPECT_TRUE(edits::smoothAcrossSeamEnds(now, std::array{between}, &problem).empty()) << "once is enough";
        EXPECT_EQ(problem.english(), "") << "nothing is wrong";
    }
}

TEST(SeamTruing, TruesTheMouthOfADart)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    ElementId dart = noElement;
    cut.each<Seam>([&](ElementId id, const Seam&) { dart = edits::dartOf(cut, id) ? id : dart; });
    const Seam& legs = *cut.find<Seam>(dart);
    const double angle = std::atan2(10, 50) / degree;
    EXPECT_NEAR(*edits::kinkAtSeamEnd(cut, legs, true), 180 - 2 * (90 + angle), 1e-9);
    EXPECT_FALSE(edits::kinkAtSeamEnd(cut, legs, false)) << "the tip";
    const Design now = cut.with(edits::smoothAcrossSeamEnds(cut, std::array{dart}));
    EXPECT_NEAR(*edits::kinkAtSeamEnd(now, *now.find<Seam>(dart), true), 0, 1e-9);
    EXPECT_TRUE(edits::dartOf(now, dart)) << "its legs stay straight";
}

TEST(SeamTruing, LeavesCornersThatAreWanted)
{
    const Design design = leaningPanels(40, 35);
    Message problem;
    EXPECT_TRUE(edits::smoothAcrossSeamEnds(design, std::array{between}, &problem).empty());
    EXPECT_NE(problem.english().find("60"), std::string::npos);
    Seam inside = seamIn(design);
    inside.a = {left, 1.2, 1.8};
    problem = {};
    const Design other = with(design, between, inside);
    EXPECT_TRUE(edits::smoothAcrossSeamEnds(other, std::array{between}, &problem).empty());
    EXPECT_FALSE(problem.empty());
}

} // namespace bolster
