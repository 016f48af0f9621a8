#include "CuttingEdits.h"

#include "DesignCheck.h"
#include "DesignJson.h"
#include "ElementEdits.h"
#include "FollowEdits.h"
#include "PatchMark.h"
#include "PatchSplit.h"
#include "TwinEdits.h"
#include "Twins.h"

#include "Panels.h"

#include <gtest/gtest.h>

#include <array>

namespace bolster {

namespace {

using namespace test;

template <class T>
std::vector<std::pair<ElementId, T>> all(const Design& design)
{
    std::vector<std::pair<ElementId, T>> found;
    design.each<T>([&](ElementId id, const T& value) { found.emplace_back(id, value); });
    return found;
}

/// The left panel and its mirror twin.
Design twins()
{
    Design design = twoPanels();
    const auto name = [](const std::string& text) { return text + " mirrored"; };
    return design.with(edits::makeTwins(design, std::array{left}, name));
}

} // namespace

TEST(CuttingEdits, OneStretchHasOneAllowance)
{
    Design design = twoPanels();
    design = design.with(edits::setEdgeAllowance(design, {left, 1, 2}, 20));
    design = design.with(edits::setEdgeAllowance(design, {left, 1, 2}, 25));
    ASSERT_EQ(all<EdgeAllowance>(design).size(), 1u);
    EXPECT_EQ(all<EdgeAllowance>(design)[0].second.width, 25);
    Message problem;
    EXPECT_TRUE(edits::setEdgeAllowance(design, {left, 1.5, 3}, 5, &problem).empty());
    EXPECT_FALSE(problem.key.empty());
    EXPECT_FALSE(edits::setEdgeAllowance(design, {left, 2, 3}, 5).empty());
}

TEST(CuttingEdits, MarksAreReadAndWritten)
{
    Design design = twoPanels();
    design = design.with(edits::setEdgeAllowance(design, {left, 1, 2}, 20));
    design = design.with(edits::addNotch(design, {left, 1.25}, {NotchShape::Kind::Castle, 5, 6}));
    design = design.with(edits::setCutCorner(design, {left, 2}, CornerJoin::Folded));
    design = design.with(edits::addDrillHole(design, {left, {50, 50}}, "Button"));
    design = design.with(edits::addInternalLine(design, left, BSpline2(1, false, {{10, 10}, {90, 10}}),
                                                InternalLine::Purpose::TieDown, "Strip"));
    design = design.with(edits::setLabel(design, left, PieceLabelPlace{{100, 50}, 15}));
    design = design.with(edits::setAllowance(design, std::array{left, right}, CutAllowance{8, CornerJoin::Square}));
    const ReadDesign read = readDesign(writeDesign(design));
    ASSERT_TRUE(read.readable);
    EXPECT_TRUE(read.problems.empty());
    EXPECT_TRUE(read.design == design);
}

TEST(CuttingEdits, NotchesAndHolesAreRefusedWhereTheyCannotBe)
{
    Design design = twoPanels();
    design = design.with(edits::addNotch(design, {left, 1.25}, {}));
    Message problem;
    EXPECT_TRUE(edits::addNotch(design, {left, 1.25}, {}, &problem).empty());
    EXPECT_FALSE(problem.key.empty());
    EXPECT_TRUE(edits::addDrillHole(design, {left, {-5, 50}}, "Hole", &problem).empty());
}

TEST(CuttingEdits, MarksAppearChangeAndGoOnTwinsToo)
{
    Design design = twins();
    const ElementId twin = twinOf(design, left);
    ASSERT_NE(twin, noElement);
    const auto apply = [&](const Edit& edit) {
        ASSERT_FALSE(edit.empty());
        design = design.with(edits::withFollowers(design, edit));
    };
    apply(edits::setEdgeAllowance(design, {left, 1, 2}, 20));
    apply(edits::addNotch(design, {twin, 2.5}, {}));
    apply(edits::addDrillHole(design, {left, {50, 40}}, "Button"));
    apply(edits::addInternalLine(design, left, BSpline2(1, false, {{10, 10}, {90, 10}}),
                                 InternalLine::Purpose::Guide, "Line"));
    ASSERT_EQ(all<EdgeAllowance>(design).size(), 2u);
    EXPECT_EQ(all<EdgeAllowance>(design)[1].second, (EdgeAllowance{{twin, 1, 2}, 20}));
    ASSERT_EQ(all<Notch>(design).size(), 2u);
    EXPECT_EQ(all<Notch>(design)[1].second.place, (OutlinePlace{left, 2.5}));
    ASSERT_EQ(all<DrillHole>(design).size(), 2u);
    EXPECT_EQ(all<DrillHole>(design)[1].second.place, (PatchPoint{twin, {-50, 40}}));
    EXPECT_EQ(all<InternalLine>(design).size(), 2u);

    const ElementId allowance = all<EdgeAllowance>(design)[0].first, hole = all<DrillHole>(design)[0].first;
    apply(edits::setEdgeAllowance(design, {left, 1, 2}, 33));
    EXPECT_EQ(all<EdgeAllowance>(design)[1].second.width, 33);
    apply(edits::moveDrillHoles(design, std::array{hole}, {5, 0}));
    EXPECT_EQ(all<DrillHole>(design)[1].second.place, (PatchPoint{twin, {-55, 40}}));
    apply(edits::removeElements(design, std::array{allowance, hole}));
    EXPECT_TRUE(all<EdgeAllowance>(design).empty());
    EXPECT_TRUE(all<DrillHole>(design).empty());
    apply(edits::setAllowance(design, std::array{twin}, CutAllowance{4}));
    EXPECT_EQ(design.find<Patch>(left)->allowance, CutAllowance{4});
    apply(edits::setLabel(design, left, PieceLabelPlace{{20, 30}, 10}));
    EXPECT_EQ(design.find<Patch>(twin)->cutting.label, (PieceLabelPlace{{-20, 30}, -10}));
}

TEST(CuttingEdits, MarksStayWhereTheyAreWhenAPatchIsSplit)
{
    Design design = twoPanels();
    design = design.with(edits::setEdgeAllowance(design, {left, 0, 1}, 20)); // the bottom edge
    design = design.with(edits::addNotch(design, {left, 0.25}, {}));         // at x = 50
    design = design.with(edits::addNotch(design, {left, 0.75}, {}));         // at x = 150
    design = design.with(edits::addDrillHole(design, {left, {50, 50}}, "One"));
    design = design.with(edits::addDrillHole(design, {left, {150, 50}}, "Two"));
    const edits::Outcome outcome = edits::splitPatch(design, left, {{90, -10}, {90, 110}});
    ASSERT_FALSE(outcome.edit.empty());
    const Design split = design.with(outcome.edit);
    EXPECT_EQ(all<EdgeAllowance>(split).size(), 2u);
    const auto where = [&](const OutlinePlace& place) {
        return split.find<Patch>(place.patch)->outline.at(place.at);
    };
    std::set<ElementId> patches;
    for (const auto& [id, notch] : all<Notch>(split)) {
        patches.insert(notch.place.patch);
        EXPECT_NEAR(where(notch.place).y(), 0, 1e-6);
        const double x = where(notch.place).x();
        EXPECT_NEAR(std::min(std::abs(x - 50), std::abs(x - 150)), 0, 1e-6);
    }
    EXPECT_EQ(patches.size(), 2u);
    std::set<ElementId> drilled;
    for (const auto& [id, hole] : all<DrillHole>(split))
        drilled.insert(hole.place.patch);
    EXPECT_EQ(drilled.size(), 2u);
}

TEST(CuttingEdits, MistakesInWhatIsCutLeaveTheCoverAlone)
{
    Design design = with(twoPanels(), ElementId{9}, EdgeAllowance{{left, 1, 2}, 20});
    design = with(design, ElementId{10}, EdgeAllowance{{left, 1.5, 3}, 20});
    design = with(design, ElementId{11}, Notch{{left, 77}});
    const Problems problems = checkDesign(design);
    std::set<ElementId> wrong;
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            wrong.insert(problem.element);
    EXPECT_EQ(wrong, (std::set<ElementId>{ElementId{10}, ElementId{11}}));
}

TEST(CuttingEdits, NotchesStandSoFarFromTheirCorner)
{
    // 200 by 100 mm; on the bottom edge, nearer to its right corner, and on the left edge.
    Design design = with(twoPanels(), ElementId{11}, Notch{{left, 0.7}, {}});
    design = with(design, ElementId{12}, Notch{{left, 3.9}, {}});
    const std::array both{ElementId{11}, ElementId{12}};
    const Design now = design.with(edits::setCornerDistance(design, both, 30));
    const auto place = [&](int id) {
        const BSpline2& outline = now.find<Patch>(left)->outline;
        return outline.at(now.find<Notch>(ElementId{id})->place.at);
    };
    EXPECT_TRUE(place(11).isApprox(Vec2(170, 0), 1e-9)) << place(11).transpose();
    EXPECT_TRUE(place(12).isApprox(Vec2(0, 30), 1e-9)) << place(12).transpose();
    Message problem;
    EXPECT_TRUE(edits::setCornerDistance(design, both, 150, &problem).empty()) << "the left edge is shorter";
    EXPECT_NE(problem.english().find("not as long"), std::string::npos);
    EXPECT_FALSE(edits::setCornerDistance(design, std::array{ElementId{11}}, 150).empty());
}

} // namespace bolster
