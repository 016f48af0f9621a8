#include "CurveEdits.h"
#include "DesignCheck.h"
#include "EarlierPieces.h"
#include "ElementEdits.h"
#include "PatchEdits.h"
#include "ScanEdits.h"

#include "Random.h"
#include "TestData.h"

namespace bolster {
namespace {

using namespace edits;

constexpr const char* smallDesign = R"({"format": "bolster-design", "version": 1, "unit": "mm", "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [10, 20],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,480],[0,480]]}},
  {"id": 6, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 0],
   "outline": {"degree": 1, "closed": true, "points": [[0,0],[120,0],[120,480],[0,480]]}},
  {"id": 3, "kind": "fixation_curve", "name": "Front rail",
   "curve": {"degree": 3, "closed": false, "points": [[0,0,0],[150,0,20],[300,0,20],[500,0,0]]}},
  {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
  {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 6, "from": 3, "to": 4}},
  {"id": 8, "kind": "nonsense"}]})";

constexpr ElementId leather{1}, seat{2}, rail{3}, fixation{4}, seam{5}, side{6}, unreadable{8};

class Edits : public testing::Test {
protected:
    const Design design = readDesign(smallDesign).design;
};

TEST_F(Edits, MovesOutlinePoints)
{
    const std::vector<int> points = {1, 2, 2};
    const Edit edit = movePatchPoints(design, seat, points, Vec2(5, -3));
    const auto& moved = design.with(edit).find<Patch>(seat)->outline;
    EXPECT_EQ(moved.points(), (std::vector<Vec2>{{0, 0}, {505, -3}, {505, 477}, {0, 480}}));
    EXPECT_EQ(edit.verb.english(), "Move 3 points of Seat");
    EXPECT_EQ(movePatchPoints(design, seat, std::vector<int>{1}, Vec2(5, 0)).verb.english(),
              "Move a point of Seat");
    EXPECT_EQ(design.with(edit).with(edit.inverse()), design);
}

/// The groups of a file have "_" for the spaces of names.
TEST(EarlierPieces, AreThoseOfTheSameNamesAsFilesHaveThem)
{
    const auto patches = [](const std::vector<std::string>& names) {
        Design design;
        std::int32_t id = 0;
        for (const std::string& name : names) {
            Patch patch;
            patch.name = name;
            design = design.with({{}, {{ElementId{++id}, nullptr, makeElement(std::move(patch))}}});
        }
        return design;
    };
    EXPECT_EQ(earlierPieces(patches({"Back top", "Back side 2", "Back bottom", "Front"}),
                            patches({"Back_top", "Back_side", "Back bottom_3"})),
              (std::vector<ElementId>{ElementId{1}, ElementId{2}, ElementId{3}}));
}

TEST(EarlierPieces, LeaveTheirPlacesToTheNewOnes)
{
    const auto square = [](const std::string& name, double width, const Vec2& position) {
        Patch patch;
        patch.name = name;
        patch.outline = BSpline2(1, true, {{0, 0}, {width, 0}, {width, width}, {0, width}});
        patch.position = position;
        return patch;
    };
    const auto designOf = [](std::vector<Patch> patches) {
        Design design;
        for (Patch& patch : patches)
            design = design.with({{}, {{design.nextId(), nullptr, makeElement(std::move(patch))}}});
        return design;
    };
    const Design before = designOf({square("Back top", 100, {1000, 0}), square("Front", 100, {2000, 0})});
    const std::optional<Design> placed =
        withEarlierPlaces(before, designOf({square("Back_top", 110, {0, 0}), square("Front", 90, {0, -400})}));
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->find<Patch>(ElementId{1})->position, Vec2(995, -5));
    EXPECT_EQ(placed->find<Patch>(ElementId{2})->position, Vec2(2005, 5));
    EXPECT_FALSE(withEarlierPlaces(before, designOf({square("Front", 300, {0, 0})})))
        << "it would lie on its neighbours";
    EXPECT_FALSE(withEarlierPlaces(before, designOf({square("Side", 100, {0, 0})})));
}

TEST_F(Edits, ImpossibleMovesAreEmpty)
{
    const std::vector<int> point = {0};
    EXPECT_TRUE(movePatchPoints(design, seat, point, Vec2(0, 0)).empty());
    EXPECT_TRUE(movePatchPoints(design, seat, std::vector<int>{17, -1}, Vec2(1, 0)).empty());
    EXPECT_TRUE(movePatchPoints(design, leather, point, Vec2(1, 0)).empty());
    EXPECT_TRUE(movePatchPoints(design, ElementId{99}, point, Vec2(1, 0)).empty());
    EXPECT_TRUE(movePatchPoints(design, seat, point, Vec2(2e7, 0)).empty()) << "out of the sensible range";
    EXPECT_TRUE(movePatchPoints(design, seat, point, Vec2(std::nan(""), 0)).empty());
    EXPECT_TRUE(moveCurvePoints(design, rail, point, Vec3(0, std::nan(""), 0)).empty());
    EXPECT_TRUE(movePatches(design, std::vector{seat}, Vec2(std::nan(""), 0)).empty());
    EXPECT_TRUE(turnPatches(design, std::vector{seat}, Vec2(0, 0), std::nan("")).empty());
    EXPECT_TRUE(insertPatchPoint(design, seat, std::nan("")).empty());
    EXPECT_TRUE(insertPatchPoint(design, seat, 1).empty()) << "there is a corner already";
    EXPECT_TRUE(removePatchPoint(design, seat, 4).empty());
    EXPECT_TRUE(removeCurvePoint(design, rail, 1).empty()) << "a cubic needs its four points";
}

TEST_F(Edits, MovesPointsOfFixationCurves)
{
    const Edit edit = moveCurvePoints(design, rail, std::vector<int>{1, 2}, Vec3(0, 0, 10));
    EXPECT_EQ(design.with(edit).find<FixationCurve>(rail)->curve.points()[2], Vec3(300, 0, 30));
    EXPECT_EQ(edit.verb.english(), "Move 2 points of Front rail");
}

TEST_F(Edits, InsertingAPointChangesNoShapeAndNoSeam)
{
    const Edit edit = insertPatchPoint(design, seat, 1.25);
    const Design after = design.with(edit);
    const BSpline2& before = design.find<Patch>(seat)->outline;
    const BSpline2& finer = after.find<Patch>(seat)->outline;
    EXPECT_EQ(finer.pointCount(), 5);
    for (double t = 0; t < 4; t += 0.05)
        EXPECT_LT((finer.at(t) - before.at(t)).norm(), 1e-10);
    EXPECT_EQ(checkDesign(after), checkDesign(design));
    EXPECT_EQ(edit.changes.size(), 1u);
    const Edit curve = insertCurvePoint(design, rail, 0.5);
    EXPECT_EQ(design.with(curve).find<FixationCurve>(rail)->curve.pointCount(), 5);
}

TEST_F(Edits, RemovingAnyPointKeepsStretchesValid)
{
    for (int i = 0; i < 4; ++i) {
        const Design after = design.with(removePatchPoint(design, seat, i));
        EXPECT_EQ(after.find<Patch>(seat)->outline.pointCount(), 3);
        EXPECT_EQ(after.find<Patch>(seat)->outline.period(), 4);
        for (const Problem& problem : checkDesign(after))
            EXPECT_TRUE(problem.severity == Severity::Warning || problem.element == unreadable)
                << problem.english();
        const ReadDesign read = readDesign(writeDesign(after));
        EXPECT_EQ(read.design, after);
    }
}

TEST_F(Edits, MovesAndTurnsPatchesInTheLayout)
{
    const std::vector<ElementId> both = {seat, side, leather};
    const Design moved = design.with(movePatches(design, both, Vec2(1, 2)));
    EXPECT_EQ(moved.find<Patch>(seat)->position, Vec2(11, 22));
    EXPECT_EQ(moved.find<Patch>(side)->position, Vec2(601, 2));
    const Vec2 corner = toLayout(*design.find<Patch>(seat), Vec2(500, 0));
    const Design turned = design.with(turnPatches(design, both, Vec2(10, 20), 90));
    EXPECT_LT((toLayout(*turned.find<Patch>(seat), Vec2(500, 0)) - Vec2(10, 520)).norm(), 1e-9);
    EXPECT_EQ(corner, Vec2(510, 20));
    EXPECT_EQ(turned.find<Patch>(seat)->outline, design.find<Patch>(seat)->outline);
    EXPECT_TRUE(movePatches(design, both, Vec2(0, 0)).empty());
    EXPECT_TRUE(turnPatches(design, both, Vec2(0, 0), 0).empty());
    EXPECT_EQ(movePatches(design, std::vector{seat}, Vec2(1, 0)).verb.english(), "Move Seat");
}

TEST_F(Edits, AddsUnderAFreshId)
{
    Fabric wool;
    wool.name = "Wool";
    const Edit edit = addElement(design, makeElement(wool));
    ASSERT_EQ(edit.changes.size(), 1u);
    EXPECT_EQ(edit.changes[0].id, ElementId{9});
    EXPECT_EQ(edit.changes[0].before, nullptr);
    EXPECT_EQ(edit.verb.english(), "Add fabric Wool");
    EXPECT_TRUE(addElement(design, nullptr).empty());
    EXPECT_TRUE(addElement(design, makeElement(Settings{})).empty());
}

TEST_F(Edits, NoTwoOfAKindGetTheSameName)
{
    Design now = design;
    Patch back;
    back.name = "Back";
    const auto add = [&] {
        now = now.with(addElement(now, makeElement(back)));
        return std::prev(now.elements().end())->first;
    };
    const ElementId first = add(), second = add();
    const auto nameAfter = [&](const Edit& edit, ElementId id) { return now.with(edit).find<Patch>(id)->name; };
    EXPECT_TRUE(renameElement(now, second, "Back").empty()) << "as it came";
    const Edit taken = renameElement(now, second, "Seat");
    EXPECT_EQ(nameAfter(taken, second), "Seat 2");
    EXPECT_EQ(taken.note.english(), "There is a \"Seat\" already: this one is called \"Seat 2\".");
    EXPECT_EQ(taken.verb.english(), "Rename Back to Seat 2");
    now = now.with(taken);
    EXPECT_TRUE(renameElement(now, second, "Seat").empty()) << "it has the next free one";
    EXPECT_FALSE(renameElement(now, second, "Seat").note.empty());
    EXPECT_EQ(nameAfter(renameElement(now, first, "Seat"), first), "Seat 3");
    EXPECT_EQ(nameAfter(renameElement(now, first, ""), first), "");
}

TEST_F(Edits, ReplacesAndRenames)
{
    const Edit edit = renameElement(design, seat, "Cushion");
    EXPECT_EQ(design.with(edit).find<Patch>(seat)->name, "Cushion");
    EXPECT_EQ(edit.verb.english(), "Rename Seat to Cushion");
    EXPECT_TRUE(edit.note.empty());
    EXPECT_TRUE(renameElement(design, seat, "Seat").empty());
    EXPECT_TRUE(renameElement(design, seam, "A seam has no name").empty());
    EXPECT_TRUE(replaceElement(design, seat, design.element(seat), {"Replace"}).empty());
    EXPECT_TRUE(replaceElement(design, ElementId{99}, design.element(seat), {"Replace"}).empty());
    EXPECT_TRUE(replaceElement(design, settingsId, design.element(seat), {"Replace"}).empty());
    Settings settings;
    settings.edgeLength = 8;
    EXPECT_EQ(design.with(changeSettings(design, settings)).settings().edgeLength, 8);
    EXPECT_TRUE(changeSettings(design, design.settings()).empty());
}

TEST_F(Edits, AnyElementHasANote)
{
    for (const auto& [id, element] : design.elements()) {
        if (id == unreadable)
            continue;
        const Edit edit = changeNote(design, id, "  ask Anna\nabout this \n\n");
        ASSERT_FALSE(edit.empty()) << kindName(*element);
        const Design noted = design.with(edit);
        EXPECT_EQ(elementNote(*noted.element(id)), "ask Anna\nabout this") << kindName(*element);
        EXPECT_TRUE(changeNote(noted, id, "ask Anna\nabout this\n").empty()) << "the same";
        EXPECT_EQ(noted.with(changeNote(noted, id, " \n")), design) << "and gone";
    }
    EXPECT_EQ(changeNote(design, seat, "x").verb.english(), "Change the note of Seat");
    EXPECT_TRUE(changeNote(design, ElementId{99}, "x").empty());
}

TEST_F(Edits, RemovesWhatRefersToTheRemoved)
{
    const auto removed = [&](std::vector<ElementId> ids) {
        std::set<ElementId> gone;
        for (const Change& change : removeElements(design, ids).changes)
            gone.insert(change.id);
        return gone;
    };
    EXPECT_EQ(removed({side}), (std::set{side, seam}));
    EXPECT_EQ(removed({seat}), (std::set{seat, seam, fixation}));
    EXPECT_EQ(removed({rail}), (std::set{rail, fixation}));
    EXPECT_EQ(removed({seam}), (std::set{seam}));
    EXPECT_EQ(removed({unreadable}), (std::set{unreadable}));
    EXPECT_EQ(removed({leather}), std::set<ElementId>{}) << "in use";
    EXPECT_EQ(removed({leather, side}), (std::set{side, seam})) << "still in use";
    EXPECT_EQ(removed({leather, side, seat}), (std::set{leather, seat, side, seam, fixation}));
    EXPECT_EQ(removed({settingsId, ElementId{77}}), std::set<ElementId>{});
    EXPECT_EQ(removeElements(design, std::vector{unreadable}).changes.size(), 1U);
    EXPECT_EQ(removeElements(design, std::vector{leather, side, seat}).verb.english(), "Remove 5 elements");
    EXPECT_EQ(removeElements(design, std::vector{side}).verb.english(), "Remove Side and what is sewn to it");
    EXPECT_EQ(removeElements(design, std::vector{seat}).verb.english(), "Remove Seat and 2 seams and fixations");
}

TEST_F(Edits, RemovesCushionsWithTheirFrameAndFoamWithItsCushion)
{
    Frame frame;
    frame.name = "Chair";
    const ElementId chair = design.nextId();
    Design padded = design.with(addElement(design, makeElement(frame)));
    Cushion cushion;
    cushion.frame = chair;
    cushion.patches = {seat, side};
    const ElementId padding = padded.nextId();
    padded = padded.with(addElement(padded, makeElement(cushion)));
    Foam foam;
    foam.cushion = padding;
    const ElementId wedge = padded.nextId();
    padded = padded.with(addElement(padded, makeElement(foam)));

    const Design bare = padded.with(removeElements(padded, std::vector{chair}));
    EXPECT_FALSE(bare.element(padding));
    EXPECT_FALSE(bare.element(wedge));
    const Design narrower = padded.with(removeElements(padded, std::vector{side}));
    ASSERT_TRUE(narrower.find<Cushion>(padding));
    EXPECT_EQ(narrower.find<Cushion>(padding)->patches, std::vector{seat});
    const Design none = padded.with(removeElements(padded, std::vector{side, seat}));
    EXPECT_FALSE(none.element(padding)) << "it would push everything else";
}

// Any edit at all, valid or not.
Edit randomEdit(test::Random& random, const Design& design)
{
    const ElementId id{random.whole(0, number(design.nextId()))};
    const std::vector<ElementId> ids = {id, ElementId{random.whole(1, 20)}};
    const std::vector<int> points = {random.whole(-1, 40), random.whole(0, 5)};
    switch (random.whole(0, 9)) {
    case 0:
        return movePatchPoints(design, id, points, test::randomPoint<2>(random, 30));
    case 1:
        return insertPatchPoint(design, id, random.real(-5, 50));
    case 2:
        return removePatchPoint(design, id, points[0]);
    case 3:
        return moveCurvePoints(design, id, points, test::randomPoint<3>(random, 30));
    case 4:
        return insertCurvePoint(design, id, random.real(-1, 10));
    case 5:
        return removeCurvePoint(design, id, points[1]);
    case 6:
        return movePatches(design, ids, test::randomPoint<2>(random, 30));
    case 7:
        return turnPatches(design, ids, test::randomPoint<2>(random, 30), random.real(-90, 90));
    case 8:
        return random.chance(0.1) ? removeElements(design, ids) : renameElement(design, id, "%1 renamed");
    default: {
        const ElementPtr element = design.element(id);
        return addElement(design, element ? element : makeElement(Fabric{}));
    }
    }
}

TEST(RandomEdits, AreUndoneByTheirInverseAndSurviveTheTextForm)
{
    test::Random random(11);
    const Design start = test::soundDesign(test::designText("car-seat-tied"));
    Design design = start;
    std::vector<std::pair<Design, Edit>> history;
    for (int i = 0; i < 1500; ++i) {
        const Edit edit = randomEdit(random, design);
        if (edit.empty())
            continue;
        for (const Change& change : edit.changes)
            EXPECT_EQ(change.before, change.id == settingsId ? change.before : design.element(change.id));
        EXPECT_FALSE(edit.verb.empty());
        history.emplace_back(design, edit);
        design = design.with(edit);
        EXPECT_TRUE(i % 50 != 0 || readDesign(writeDesign(design)).design == design);
    }
    EXPECT_GT(history.size(), 300u);
    for (auto step = history.rbegin(); step != history.rend(); ++step) {
        design = design.with(step->second.inverse());
        ASSERT_EQ(design, step->first);
    }
    EXPECT_EQ(writeDesign(design), writeDesign(start));
}

TEST(ScanEdits, CutInDesignCoordinatesWhateverThePlacement)
{
    const ElementId id{3};
    Scan scan;
    scan.name = "Room";
    scan.scale = 1000;
    scan.position = {100, -200, 300};
    scan.rotation = Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()));
    Design design = Design().with({{}, {{id, nullptr, makeElement(scan)}}});
    EXPECT_FALSE(edits::floorOf(scan));

    design = design.with(edits::cutFloor(design, id, 40));
    design = design.with(edits::cutFloor(design, id, 25)); // instead of the first one
    const auto now = [&] { return *design.find<Scan>(id); };
    ASSERT_EQ(now().cuts.size(), 1u);
    EXPECT_NEAR(edits::floorOf(now()).value(), 25, 1e-9);
    const auto gone = [&](const Vec3& at) { return now().isCutAway(now().filePoint(at)); };
    EXPECT_TRUE(gone({500, 0, 24}));
    EXPECT_FALSE(gone({500, 0, 26}));

    design =
        design.with(edits::addCut(design, id, edits::boxCut(now(), Box3(Vec3(0, 0, 0), Vec3(10, 20, 30)), true)));
    EXPECT_FALSE(gone({5, 19, 29}));
    EXPECT_TRUE(gone({5, 21, 29}));
    EXPECT_TRUE(gone({5, 19, 20})) << "the floor";
    design = design.with(edits::removeCuts(design, id));
    EXPECT_EQ(now(), scan);
    EXPECT_TRUE(edits::cutFloor(design, ElementId{99}, 1).empty());
}

} // namespace
} // namespace bolster
