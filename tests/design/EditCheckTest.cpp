// What an edit would break, as drags show it.
#include "EditCheck.h"

#include "DesignCheck.h"
#include "PatchEdits.h"
#include "SeamEdits.h"
#include "TestData.h"
#include "TwinEdits.h"

#include <array>
#include <numbers>
#include <random>

namespace bolster {
namespace {

using namespace edits;

// Two squares that are sewn together twice; a closed handle, a straight one and a fixation in the first.
constexpr const char* squares = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "One", "fabric": 1, "position": [0, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,100],[0,100]]}},
  {"id": 3, "kind": "patch", "name": "Two", "fabric": 1, "position": [200, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,100],[0,100]]}},
  {"id": 10, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 3, "to": 4}},
  {"id": 11, "kind": "seam", "a": {"patch": 2, "from": 2, "to": 3}, "b": {"patch": 3, "from": 2, "to": 3}},
  {"id": 12, "kind": "fixation_curve", "name": "Rail", "curve": {"degree": 1, "points": [[0,0,0],[100,0,0]]}},
  {"id": 13, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 12},
  {"id": 14, "kind": "fixation_seam", "patch": 2, "from": 3, "to": 4, "curve": 12}]})";

constexpr ElementId one{2}, two{3}, right{10}, top{11}, rail{12}, bottomFixed{13}, ring{20}, line{21};

Design withHandles()
{
    const Design design = readDesign(squares).design;
    EXPECT_TRUE(design.find<FixationSeam>(bottomFixed));
    Edit edit;
    HandleCurve closed{{"Ring", one, BSpline2(1, true, {{60, 60}, {80, 60}, {70, 80}})},
                       BSpline3(1, true, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}),
                       Match::Length};
    HandleCurve open{{"Line", one, BSpline2(1, false, {{0, 20}, {50, 20}})},
                     BSpline3(1, false, {{0, 0, 0}, {50, 0, 0}}),
                     Match::Length};
    edit.changes = {{ring, nullptr, makeElement(closed)}, {line, nullptr, makeElement(open)}};
    return design.with(edit);
}

class EditCheck : public testing::Test {
protected:
    std::set<ElementId> broken(const Edit& edit) const
    {
        const auto found = brokenBy(design, withTwins(design, edit));
        EXPECT_TRUE(!found || !found->why.empty());
        return found ? found->elements : std::set<ElementId>();
    }
    Edit movePoint(ElementId id, int point, const Vec2& by) const
    {
        return movePatchPoints(design, id, std::array{point}, by);
    }

    Design design = withHandles();
    using Ids = std::set<ElementId>;
};

TEST_F(EditCheck, OutlinesStaySimple)
{
    EXPECT_EQ(broken({}), Ids{});
    EXPECT_EQ(broken(movePoint(two, 0, {30, 30})), Ids{});
    EXPECT_EQ(broken(movePoint(two, 0, {150, 50})), Ids{two});
    EXPECT_EQ(broken(movePatches(design, std::array{two}, {-180, 3})), Ids{}) << "the layout is free";
}

TEST_F(EditCheck, CurvesStayInTheirPatches)
{
    EXPECT_EQ(broken(movePoint(ring, 1, {15, 0})), Ids{});
    EXPECT_EQ(broken(movePoint(ring, 1, {25, 0})), Ids{ring});
    EXPECT_EQ(broken(movePatchPoints(design, ring, std::array{0, 1, 2}, {0, 200})), Ids{ring}) << "all outside";
    EXPECT_EQ(broken(movePoint(line, 0, {-2, 0})), Ids{}) << "it ends at the outline, as well as nothing";
    EXPECT_EQ(broken(movePoint(line, 0, {-20, 0})), Ids{line});
    EXPECT_EQ(broken(movePoint(one, 2, {-40, -40})), Ids{ring}) << "the outline is moved instead";
}

TEST_F(EditCheck, StretchesKeepToThemselves)
{
    using enum SeamSide;
    using enum StretchEnd;
    EXPECT_EQ(broken(dragStretchEnd(design, right, A, To, 1.5)), Ids{});
    EXPECT_EQ(broken(dragStretchEnd(design, right, A, To, 2.25)), Ids{right});
    EXPECT_EQ(broken(dragStretchEnd(design, right, A, From, 0.5)), Ids{}) << "what is fixed can be sewn, too";
    EXPECT_EQ(broken(dragStretchEnd(design, top, B, To, 3.25)), Ids{top});
    EXPECT_EQ(broken(dragStretchEnd(design, bottomFixed, A, To, 1.5)), Ids{});
    EXPECT_EQ(broken(dragStretchEnd(design, bottomFixed, A, From, 3.5)), Ids{bottomFixed});
    EXPECT_EQ(broken(movePoint(two, 2, {-100, 0})), Ids{top}) << "the corners meet: no length is left";
}

TEST_F(EditCheck, ADraggedEndIsOneChangeThatCanBeUndone)
{
    for (const ElementId owner : {right, bottomFixed}) {
        const Edit edit = dragStretchEnd(design, owner, SeamSide::A, StretchEnd::To, 0.25);
        ASSERT_EQ(edit.changes.size(), 1U);
        EXPECT_EQ(design.with(edit).with(edit.inverse()), design);
    }
    EXPECT_TRUE(dragStretchEnd(design, one, SeamSide::A, StretchEnd::To, 0.25).empty());
    EXPECT_TRUE(dragStretchEnd(design, right, SeamSide::A, StretchEnd::To, 2).empty()) << "it is there already";
    EXPECT_TRUE(dragStretchEnd(design, right, SeamSide::A, StretchEnd::To, NAN).empty());
}

TEST_F(EditCheck, ATwinThatWouldBreakIsNamed)
{
    design = design.with(makeTwins(design, std::array{two}, [](const std::string& name) { return name + "'"; }));
    EXPECT_EQ(broken(movePoint(two, 0, {150, 50})).size(), 2U);
}

TEST_F(EditCheck, WhatWasBrokenMayStaySo)
{
    design = design.with(movePoint(two, 0, {150, 50}));
    EXPECT_EQ(broken(movePoint(two, 0, {-5, 0})), Ids{});
    design = design.with(movePoint(line, 0, {-20, 0}));
    EXPECT_EQ(broken(movePoint(line, 0, {2, 0})), Ids{});
}

TEST_F(EditCheck, FindsWhateverTheRulesForOutlinesFind)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> by(-180, 180);
    int crossing = 0;
    for (int i = 0; i < 300; ++i) {
        const Edit edit = movePoint(two, static_cast<int>(random() % 4), {by(random), by(random)});
        const bool bad = outlineProblem(design.with(edit).find<Patch>(two)->outline).has_value();
        EXPECT_EQ(broken(edit).contains(two), bad) << i;
        crossing += bad;
    }
    EXPECT_GT(crossing, 20);
}

} // namespace
} // namespace bolster
