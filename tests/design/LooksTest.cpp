// What is only seen: looks of fabrics, colourways, trims. Text form, rules, and edits.
#include "ColourwayEdits.h"
#include "CopyPaste.h"
#include "DesignCheck.h"
#include "EditCheck.h"
#include "ElementEdits.h"
#include "FabricShown.h"
#include "PatchMerge.h"
#include "PatchSplit.h"
#include "SeamEdits.h"
#include "TrimEdits.h"
#include "TwinEdits.h"
#include "Twins.h"
#include "VersionEdits.h"

#include "TestData.h"

#include <array>
#include <numbers>

namespace bolster::looks { // names that other tests have, too
namespace {

using namespace edits;

// In the form in which it is written.
constexpr const char* trimmedDesign = R"({"format": "bolster-design", "version": 1, "unit": "mm",
 "settings": {"edge_length": 12, "colourway": 20},
 "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather", "look": {"kind": "grained_leather", "second_color": "#402010", "roughness": 0.25, "scale_mm": 3.5, "rotation": 90, "relief": 1.5}, "limits": {"along": 5, "across": 12, "shear": 4.5}},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "outline": {"degree": 1, "closed": true, "points": [[0, 0], [500, 0], [500, 400], [0, 400]]}},
  {"id": 3, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 0], "outline": {"degree": 1, "closed": true, "points": [[0, 0], [120, 0], [120, 400], [0, 400]]}},
  {"id": 4, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 3, "from": 3, "to": 4}, "trim": {"stitch": "twin", "thread": "#ffffff", "stitch_length_mm": 4, "stitch_distance_mm": 6, "thread_width_mm": 1.2, "piping_radius_mm": 3, "piping_fabric": 10, "allowance_mm": 10, "valley": false}},
  {"id": 5, "kind": "fixation_curve", "name": "Rail", "curve": {"degree": 1, "closed": false, "points": [[0, 0, 0], [500, 0, 0]]}},
  {"id": 6, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 5, "trim": {"piping_radius_mm": 4}},
  {"id": 7, "kind": "fancy_seam", "name": "Pipe", "patch": 2, "curve": {"degree": 1, "closed": false, "points": [[100, 50], [100, 350]]}, "trim": {"stitch": "single"}},
  {"id": 8, "kind": "outline_trim", "patch": 2, "from": 2, "to": 3, "trim": {"stitch": "single", "stitch_distance_mm": 8}},
  {"id": 10, "kind": "fabric", "name": "Photo", "color": "#336699", "look": {"kind": "image", "scale_mm": 350, "file": "images/wool.png"}},
  {"id": 11, "kind": "fabric", "name": "Wool"},
  {"id": 20, "kind": "colourway", "name": "Blue", "fabrics": [{"patch": 2, "fabric": 10}]},
  {"id": 21, "kind": "colourway", "name": "Plain"}]}
)";

constexpr ElementId leather{1}, seat{2}, side{3}, seam{4}, rail{5}, fixation{6}, pipe{7}, edge{8}, photo{10},
    wool{11}, blue{20}, plain{21};

class LooksTest : public testing::Test {
protected:
    /// As a document does.
    void apply(const Edit& edit)
    {
        const Edit whole = withTwins(design, edit);
        ASSERT_FALSE(whole.empty());
        ASSERT_FALSE(whole.verb.empty());
        const Design after = design.with(whole);
        ASSERT_EQ(writeDesign(after.with(whole.inverse())), writeDesign(design)) << "undo";
        ASSERT_EQ(writeDesign(readDesign(writeDesign(after)).design), writeDesign(after)) << "round trip";
        design = after;
        expectSound(design);
    }
    static void expectSound(const Design& design)
    {
        for (const Problem& problem : checkDesign(design))
            EXPECT_NE(problem.severity, Severity::Error) << problem.english();
    }

    template <class T>
    const T& get(ElementId id) const
    {
        static const T none{};
        const T* found = design.find<T>(id);
        EXPECT_TRUE(found) << number(id);
        return found ? *found : none;
    }
    template <class T>
    std::vector<T> all() const
    {
        std::vector<T> found;
        design.each<T>([&](ElementId, const T& value) { found.push_back(value); });
        return found;
    }

    Design design = test::soundDesign(trimmedDesign);
};

SeamTrim singleStitch()
{
    SeamTrim trim;
    trim.stitch = SeamTrim::Stitch::Single;
    trim.stitchLength = 7;
    return trim;
}

TEST_F(LooksTest, EveryFieldIsReadAndWrittenInItsPlace)
{
    EXPECT_EQ(writeDesign(design), trimmedDesign);
    const FabricLook& look = get<Fabric>(leather).look;
    EXPECT_EQ(look.kind, FabricLook::Kind::GrainedLeather);
    EXPECT_EQ(look.secondColor, "#402010");
    EXPECT_EQ(look.roughness, 0.25);
    EXPECT_EQ(look.scale, 3.5);
    EXPECT_EQ(look.rotation, 90);
    EXPECT_EQ(look.relief, 1.5);
    EXPECT_EQ(get<Fabric>(leather).limits, (StretchLimits{5, 12, 4.5}));
    const SeamTrim& trim = get<Seam>(seam).trim;
    EXPECT_EQ(trim.stitch, SeamTrim::Stitch::Twin);
    EXPECT_EQ(trim.thread, "#ffffff");
    EXPECT_EQ(trim.stitchLength, 4);
    EXPECT_EQ(trim.stitchDistance, 6);
    EXPECT_EQ(trim.threadWidth, 1.2);
    EXPECT_EQ(trim.pipingRadius, 3);
    EXPECT_EQ(trim.pipingFabric, photo);
    EXPECT_EQ(trim.allowance, 10);
    EXPECT_FALSE(trim.valley);
    EXPECT_EQ(get<OutlineTrim>(edge).stretch, (Stretch{seat, 2, 3}));
    EXPECT_EQ(*elementFile(*design.element(photo)), "images/wool.png");
    EXPECT_EQ(elementFile(*design.element(leather)), nullptr);
    EXPECT_EQ(*elementFile(*withFile(*design.element(photo), "other.png")), "other.png");
    EXPECT_FALSE(hasShapeFile(*design.element(photo)));
}

TEST_F(LooksTest, DefaultsDependOnTheKindAndAreNotWritten)
{
    Fabric fabric = get<Fabric>(wool);
    fabric.look = usualLook(FabricLook::Kind::Woven);
    apply(replaceElement(design, wool, makeElement(fabric), {"Weave"}));
    EXPECT_NE(writeDesign(design).find(R"("name": "Wool", "look": {"kind": "woven"}})"), std::string::npos);
    EXPECT_EQ(get<Fabric>(wool), fabric);
    fabric.look.scale = FabricLook().scale; // a default of another kind is none of this one
    apply(replaceElement(design, wool, makeElement(fabric), {"Weave"}));
    EXPECT_EQ(readDesign(writeDesign(design)).design.find<Fabric>(wool)->look, fabric.look);
}

TEST(ClothTurn, ClothLiesAlongTheGrainAndTurnsAsItsFabricAsks)
{
    Patch patch;
    Fabric fabric;
    EXPECT_EQ(clothTurn(patch, fabric), 0) << "a warp that runs along y";
    patch.grain = 0;
    EXPECT_NEAR(clothTurn(patch, fabric), -std::numbers::pi / 2, 1e-12);
    fabric.look.rotation = 45;
    EXPECT_NEAR(clothTurn(patch, fabric), -std::numbers::pi / 4, 1e-12);
}

struct BadLook {
    const char* good;
    const char* bad;
    int element;
    const char* field;
};

class BadLooks : public testing::TestWithParam<BadLook> {};

TEST_P(BadLooks, AreReportedWithElementAndFieldAndCostNothingElse)
{
    std::string text = trimmedDesign;
    const std::size_t place = text.find(GetParam().good);
    ASSERT_NE(place, std::string::npos);
    text.replace(place, std::string(GetParam().good).size(), GetParam().bad);
    const ReadDesign read = readDesign(text);
    ASSERT_TRUE(read.readable && read.problems.empty());
    EXPECT_EQ(writeDesign(read.design), text) << "it is kept as it is";
    const Problems problems = checkDesign(read.design);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(number(problems[0].element), GetParam().element);
    EXPECT_EQ(problems[0].field, GetParam().field);
    EXPECT_FALSE(problems[0].message.empty());

    Problems leftOut;
    const Design usable = usablePart(read.design, problems, &leftOut);
    EXPECT_FALSE(hasErrors(checkDesign(usable)));
    if (problems[0].severity == Severity::Warning)
        return;
    EXPECT_EQ(usable.elements().size(), read.design.elements().size()) << "looks never cost the shape";
    ASSERT_EQ(leftOut.size(), 1U);
    EXPECT_EQ(number(leftOut[0].element), GetParam().element);
    EXPECT_EQ(usable.find<Seam>(seam)->a, (Stretch{seat, 1, 2}));
}

INSTANTIATE_TEST_SUITE_P(
    Looks, BadLooks,
    testing::Values(
        BadLook{"#402010", "brown", 1, "look.second_color"},
        BadLook{"\"roughness\": 0.25", "\"roughness\": 1.25", 1, "look.roughness"},
        BadLook{"\"scale_mm\": 3.5", "\"scale_mm\": 0", 1, "look.scale_mm"},
        BadLook{"\"rotation\": 90", "\"rotation\": 1e+300", 1, "look.rotation"},
        BadLook{"\"relief\": 1.5", "\"relief\": 3", 1, "look.relief"},
        BadLook{"images/wool.png", "../wool.png", 10, "look.file"},
        BadLook{"\"along\": 5", "\"along\": 0", 1, "limits.along"},
        BadLook{"\"across\": 12", "\"across\": 201", 1, "limits.across"},
        BadLook{"\"shear\": 4.5", "\"shear\": -1", 1, "limits.shear"},
        BadLook{"#ffffff", "white", 4, "trim.thread"},
        BadLook{"\"stitch_length_mm\": 4", "\"stitch_length_mm\": 0", 4, "trim.stitch_length_mm"},
        BadLook{"\"stitch_distance_mm\": 6", "\"stitch_distance_mm\": -6", 4, "trim.stitch_distance_mm"},
        BadLook{"\"thread_width_mm\": 1.2", "\"thread_width_mm\": 0", 4, "trim.thread_width_mm"},
        BadLook{"\"piping_radius_mm\": 4", "\"piping_radius_mm\": 51", 6, "trim.piping_radius_mm"},
        BadLook{"\"piping_fabric\": 10", "\"piping_fabric\": 3", 4, "trim.piping_fabric"},
        BadLook{"\"allowance_mm\": 10", "\"allowance_mm\": 101", 4, "trim.allowance_mm"},
        BadLook{"\"patch\": 2, \"fabric\": 10", "\"patch\": 99, \"fabric\": 10", 20, "fabrics[0].patch"},
        BadLook{"\"patch\": 2, \"fabric\": 10", "\"patch\": 2, \"fabric\": 2", 20, "fabrics[0].fabric"},
        BadLook{"{\"patch\": 2, \"fabric\": 10}", "{\"patch\": 2, \"fabric\": 10}, {\"patch\": 2, \"fabric\": 11}",
                20, "fabrics[1].patch"},
        BadLook{"\"colourway\": 20", "\"colourway\": 4", 0, "colourway"}));

TEST_F(LooksTest, WhatCannotBeReadIsSetAsideWithThePlace)
{
    std::string text = trimmedDesign;
    text.replace(text.find("\"stitch\": \"twin\""), 16, "\"stitch\": \"zigzag\"");
    text.replace(text.find("grained_leather"), 15, "snake");
    text.replace(text.find("[{\"patch\": 2, \"fabric\": 10}]"), 28, "[2, {\"patch\": 2}]");
    const ReadDesign read = readDesign(text);
    ASSERT_TRUE(read.readable);
    std::set<std::string> fields;
    for (const Problem& problem : read.problems)
        fields.insert(problem.field);
    for (const char* field : {"trim.stitch", "look.kind", "fabrics[0]", "fabrics[1].fabric"})
        EXPECT_TRUE(fields.contains(field)) << field;
    EXPECT_EQ(writeDesign(read.design), text) << "nothing is lost";
}

TEST_F(LooksTest, ABadLookKeepsHowTheFabricBehaves)
{
    Fabric bad = get<Fabric>(leather);
    bad.stiffness = 7;
    bad.look.relief = 5;
    const Design spoilt = design.with(replaceElement(design, leather, makeElement(bad), {"Spoil"}));
    const Design usable = usablePart(spoilt, checkDesign(spoilt));
    EXPECT_EQ(usable.find<Fabric>(leather)->stiffness, 7);
    FabricLook look = get<Fabric>(leather).look;
    look.relief = usualLook(look.kind).relief;
    EXPECT_EQ(usable.find<Fabric>(leather)->look, look) << "what is not wrong stays";
}

TEST_F(LooksTest, ABadLookKeepsHowTheFabricIsCut)
{
    Fabric bad = get<Fabric>(leather);
    bad.cutting = {1200, 3, 1.5};
    bad.note = "Order in March";
    bad.color = "brown";
    const Design spoilt = design.with(replaceElement(design, leather, makeElement(bad), {"Spoil"}));
    Problems leftOut;
    const Design usable = usablePart(spoilt, checkDesign(spoilt), &leftOut);
    bad.color = Fabric{}.color;
    EXPECT_EQ(*usable.find<Fabric>(leather), bad);
    ASSERT_EQ(leftOut.size(), 1U);
    EXPECT_EQ(leftOut[0].field, "color");
}

TEST_F(LooksTest, WhatIsCutCostsNoShape)
{
    Patch patch = get<Patch>(seat);
    patch.cutting.quantity = -1;
    Fabric fabric = get<Fabric>(leather);
    fabric.stiffness = 7;
    fabric.cutting.width = -5;
    Design spoilt = design.with(replaceElement(design, seat, makeElement(patch), {"Spoil"}));
    spoilt = spoilt.with(replaceElement(spoilt, leather, makeElement(fabric), {"Spoil"}));
    ASSERT_TRUE(hasErrors(checkDesign(spoilt)));
    const Design usable = usablePart(spoilt, checkDesign(spoilt));
    ASSERT_TRUE(usable.find<Patch>(seat));
    EXPECT_EQ(usable.find<Patch>(seat)->cutting.quantity, PieceCutting{}.quantity);
    EXPECT_EQ(usable.find<Patch>(seat)->outline, patch.outline);
    EXPECT_EQ(usable.find<Fabric>(leather)->stiffness, 7);
    expectSound(usable);
}

TEST_F(LooksTest, APatchThatIsLeftOutTakesItsTrimAndItsColourAlong)
{
    Patch bad = get<Patch>(seat);
    bad.pressure = 1e9;
    const Design spoilt = design.with(replaceElement(design, seat, makeElement(bad), {"Spoil"}));
    const Design usable = usablePart(spoilt, checkDesign(spoilt));
    EXPECT_FALSE(usable.element(edge));
    EXPECT_TRUE(usable.find<Colourway>(blue)->fabrics.empty());
    expectSound(usable);
}

TEST_F(LooksTest, TheColourwayDecidesWhatIsShown)
{
    EXPECT_EQ(fabricShown(design, seat), photo);
    EXPECT_EQ(fabricShown(design, side), leather);
    EXPECT_EQ(fabricShown(design, seat, plain), leather);
    EXPECT_EQ(fabricShown(design, seat, noElement), leather);
    EXPECT_EQ(fabricShown(design, ElementId{99}), noElement);

    apply(showColourway(design, noElement));
    EXPECT_EQ(fabricShown(design, seat), leather);
    EXPECT_TRUE(showColourway(design, seat).empty()) << "a patch is none";
    apply(showColourway(design, blue));

    const ElementId added = design.nextId();
    apply(addColourway(design, "Blue"));
    EXPECT_EQ(get<Colourway>(added).name, "Blue 2");
    EXPECT_EQ(get<Colourway>(added).fabrics, get<Colourway>(blue).fabrics) << "begins with what is shown";
    EXPECT_EQ(design.settings().colourway, added);

    apply(setColourwayFabric(design, added, std::array{seat, side, rail}, wool));
    EXPECT_EQ(fabricShown(design, seat), wool);
    EXPECT_EQ(fabricShown(design, side), wool);
    EXPECT_EQ(get<Patch>(side).fabric, leather) << "mechanics are another matter";
    apply(setColourwayFabric(design, added, std::array{side}, noElement));
    EXPECT_EQ(fabricShown(design, side), leather);
    EXPECT_TRUE(setColourwayFabric(design, added, std::array{seat}, rail).empty());

    apply(assignFabric(design, std::array{seat, side}, wool));
    EXPECT_EQ(get<Patch>(seat).fabric, wool);
    EXPECT_EQ(fabricShown(design, side), wool);
    EXPECT_TRUE(assignFabric(design, std::array{seat}, rail).empty());
}

TEST_F(LooksTest, TrimsAreSetTogetherAndOutlinesGetTheirOwn)
{
    const std::array every = {seam, fixation, pipe, edge, seat};
    apply(setTrim(design, every, singleStitch()));
    for (const ElementId id : {seam, fixation, pipe, edge})
        EXPECT_EQ(*seamTrim(*design.element(id)), singleStitch());
    EXPECT_TRUE(setTrim(design, every, singleStitch()).empty()) << "nothing to change";

    const ElementId added = design.nextId();
    apply(addOutlineTrim(design, {side, 0, 1}, singleStitch()));
    EXPECT_EQ(get<OutlineTrim>(added).stretch, (Stretch{side, 0, 1}));
    Message why;
    EXPECT_TRUE(addOutlineTrim(design, {side, 0.5, 2}, singleStitch(), &why).empty());
    EXPECT_NE(why.english().find("has a trim already"), std::string::npos) << why.english();
    EXPECT_TRUE(addOutlineTrim(design, {side, 3, 4}, singleStitch(), &why).empty());
    EXPECT_NE(why.english().find("sewn"), std::string::npos) << why.english();
    EXPECT_TRUE(addOutlineTrim(design, {rail, 0, 1}, singleStitch(), &why).empty());

    apply(dragStretchEnd(design, added, SeamSide::A, StretchEnd::To, 1.5));
    EXPECT_EQ(get<OutlineTrim>(added).stretch, (Stretch{side, 0, 1.5}));
    apply(addOutlineTrim(design, {side, 2, 2.5}, singleStitch()));
    EXPECT_TRUE(brokenBy(design, dragStretchEnd(design, added, SeamSide::A, StretchEnd::To, 2.25)));
}

TEST_F(LooksTest, RemovingTakesAlongWhatRefersToIt)
{
    const Design start = design;
    apply(removeElements(design, std::array{photo}));
    EXPECT_FALSE(design.element(photo));
    EXPECT_EQ(get<Seam>(seam).trim.pipingFabric, ElementId{});
    EXPECT_EQ(get<Seam>(seam).trim.pipingRadius, 3) << "the piping stays";
    EXPECT_TRUE(get<Colourway>(blue).fabrics.empty());

    design = start;
    EXPECT_TRUE(removeElements(design, std::array{leather}).empty()) << "it is in use";
    apply(removeElements(design, std::array{seat}));
    EXPECT_FALSE(design.element(edge));
    EXPECT_FALSE(design.element(seam));
    EXPECT_TRUE(get<Colourway>(blue).fabrics.empty());

    design = start;
    apply(removeElements(design, std::array{blue}));
    EXPECT_EQ(design.settings().colourway, noElement);
    EXPECT_EQ(fabricShown(design, seat), leather);
}

TEST_F(LooksTest, SplittingAndMergingKeepTrimsAndColours)
{
    const Outcome split = splitPatch(design, seat, {{250, -10}, {250, 410}});
    ASSERT_TRUE(split.problem.empty()) << split.problem.english();
    apply(split.edit);
    const std::vector<OutlineTrim> edges = all<OutlineTrim>();
    ASSERT_EQ(edges.size(), 2U) << "the cut divides it";
    EXPECT_NE(edges[0].stretch.patch, edges[1].stretch.patch);
    EXPECT_EQ(edges[0].trim, edges[1].trim);
    EXPECT_EQ(get<Seam>(seam).trim.stitch, SeamTrim::Stitch::Twin);
    design.each<Patch>([&](ElementId id, const Patch&) {
        EXPECT_EQ(fabricShown(design, id), id == side ? leather : photo) << number(id);
    });

    ElementId cut{};
    design.each<Seam>([&](ElementId id, const Seam&) { cut = id == seam ? cut : id; });
    const Outcome merged = mergePatches(design, cut);
    ASSERT_TRUE(merged.problem.empty()) << merged.problem.english();
    apply(merged.edit);
    EXPECT_EQ(get<Colourway>(blue).fabrics.size(), 1U);
    EXPECT_EQ(all<OutlineTrim>().size(), 1U) << "as it was";
    EXPECT_EQ(get<Seam>(seam).trim.stitch, SeamTrim::Stitch::Twin);
}

TEST_F(LooksTest, CopiesKeepTrimsAndColours)
{
    apply(duplicatePatches(design, std::array{seat, side, rail}, Vec2(0, 900)));
    EXPECT_EQ(all<OutlineTrim>().size(), 2U);
    EXPECT_EQ(all<Fabric>().size(), 3U) << "no fabric twice";
    ASSERT_EQ(all<Seam>().size(), 2U);
    EXPECT_EQ(all<Seam>()[0].trim, all<Seam>()[1].trim);
    EXPECT_EQ(get<Colourway>(blue).fabrics.size(), 2U);

    const Outcome elsewhere = paste(Design(), copyText(design, std::array{seat, side}), Vec2(0, 0));
    const Design other = Design().with(elsewhere.edit);
    expectSound(other);
    int trims = 0;
    other.each<OutlineTrim>([&](ElementId, const OutlineTrim&) { ++trims; });
    EXPECT_EQ(trims, 1);
    other.each<Seam>([&](ElementId, const Seam& sewn) {
        ASSERT_TRUE(other.find<Fabric>(sewn.trim.pipingFabric));
        EXPECT_EQ(other.find<Fabric>(sewn.trim.pipingFabric)->name, "Photo");
    });
    other.each<Colourway>([](ElementId, const Colourway&) { ADD_FAILURE() << "a patch brings no colourway"; });
}

TEST_F(LooksTest, TrimsOfTwinsFollowEachOther)
{
    apply(makeTwins(design, std::array{seat}, [](const std::string& name) { return name + "'"; }));
    const ElementId twin = twinOf(design, seat);
    ASSERT_NE(twin, noElement);
    EXPECT_EQ(fabricShown(design, twin), photo) << "it shows what the other one shows";
    const ElementId there = mirroredElement(design, edge);
    ASSERT_TRUE(design.find<OutlineTrim>(there));
    EXPECT_EQ(get<OutlineTrim>(there), (OutlineTrim{{twin, 2, 3}, get<OutlineTrim>(edge).trim}));

    for (const ElementId id : {edge, fixation, pipe}) {
        const ElementId image = id == pipe ? twinOf(design, pipe) : mirroredElement(design, id);
        ASSERT_NE(image, noElement) << number(id);
        apply(setTrim(design, std::array{id}, singleStitch()));
        EXPECT_EQ(*seamTrim(*design.element(image)), singleStitch());
        apply(setTrim(design, std::array{image}, SeamTrim()));
        EXPECT_EQ(*seamTrim(*design.element(id)), SeamTrim()) << "either one leads";
    }
    apply(dragStretchEnd(design, edge, SeamSide::A, StretchEnd::To, 2.5));
    EXPECT_EQ(get<OutlineTrim>(there).stretch, (Stretch{twin, 2, 2.5}));
    apply(removeElements(design, std::array{there}));
    EXPECT_FALSE(design.element(edge));
    apply(addOutlineTrim(design, {twin, 3, 4}, singleStitch()));
    ASSERT_EQ(all<OutlineTrim>().size(), 2U);
    EXPECT_EQ(all<OutlineTrim>()[0].trim, all<OutlineTrim>()[1].trim);

    apply(setColourwayFabric(design, blue, std::array{twin}, wool));
    EXPECT_EQ(fabricShown(design, seat), wool);
    apply(removeElements(design, std::array{twin}));
    EXPECT_EQ(all<OutlineTrim>().size(), 1U);
    EXPECT_EQ(get<Colourway>(blue).fabrics.size(), 1U);
}

TEST_F(LooksTest, TwinSeamsTakeOverTheTrim)
{
    apply(makeTwins(design, std::array{seat, side}, [](const std::string& name) { return name + "'"; }));
    const ElementId image = mirroredElement(design, seam);
    ASSERT_TRUE(design.find<Seam>(image));
    EXPECT_EQ(get<Seam>(image).trim, get<Seam>(seam).trim);
    apply(setTrim(design, std::array{image}, singleStitch()));
    EXPECT_EQ(get<Seam>(seam).trim, singleStitch());
}

TEST_F(LooksTest, AnotherVersionGivesItsTrimsAndColourways)
{
    const std::vector gone = {edge, photo, blue};
    const Design now = design.with(removeElements(design, gone));
    const std::vector<Difference> found = differencesBetween(now, design);
    EXPECT_TRUE(std::ranges::any_of(found, [](const Difference& d) {
        return d.element == seam && d.fields.size() == 1 && d.fields[0].key == "trim";
    }));

    const Design withBlue = now.with(takeFrom(now, design, {blue}));
    EXPECT_EQ(withBlue.find<Colourway>(blue)->fabrics, get<Colourway>(blue).fabrics);
    EXPECT_TRUE(withBlue.find<Fabric>(photo)) << "with its fabrics";
    expectSound(withBlue);

    const Design withSeat = now.with(takeFrom(now, design, {seat}));
    EXPECT_TRUE(withSeat.find<OutlineTrim>(edge)) << "it lies on the seat";
    EXPECT_EQ(withSeat.find<Seam>(seam)->trim.pipingFabric, photo);
    expectSound(withSeat);

    const Design bare = Design().with(takeFrom(Design(), design, {blue}));
    EXPECT_TRUE(bare.find<Colourway>(blue)->fabrics.empty()) << "without patches there is nothing to colour";
    expectSound(bare);
}

TEST_F(LooksTest, AFabricInUseGivesItsPlaceToAnother)
{
    EXPECT_EQ(patchesWith(design, leather), (std::vector{seat, side}));
    EXPECT_EQ(patchesWith(design, photo), std::vector{seat});
    EXPECT_TRUE(patchesWith(design, wool).empty());
    EXPECT_TRUE(removeFabric(design, leather, noElement).empty()) << "patches are made of it";
    EXPECT_TRUE(removeFabric(design, leather, leather).empty());

    apply(removeFabric(design, leather, wool));
    EXPECT_FALSE(design.find<Fabric>(leather));
    EXPECT_EQ(get<Patch>(seat).fabric, wool);
    EXPECT_EQ(get<Patch>(side).fabric, wool);
    apply(removeFabric(design, photo, wool));
    EXPECT_EQ(get<Colourway>(blue).fabrics, (std::vector<Colourway::Entry>{{seat, wool}}));
    EXPECT_EQ(get<Seam>(seam).trim.pipingFabric, wool);
}

TEST_F(LooksTest, AFabricThatNobodyHasIsJustRemoved)
{
    apply(removeFabric(design, wool, noElement));
    EXPECT_FALSE(design.find<Fabric>(wool));
}

TEST_F(LooksTest, AGivenFabricIsShownUnderAColourwayAndElseMadeOf)
{
    apply(giveFabric(design, std::array{side}, wool));
    EXPECT_EQ(get<Patch>(side).fabric, leather) << "the shape stays";
    EXPECT_EQ(fabricShown(design, side), wool);
    apply(showColourway(design, noElement));
    apply(giveFabric(design, std::array{side}, wool));
    EXPECT_EQ(get<Patch>(side).fabric, wool);
    EXPECT_TRUE(giveFabric(design, std::array{seam}, wool).empty()) << "a seam has no fabric";
}

TEST_F(LooksTest, AddedFabricsGetNamesOfTheirOwn)
{
    const ElementId id = design.nextId();
    Fabric copy = get<Fabric>(leather);
    apply(addFabric(design, copy));
    EXPECT_EQ(get<Fabric>(id).name, "Leather 2");
    copy.name = "Leather 2";
    EXPECT_EQ(get<Fabric>(id), copy);
}

} // namespace
} // namespace bolster::looks
