#include "SeamEdits.h"
#include "ArcLength.h"
#include "DesignCheck.h"
#include "EditCheck.h"
#include "SeamStretches.h"

#include "TestData.h"

#include <array>

namespace bolster {
namespace {

using namespace edits;

// A long side of 300 mm; three short pieces in a row below it, the first one drawn clockwise; a round one.
constexpr const char* pieces = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Long", "fabric": 1, "position": [0, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[150,0],[300,0],[300,100],[0,100]]}},
  {"id": 3, "kind": "patch", "name": "One", "fabric": 1, "position": [0, -150],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[50,0],[50,100],[0,100]]}},
  {"id": 4, "kind": "patch", "name": "Two", "fabric": 1, "position": [100, -150],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,100],[0,100]]}},
  {"id": 5, "kind": "patch", "name": "Three", "fabric": 1, "position": [250, -150],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[50,0],[50,100],[0,100]]}},
  {"id": 6, "kind": "patch", "name": "Turned", "fabric": 1, "position": [0, -300],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[0,100],[100,100],[100,0]]}},
  {"id": 7, "kind": "patch", "name": "Round", "fabric": 1, "position": [0, 300],
   "outline": {"degree": 3, "closed": true, "points": [[50,0],[0,50],[-50,0],[0,-50]]}},
  {"id": 8, "kind": "patch", "name": "Steps", "fabric": 1, "position": [0, 500],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[100,0],[100,50],[200,50],[200,200],[0,200]]}},
  {"id": 20, "kind": "seam", "a": {"patch": 3, "from": 1, "to": 2}, "b": {"patch": 4, "from": 3, "to": 4}}]})";

constexpr ElementId longOne{2}, one{3}, two{4}, three{5}, turned{6}, roundOne{7}, steps{8}, sewn{20};

class SeamEdits : public testing::Test {
protected:
    static const Seam& seamOf(const Edit& edit, std::size_t change = 0)
    {
        return std::get<Seam>(*edit.changes[change].after);
    }

    static void expectSeam(const Seam& seam, const Seam& expected)
    {
        for (const auto& [is, should] : {std::pair(seam.a, expected.a), std::pair(seam.b, expected.b)}) {
            EXPECT_EQ(is.patch, should.patch);
            EXPECT_NEAR(is.from, should.from, 1e-9);
            EXPECT_NEAR(is.to, should.to, 1e-9);
        }
        EXPECT_EQ(seam.reversed, expected.reversed);
    }

    void expectUndone(const Edit& edit) const
    {
        EXPECT_FALSE(edit.empty());
        EXPECT_EQ(design.with(edit).with(edit.inverse()), design);
    }

    const Design design = readDesign(pieces).design;
};

TEST_F(SeamEdits, AnEdgeRunsFromCornerToCorner)
{
    EXPECT_EQ(freeStretchAt(design, longOne, 0.5), (Stretch{longOne, 0, 2})) << "point 1 is no corner";
    EXPECT_EQ(freeStretchAt(design, longOne, 1.7), (Stretch{longOne, 0, 2}));
    EXPECT_EQ(freeStretchAt(design, longOne, 4.2), (Stretch{longOne, 4, 5})) << "up to the end, not to 0";
    EXPECT_EQ(freeStretchAt(design, roundOne, 2.5), (Stretch{roundOne, 0, 4})) << "no corners: all of it";
    EXPECT_FALSE(freeStretchAt(design, ElementId{99}, 0));
    EXPECT_EQ(edgeNumber(design.find<Patch>(longOne)->outline, 0), 1);
    EXPECT_EQ(edgeNumber(design.find<Patch>(longOne)->outline, 2), 2);
    EXPECT_EQ(edgeNumber(design.find<Patch>(roundOne)->outline, 2), 0);
}

TEST_F(SeamEdits, AnEdgePassesTheStartOfTheOutline)
{
    const BSpline2 outline(1, true, {{150, 0}, {300, 0}, {300, 100}, {0, 100}, {0, 0}});
    Patch patch = *design.find<Patch>(longOne);
    patch.outline = outline;
    const Design shifted = design.with({{}, {{longOne, nullptr, makeElement(patch)}}});
    EXPECT_EQ(freeStretchAt(shifted, longOne, 0.5), (Stretch{longOne, 4, 1}));
    EXPECT_EQ(freeStretchAt(shifted, longOne, 4.5), (Stretch{longOne, 4, 1}));
    const Design half = shifted.with(addSeam(shifted, {longOne, 0, 1}, {steps, 0, 1}, true));
    EXPECT_EQ(freeStretchAt(half, longOne, 4.5), (Stretch{longOne, 4, 5}));
    EXPECT_FALSE(freeStretchAt(half, longOne, 0.5));
    EXPECT_EQ(sewnAt(half, longOne, 0.5)->second, (Stretch{longOne, 0, 1}));
}

TEST_F(SeamEdits, FindsSeamsOfOutlinesThatNoLongerBeginAtZero)
{
    const BSpline2 outline(1, true, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {1, 2, 3, 4, 5});
    Patch patch = *design.find<Patch>(turned);
    patch.outline = outline;
    const Seam seam{{turned, 0, 1}, {three, 2, 3}};
    const Design moved =
        design.with({{}, {{turned, nullptr, makeElement(patch)}, {ElementId{30}, nullptr, makeElement(seam)}}});
    EXPECT_FALSE(freeStretchAt(moved, turned, 4.5)) << "0 to 1 is 4 to 5";
    EXPECT_EQ(freeStretchAt(moved, turned, 3.5), (Stretch{turned, 3, 4}));
    EXPECT_FALSE(dragStretchEnd(moved, ElementId{30}, SeamSide::B, StretchEnd::To, 2.5).empty());
}

TEST_F(SeamEdits, SewsTwoStretches)
{
    const Edit edit = addSeam(design, {longOne, 0, 2}, {two, 2, 3}, true);
    ASSERT_EQ(edit.changes.size(), 1U);
    EXPECT_EQ(seamOf(edit), (Seam{{longOne, 0, 2}, {two, 2, 3}, true}));
    EXPECT_EQ(edit.verb.english(), "Sew Long to Two");
    expectUndone(edit);
}

TEST_F(SeamEdits, RefusesWithAReason)
{
    Message why;
    EXPECT_TRUE(addSeam(design, {one, 1.2, 1.4}, {longOne, 0, 2}, true, &why).empty());
    EXPECT_EQ(why.english(), "One is already sewn to Two here: remove that seam first, or take a free stretch.");
    EXPECT_TRUE(addSeam(design, {longOne, 0, 2}, {longOne, 1, 3}, true, &why).empty());
    EXPECT_EQ(why.english(), "A stretch cannot be sewn to itself: choose two that have no part in common.");
    EXPECT_TRUE(addSeam(design, {longOne, 1, 1 + 1e-9}, {two, 0, 1}, true, &why).empty());
    EXPECT_EQ(why.english(), "This stretch has no length: choose two different points.");
    EXPECT_TRUE(addSeam(design, {ElementId{99}, 0, 1}, {two, 0, 1}, true, &why).empty());
    EXPECT_FALSE(addSeam(design, {one, 2, 3}, {two, 2, 3}, true).empty()) << "ends may meet";
    const std::array twice = {Stretch{three, 0, 2}, Stretch{three, 1, 3}};
    EXPECT_TRUE(sewInRow(design, {longOne, 0, 2}, twice, false, &why).empty());
}

TEST_F(SeamEdits, RightSidesMeet)
{
    EXPECT_TRUE(usuallyReversed(design, {longOne, 0, 2}, {two, 2, 3}));
    EXPECT_FALSE(usuallyReversed(design, {longOne, 0, 2}, {turned, 1, 2})) << "that one runs clockwise";
    EXPECT_TRUE(usuallyReversed(design, {longOne, 0, 2}, {longOne, 3, 4}));
    for (const ElementId partner : {two, turned}) {
        const Stretch b{partner, 0, 1};
        const Design good =
            design.with(addSeam(design, {longOne, 0, 2}, b, usuallyReversed(design, {longOne, 0, 2}, b)));
        for (const Problem& problem : checkDesign(good))
            EXPECT_NE(problem.field, "reversed") << problem.english();
    }
}

TEST_F(SeamEdits, SewsInARowInProportion)
{
    const std::array row = {Stretch{one, 2, 3}, Stretch{two, 2, 3}, Stretch{three, 2, 3}};
    const Edit edit = sewInRow(design, {longOne, 0, 2}, row, false);
    ASSERT_EQ(edit.changes.size(), 3U);
    EXPECT_EQ(edit.verb.english(), "Sew Long to 3 stretches in a row");
    expectSeam(seamOf(edit, 0), Seam{{longOne, 0, 0.5}, {one, 2, 3}, true});
    expectSeam(seamOf(edit, 1), Seam{{longOne, 0.5, 1.5}, {two, 2, 3}, true});
    expectSeam(seamOf(edit, 2), Seam{{longOne, 1.5, 2}, {three, 2, 3}, true});
    expectUndone(edit);

    const std::array backwards = {row[2], row[1], row[0]};
    EXPECT_EQ(design.with(sewInRow(design, {longOne, 0, 2}, backwards, false)), design.with(edit))
        << "the layout shows the order";
    const Edit flipped = sewInRow(design, {longOne, 0, 2}, row, true);
    expectSeam(seamOf(flipped, 0), Seam{{longOne, 0, 0.5}, {three, 2, 3}, false});
}

TEST_F(SeamEdits, ARowOfOneOutlineFollowsIt)
{
    const std::array row = {Stretch{steps, 0, 1}, Stretch{steps, 1, 2}, Stretch{steps, 2, 3}};
    const Edit edit = sewInRow(design, {longOne, 0, 2}, row, false);
    ASSERT_EQ(edit.changes.size(), 3U);
    EXPECT_EQ(seamOf(edit, 0).b, row[2]) << "walked backwards";
    EXPECT_EQ(seamOf(edit, 2).b, row[0]);
    const std::array passing = {Stretch{steps, 0, 1}, Stretch{steps, 5, 6}};
    EXPECT_EQ(seamOf(sewInRow(design, {longOne, 0, 2}, passing, false), 0).b, passing[0]);
}

TEST_F(SeamEdits, FlipsSwapsAndChangesSeveral)
{
    const Design both = design.with(addSeam(design, {longOne, 0, 2}, {three, 2, 3}, true));
    const ElementId added{21};
    const std::array seams = {sewn, added, longOne};
    const Edit flip = flipSeams(both, seams);
    EXPECT_EQ(flip.verb.english(), "Flip 2 seams");
    EXPECT_FALSE(both.with(flip).find<Seam>(added)->reversed);
    EXPECT_EQ(both.with(flip).with(flip.inverse()), both);
    EXPECT_EQ(flipSeams(both, std::array{sewn}).verb.english(), "Flip One \u2013 Two");

    const Edit swap = swapSeamSides(both, std::array{added});
    EXPECT_EQ(*both.with(swap).find<Seam>(added), (Seam{{three, 2, 3}, {longOne, 0, 2}, true}));

    const Edit smooth = setContinuity(both, seams, Continuity::G1);
    EXPECT_EQ(smooth.changes.size(), 2U);
    EXPECT_EQ(both.with(smooth).find<Seam>(sewn)->continuity, Continuity::G1);
    EXPECT_TRUE(setContinuity(both.with(smooth), seams, Continuity::G1).empty());
    EXPECT_EQ(both.with(smooth).with(smooth.inverse()), both);
    EXPECT_EQ(both.with(setMatch(both, seams, Match::Parameter)).find<Seam>(added)->match, Match::Parameter);
}

TEST_F(SeamEdits, MovesTheEndsOfAStretch)
{
    const Edit edit = dragStretchEnd(design, sewn, SeamSide::A, StretchEnd::To, 2.5);
    EXPECT_EQ(seamOf(edit).a, (Stretch{one, 1, 2.5}));
    EXPECT_FALSE(brokenBy(design, edit));
    expectUndone(edit);
    const Design both = design.with(addSeam(design, {one, 2, 3}, {longOne, 0, 2}, true));
    EXPECT_TRUE(brokenBy(both, dragStretchEnd(both, sewn, SeamSide::A, StretchEnd::To, 2.5)));
    EXPECT_EQ(seamOf(dragStretchEnd(design, sewn, SeamSide::B, StretchEnd::From, 2)).b, (Stretch{two, 2, 4}));
}

} // namespace
} // namespace bolster
