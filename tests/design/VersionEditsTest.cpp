#include "VersionEdits.h"

#include "DesignCheck.h"
#include "DesignJson.h"
#include "ElementEdits.h"
#include "TestData.h"

#include <gtest/gtest.h>

namespace bolster::versions { // names that other tests have, too
namespace {

constexpr ElementId leather{1}, seat{2}, side{6}, rail{3}, held{4}, sewn{5};

/// Two patches with a seam and a fixation, as in docs/design-json.md.
Design twoPatches()
{
    return readDesign(R"({"format": "bolster-design", "version": 1, "unit": "mm", "settings": {"edge_length": 12},
        "elements": [
        {"id": 1, "kind": "fabric", "name": "Leather"},
        {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1,
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,480],[0,480]]}},
        {"id": 3, "kind": "fixation_curve", "name": "Rail",
         "curve": {"degree": 1, "closed": false, "points": [[0,0,0],[500,0,0]]}},
        {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
        {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 6, "from": 3, "to": 4},
         "reversed": true},
        {"id": 6, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 0],
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[120,0],[120,480],[0,480]]}}]})")
        .design;
}

Design withPatch(const Design& design, ElementId id, const std::function<void(Patch&)>& change)
{
    Patch patch = *design.find<Patch>(id);
    change(patch);
    return design.with(edits::replaceElement(design, id, makeElement(patch), {}));
}

TEST(VersionEdits, TellWhatDiffersByElementAndField)
{
    const Design a = twoPatches();
    EXPECT_TRUE(differencesBetween(a, a).empty());
    const Design b = withPatch(a, side, [](Patch& patch) {
        patch.name = "Flank";
        patch.pressure = 2;
    });
    const auto found = differencesBetween(a, b);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].element, side);
    EXPECT_EQ(found[0].kind, Difference::Kind::Changed);
    const std::vector<Difference::Field> expected{{"name", "\"Side\"", "\"Flank\""}, {"pressure", "", "2"}};
    EXPECT_EQ(found[0].fields, expected);

    const Design c = a.with(edits::removeElements(a, std::array{rail}));
    const auto gone = differencesBetween(a, c);
    ASSERT_EQ(gone.size(), 2U);
    EXPECT_EQ(gone[0].kind, Difference::Kind::Removed);
    EXPECT_EQ(differencesBetween(c, a)[0].kind, Difference::Kind::Added);
}

/// Two branches have given one number to a seam and to a frame.
TEST(VersionEdits, WhatOnlySharesItsNumberIsAnotherThing)
{
    const Design other = twoPatches();
    const Design design = [&] {
        const Design bare = other.with(edits::removeElements(other, std::array{sewn}));
        Frame chair;
        chair.name = "Chair";
        chair.file = "chair.obj";
        return bare.with({{}, {{sewn, nullptr, makeElement(chair)}}});
    }();
    const Design apart = numberedApart(design, other);
    EXPECT_TRUE(numberedApart(design, design) == design);
    const auto found = differencesBetween(apart, design);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].element, sewn);
    EXPECT_EQ(found[0].kind, Difference::Kind::Added);
    EXPECT_EQ(found[1].kind, Difference::Kind::Removed);
    const Design now = design.with(edits::takeFrom(design, apart, {found[1].element}));
    EXPECT_TRUE(now.find<Frame>(sewn)) << "nobody has asked to take it away";
    EXPECT_TRUE(now.find<Seam>(found[1].element));
    const Design without = design.with(edits::takeFrom(design, apart, {sewn}));
    EXPECT_FALSE(without.element(sewn));
}

TEST(VersionEdits, ATakenPatchBringsWhatLiesOnIt)
{
    const Design other = twoPatches();
    const Design design = other.with(edits::removeElements(other, std::array{seat, rail}));
    ASSERT_FALSE(design.element(sewn));
    const Edit edit = edits::takeFrom(design, other, {seat});
    EXPECT_EQ(edit.verb.english(), "Take Seat from another version");
    const Design now = design.with(edit);
    EXPECT_TRUE(now.element(seat));
    EXPECT_TRUE(now.element(sewn));
    EXPECT_FALSE(now.element(held)) << "its curve is not there, and nobody asked for it";
    for (const Problem& problem : checkDesign(now))
        EXPECT_NE(problem.severity, Severity::Error) << problem.english(); // that it floats is only a warning
    EXPECT_TRUE(now.with(edit.inverse()) == design);
}

TEST(VersionEdits, WhatIsNeededComesAlong)
{
    const Design other = twoPatches();
    const Design design = other.with(edits::removeElements(other, std::array{seat, rail}));
    const Design now = design.with(edits::takeFrom(design, other, {held}));
    EXPECT_TRUE(now.element(held) && now.element(rail) && now.element(seat));
    EXPECT_TRUE(checkDesign(now).empty());
}

TEST(VersionEdits, ACushionBringsThePatchesThatItPushes)
{
    constexpr ElementId frame{7}, cushion{8};
    Frame chair;
    chair.file = "chair.obj";
    Cushion padding;
    padding.frame = frame;
    padding.patches = {seat, side};
    const Design other =
        twoPatches().with({{}, {{frame, nullptr, makeElement(chair)}, {cushion, nullptr, makeElement(padding)}}});
    const Design design = other.with(edits::removeElements(other, std::array{side, frame, cushion}));
    const Design now = design.with(edits::takeFrom(design, other, {cushion}));
    EXPECT_TRUE(now.element(side) && now.element(frame));
    ASSERT_TRUE(now.element(cushion));
    EXPECT_EQ(now.find<Cushion>(cushion)->patches, padding.patches);
    for (const Problem& problem : checkDesign(now))
        EXPECT_NE(problem.severity, Severity::Error) << problem.english();
}

TEST(VersionEdits, SeamsFitTheOutlineThatIsTaken)
{
    const Design design = twoPatches();
    const Design other = withPatch(design, seat, [](Patch& patch) {
        patch.outline = BSpline2(1, true, {{0, 0}, {500, 0}, {500, 480}}); // has no edge from 3 to 4
    });
    const Design now = design.with(edits::takeFrom(design, other, {seat}));
    EXPECT_TRUE(now.find<Patch>(seat)->outline == other.find<Patch>(seat)->outline);
    EXPECT_EQ(now.find<Patch>(side)->name, "Side");
}

TEST(VersionEdits, TakingAnAbsenceRemoves)
{
    const Design design = twoPatches();
    const Design other = design.with(edits::removeElements(design, std::array{side}));
    const Design now = design.with(edits::takeFrom(design, other, {side}));
    EXPECT_TRUE(now == other);
    EXPECT_TRUE(edits::takeFrom(design, design, {side}).empty());
}

} // namespace
} // namespace bolster::versions
