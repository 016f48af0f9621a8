#include "DartEdits.h"

#include "DesignCheck.h"
#include "DesignJson.h"
#include "FollowEdits.h"
#include "StretchLength.h"
#include "TwinEdits.h"
#include "Twins.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace bolster {

namespace {

using namespace test;

std::vector<std::pair<ElementId, Seam>> seamsOf(const Design& design)
{
    std::vector<std::pair<ElementId, Seam>> found;
    design.each<Seam>([&](ElementId id, const Seam& seam) { found.emplace_back(id, seam); });
    return found;
}

std::size_t errorsIn(const Design& design)
{
    const Problems problems = checkDesign(design);
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            ADD_FAILURE() << problem.english();
    const ReadDesign read = readDesign(writeDesign(design));
    for (const Problem& problem : read.problems)
        if (problem.severity == Severity::Error)
            ADD_FAILURE() << problem.english();
    EXPECT_TRUE(read.design == design);
    return problems.size();
}

/// The bottom edge of the left panel, 20 mm wide, 50 mm deep.
const edits::DartShape bottom{left, 0.4, 0.5, {90, 50}};

} // namespace

TEST(Darts, WhatIsHeldOnBothSidesMeetsOnTheCurve)
{
    for (const bool reversed : {false, true}) {
        FixationCurve rail;
        rail.curve = BSpline3(1, false, {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}});
        FixationSeam held;
        held.stretch = {left, 0, 1};
        held.curve = ElementId(20);
        held.reversed = reversed;
        Design design = with(twoPanels(), ElementId(20), rail);
        design = with(design, ElementId(21), held);
        const Design cut = design.with(edits::addDart(design, bottom));
        errorsIn(cut);
        std::vector<FixationSeam> parts;
        cut.each<FixationSeam>([&](ElementId, const FixationSeam& part) { parts.push_back(part); });
        ASSERT_EQ(parts.size(), 2u);
        ASSERT_TRUE(parts[0].curveRange && parts[1].curveRange);
        const FixationSeam &first = parts[0].curveRange->first < parts[1].curveRange->first ? parts[0] : parts[1],
                           &last = &first == &parts[0] ? parts[1] : parts[0];
        EXPECT_NEAR(first.curveRange->first, 0, 1e-9);
        EXPECT_NEAR(first.curveRange->second, last.curveRange->first, 1e-9) << "no gap is left";
        EXPECT_NEAR(last.curveRange->second, 2, 1e-9);
        const double share = stretchLength(cut, first.stretch) /
                             (stretchLength(cut, first.stretch) + stretchLength(cut, last.stretch));
        EXPECT_NEAR(first.curveRange->second, 2 * share, 1e-6);
    }
}

TEST(Darts, TakeAWedgeOutAndSewItsLegs)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, bottom));
    errorsIn(cut);
    EXPECT_NEAR(cut.find<Patch>(left)->outline.signedArea(), 200 * 100 - 20 * 50 / 2, 1e-6);
    ASSERT_EQ(seamsOf(cut).size(), 2u);
    const auto [id, legs] = seamsOf(cut).back();
    const double leg = std::hypot(10, 50);
    EXPECT_NEAR(stretchLength(cut, legs.a), leg, 1e-9);
    EXPECT_NEAR(stretchLength(cut, legs.b), leg, 1e-9);
    EXPECT_EQ(legs.continuity, Continuity::C1);
    EXPECT_EQ(seamsOf(cut).front().second, *design.find<Seam>(between))
        << "parameters elsewhere keep their meaning";

    const auto dart = edits::dartOf(cut, id);
    ASSERT_TRUE(dart);
    EXPECT_TRUE(dart->tip.isApprox(bottom.tip, 1e-9));
    EXPECT_FALSE(edits::dartOf(cut, between)) << "an ordinary seam";
    const ReadDesign read = readDesign(writeDesign(cut));
    EXPECT_TRUE(read.design == cut);
}

TEST(Darts, LeaveZipsAndTheOrderOfSewing)
{
    Design design = twoPanels();
    Seam seam = *design.find<Seam>(between);
    seam.zip = true;
    seam.step = 3;
    design = with(design, between, seam);
    const Design cut = design.with(edits::addDart(design, bottom));
    EXPECT_EQ(*cut.find<Seam>(between), seam);
}

TEST(Darts, OverASeamShareItsOtherSide)
{
    // The right edge, 100 mm, is sewn; a dart of 20 mm in it at 30 to 50 mm.
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 1.3, 1.5, {150, 40}}));
    errorsIn(cut);
    ASSERT_EQ(seamsOf(cut).size(), 3u);
    double other = 0;
    for (const auto& [id, seam] : seamsOf(cut)) {
        if (seam.b.patch != right)
            continue;
        const double share = stretchLength(cut, seam.a) / 80;
        EXPECT_NEAR(stretchLength(cut, seam.b), 100 * share, 1e-6) << "by their lengths";
        other += stretchLength(cut, seam.b);
    }
    EXPECT_NEAR(other, 100, 1e-6) << "nothing of it is left over";
}

TEST(Darts, InCurvesAndOverTheStartOfTheOutline)
{
    Design design = twoPanels();
    Patch round = *design.find<Patch>(left);
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k)
        points.push_back(100 * Vec2(std::cos(k * 0.5235987756), std::sin(k * 0.5235987756)));
    round.outline = BSpline2(3, true, points);
    design = with(design, left, round).with({{}, {{between, nullptr, nullptr}}});
    for (const double at : {0.0, 3.3, 11.9}) {
        const Design cut = design.with(edits::addDart(design, {left, at - 0.2, at + 0.2, {0, 0}}));
        errorsIn(cut);
        ASSERT_EQ(seamsOf(cut).size(), 1u) << at;
        const auto& outline = cut.find<Patch>(left)->outline;
        EXPECT_TRUE(outline.at(outline.wrapped(6)).isApprox(round.outline.at(6), 1e-9)) << "the rest stays";
        const auto [id, legs] = seamsOf(cut).front();
        Message problem;
        const Design closed = cut.with(edits::removeDart(cut, id, &problem));
        EXPECT_EQ(problem.english(), "");
        errorsIn(closed);
        EXPECT_TRUE(seamsOf(closed).empty());
        const BSpline2& again = closed.find<Patch>(left)->outline;
        EXPECT_NEAR(again.signedArea(), round.outline.signedArea(), 1e-6);
        EXPECT_EQ(again.pointCount(), round.outline.pointCount());
    }
}

TEST(Darts, AreMovedAlongTheOutline)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, bottom));
    const Design moved = cut.with(edits::moveDart(cut, seamsOf(cut).back().first, 0.7));
    errorsIn(moved);
    const auto dart = edits::dartOf(moved, seamsOf(moved).back().first);
    ASSERT_TRUE(dart);
    EXPECT_TRUE(dart->tip.isApprox(Vec2(140, 50), 1e-6)) << dart->tip.transpose();
    EXPECT_NEAR(moved.find<Patch>(left)->outline.signedArea(), cut.find<Patch>(left)->outline.signedArea(), 1e-6);
}

TEST(Darts, InSewnEdgesLeaveThemWholeWhenTheyMoveOrClose)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, {left, 1.3, 1.5, {150, 40}}));
    const ElementId dart = seamsOf(cut).back().first;
    EXPECT_EQ(cut.with(edits::removeDart(cut, dart)).find<Seam>(between)->b, design.find<Seam>(between)->b);
    EXPECT_EQ(seamsOf(cut.with(edits::removeDart(cut, dart))).size(), 1u) << "one seam again";
    for (double at = 0.05; at < 4; at += 0.13) {
        Message problem;
        const Edit edit = edits::moveDart(cut, dart, at, &problem);
        if (edit.empty())
            continue;
        const Design moved = cut.with(edit);
        SCOPED_TRACE(at);
        errorsIn(moved);
        ASSERT_TRUE(edits::dartOf(moved, dart)) << "the seam that it was";
        double other = 0;
        for (const auto& [id, seam] : seamsOf(moved))
            if (seam.b.patch == right)
                other += stretchLength(moved, seam.b);
        EXPECT_NEAR(other, 100, 1e-6);
    }
}

TEST(Darts, TheirTipsMoveAndLegsKeepTheirParameters)
{
    const Design design = twoPanels();
    const Design cut = design.with(edits::addDart(design, bottom));
    const ElementId id = seamsOf(cut).back().first;
    const Design moved = cut.with(edits::moveDartTip(cut, id, {110, 60}));
    errorsIn(moved);
    EXPECT_EQ(seamsOf(moved), seamsOf(cut)) << "everything else keeps its place";
    const auto dart = edits::dartOf(moved, id);
    ASSERT_TRUE(dart);
    EXPECT_TRUE(dart->tip.isApprox(Vec2(110, 60), 1e-9));
    EXPECT_NEAR(moved.find<Patch>(left)->outline.signedArea(), 200 * 100 - 20 * 60 / 2, 1e-6);
    Message problem;
    EXPECT_TRUE(edits::moveDartTip(cut, id, {90, 150}, &problem).empty());
    EXPECT_FALSE(problem.empty()) << "the legs would cross the upper edge";
}

TEST(Darts, HaveMouthsAsWideAsIsWanted)
{
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k)
        points.push_back(100 * Vec2(std::cos(k * 0.5235987756), std::sin(k * 0.5235987756)));
    const BSpline2 round(3, true, points);
    for (const bool ahead : {true, false}) {
        const auto end = edits::mouthEnd(round, 0.3, 40, ahead);
        ASSERT_TRUE(end);
        EXPECT_NEAR((round.at(*end) - round.at(0.3)).norm(), 40, 1e-6);
        EXPECT_EQ(*end > 0.3 && *end < 6, ahead);
    }
    EXPECT_FALSE(edits::mouthEnd(round, 0.3, 400, true));
    const Design design = twoPanels();
    const edits::DartAxis axis = edits::dartAxis(rectangle(200, 100), edits::dartBetween(design, left, 0.5, 0.4));
    EXPECT_TRUE(axis.middle.isApprox(Vec2(90, 0), 1e-9));
    EXPECT_TRUE(axis.inwards.isApprox(Vec2(0, 1), 1e-9)) << "whichever end was clicked first";
    EXPECT_NEAR(axis.width, 20, 1e-9);
}

TEST(Darts, AreRefusedWhereTheyCannotBe)
{
    const Design design = twoPanels();
    Message problem;
    EXPECT_TRUE(edits::addDart(design, {left, 0.4, 0.5, {90, -50}}, &problem).empty());
    EXPECT_FALSE(problem.empty());
    EXPECT_TRUE(edits::addDart(design, {left, 0.4, 0.4001, {90, 50}}, &problem).empty());
    EXPECT_TRUE(edits::removeDart(design, between, &problem).empty());
    const Design darted = design.with(edits::addDart(design, {left, 0.4, 0.5, {90, 50}}));
    EXPECT_TRUE(edits::addDart(darted, {left, 0.35, 0.55, {90, 70}}, &problem).empty());
    EXPECT_NE(problem.english().find("a dart already"), std::string::npos);
    EXPECT_FALSE(edits::addDart(darted, {left, 0.6, 0.7, {130, 50}}, &problem).empty()) << "beside it";
}

TEST(Darts, InSewnEdgesOfTwinsDivideTheSeamsOfBoth)
{
    for (const bool fromFollower : {false, true}) {
        Design design = twoPanels();
        design = design.with(
            edits::makeTwins(design, std::array{left, right}, [](const std::string& n) { return n + "'"; }));
        const ElementId patch = fromFollower ? twinOf(design, left) : left;
        ASSERT_NE(patch, noElement);
        const auto make = [&](const Edit& edit) {
            ASSERT_FALSE(edit.empty());
            design = design.with(edits::withFollowers(design, edit));
        };
        const Design before = design;
        const std::size_t sewn = seamsOf(design).size();
        make(edits::addDart(design, {patch, 1.4, 1.6, {fromFollower ? -150.0 : 150.0, 50}}));
        errorsIn(design);
        EXPECT_EQ(seamsOf(design).size(), 2 * sewn + 2) << "each seam is divided, and each dart is sewn";
        EXPECT_EQ(*mirroredCurve(design.find<Patch>(left)->outline),
                  design.find<Patch>(twinOf(design, left))->outline);
        std::vector<ElementId> darts;
        for (const auto& [id, seam] : seamsOf(design))
            if (edits::dartOf(design, id))
                darts.push_back(id);
        ASSERT_EQ(darts.size(), 2u);
        make(edits::moveDartTip(design, darts.front(),
                                {patch == edits::dartOf(design, darts.front())->patch
                                     ? (fromFollower ? -140.0 : 140.0)
                                     : (fromFollower ? 140.0 : -140.0),
                                 50}));
        errorsIn(design);
        make(edits::moveDart(design, darts.front(), 1.4));
        errorsIn(design);
        EXPECT_TRUE(edits::dartOf(design, darts.front()) && edits::dartOf(design, darts.back())) << "both stay";
        make(edits::removeDart(design, darts.front()));
        errorsIn(design);
        EXPECT_EQ(seamsOf(design).size(), sewn) << "seams are whole again";
    }
}

TEST(Darts, AreCutIntoTwinsToo)
{
    Design design = twoPanels();
    design = design.with(edits::makeTwins(design, std::array{left}, [](const std::string& n) { return n + "'"; }));
    const ElementId twin = twinOf(design, left);
    design = design.with(edits::withFollowers(design, edits::addDart(design, bottom)));
    errorsIn(design);
    EXPECT_NEAR(std::abs(design.find<Patch>(twin)->outline.signedArea()), 200 * 100 - 20 * 50 / 2, 1e-6);
    int darts = 0;
    for (const auto& [id, seam] : seamsOf(design))
        darts += edits::dartOf(design, id).has_value();
    EXPECT_EQ(darts, 2);
}

TEST(Darts, KeepNotchesThatLieUnderTheirMouths)
{
    Design design = twoPanels();
    const auto notch = [&](ElementId id, double at) { design = with(design, id, Notch{{left, at}, {}}); };
    notch(ElementId(40), 0.43); // of the mouth's 0.4 to 0.5
    notch(ElementId(41), 0.44);
    notch(ElementId(42), 0.48);
    notch(ElementId(43), 0.7);
    for (const bool twins : {false, true}) {
        if (twins)
            design = design.with(
                edits::makeTwins(design, std::array{left}, [](const std::string& n) { return n + "'"; }));
        const Design cut = design.with(edits::withFollowers(design, edits::addDart(design, bottom)));
        errorsIn(cut);
        const BSpline2& outline = cut.find<Patch>(left)->outline;
        const auto placeOf = [&](ElementId id) {
            return outline.at(outline.wrapped(cut.find<Notch>(id)->place.at));
        };
        ASSERT_TRUE(cut.find<Notch>(ElementId(40)) && cut.find<Notch>(ElementId(42)));
        EXPECT_TRUE(placeOf(ElementId(40)).isApprox(Vec2(80, 0), 1e-9)) << "at the nearer leg";
        EXPECT_TRUE(placeOf(ElementId(42)).isApprox(Vec2(100, 0), 1e-9));
        EXPECT_FALSE(cut.find<Notch>(ElementId(41))) << "there is one already";
        EXPECT_TRUE(placeOf(ElementId(43)).isApprox(Vec2(140, 0), 1e-9));
        std::map<ElementId, int> count;
        cut.each<Notch>([&](ElementId, const Notch& each) { ++count[each.place.patch]; });
        EXPECT_EQ(count[left], 3);
        if (twins) {
            EXPECT_EQ(count[twinOf(cut, left)], 3);
        }
    }
}

} // namespace bolster
