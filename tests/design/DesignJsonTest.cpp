#include "DesignJson.h"
#include "DesignCheck.h"

#include "TestData.h"

namespace bolster {
namespace {

std::string wholeText(const std::string& elements)
{
    return "{\"format\": \"bolster-design\", \"version\": 1, \"unit\": \"mm\", \"elements\": [" + elements + "]}";
}

const std::string fabricText = R"({"id": 1, "kind": "fabric", "name": "Leather"})";

std::string patchText(const std::string& more)
{
    return R"({"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, )" + more + "}";
}

std::string curveText(const std::string& curve)
{
    return R"({"id": 3, "kind": "fixation_curve", "name": "Rail", "curve": )" + curve + "}";
}

// The example of docs/design-json.md with every key written out.
constexpr const char* exampleText = R"({ "format": "bolster-design", "version": 1, "unit": "mm",
  "settings": {"edge_length": 12},
  "elements": [
   {"id": 1, "kind": "fabric", "name": "Leather", "poisson": 0.3, "stiffness": 1, "bending_length": 6.0,
    "color": "#7a4a2b"},
   {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [0,0], "rotation": 0, "grain": 90,
    "pressure": 0, "wrong_side_out": false,
    "outline": {"degree": 1, "closed": true, "points": [[0,0],[500,0],[500,480],[0,480]]}},
   {"id": 6, "kind": "patch", "name": "Side", "fabric": 1, "position": [600,0],
    "outline": {"degree": 1, "closed": true, "points": [[0,0],[120,0],[120,480],[0,480]]}},
   {"id": 3, "kind": "fixation_curve", "name": "Front rail",
    "curve": {"degree": 3, "closed": false, "points": [[0,0,0],[150,0,20],[300,0,20],[500,0,0]]}},
   {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3, "reversed": false,
    "match": "length"},
   {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 6, "from": 3, "to": 4},
    "reversed": true, "match": "length", "continuity": "C0"},
   {"id": 7, "kind": "frame", "name": "Armchair", "file": "armchair.obj", "scale": 437.5,
    "position": [0,0,0], "rotation": [0.70710678,0.70710678,0,0]},
   {"id": 8, "kind": "handle_curve", "name": "Lumbar", "patch": 2,
    "curve": {"degree": 1, "closed": false, "points": [[100,300],[400,300]]},
    "target": {"degree": 1, "closed": false, "points": [[100,300,40],[400,300,40]]}, "match": "length"},
   {"id": 9, "kind": "fancy_seam", "name": "Pipe", "patch": 2, "width": 12, "depth": 4, "profile": "round",
    "curve": {"degree": 1, "closed": false, "points": [[250,0],[250,200]]}} ] })";

TEST(DesignJson, ReadsTheDocumentedExample)
{
    const Design design = test::soundDesign(exampleText);
    EXPECT_EQ(design.elements().size(), 9u);
    EXPECT_EQ(design.find<Fabric>(ElementId{1})->name, "Leather");
    const Patch& side = *design.find<Patch>(ElementId{6});
    EXPECT_EQ(side.position, Vec2(600, 0));
    EXPECT_EQ(side.grain, 90);
    EXPECT_EQ(side.outline.at(2), Vec2(120, 480));
    const Seam& seam = *design.find<Seam>(ElementId{5});
    EXPECT_EQ(seam.b, (Stretch{ElementId{6}, 3, 4}));
    EXPECT_TRUE(seam.reversed);
    EXPECT_EQ(design.find<FixationSeam>(ElementId{4})->curve, ElementId{3});
    EXPECT_EQ(design.find<FixationCurve>(ElementId{3})->curve.at(1), Vec3(500, 0, 0));
    const Frame& frame = *design.find<Frame>(ElementId{7});
    EXPECT_LT((frame.placed(Vec3(0, 1, 0)) - Vec3(0, 0, 437.5)).norm(), 1e-5) << "y up becomes z up";
    EXPECT_EQ(design.find<HandleCurve>(ElementId{8})->target.at(1), Vec3(400, 300, 40));
    EXPECT_EQ(design.find<FancySeam>(ElementId{9})->curve.at(1), Vec2(250, 200));
    EXPECT_TRUE(checkDesign(design).empty());
}

TEST(DesignJson, WritesOneElementPerLineWithoutDefaults)
{
    const std::string text = writeDesign(test::soundDesign(exampleText));
    EXPECT_EQ(text, R"({"format": "bolster-design", "version": 1, "unit": "mm",
 "settings": {"edge_length": 12},
 "elements": [
  {"id": 1, "kind": "fabric", "name": "Leather"},
  {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "outline": {"degree": 1, "closed": true, "points": [[0, 0], [500, 0], [500, 480], [0, 480]]}},
  {"id": 3, "kind": "fixation_curve", "name": "Front rail", "curve": {"degree": 3, "closed": false, "points": [[0, 0, 0], [150, 0, 20], [300, 0, 20], [500, 0, 0]]}},
  {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
  {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 6, "from": 3, "to": 4}},
  {"id": 6, "kind": "patch", "name": "Side", "fabric": 1, "position": [600, 0], "outline": {"degree": 1, "closed": true, "points": [[0, 0], [120, 0], [120, 480], [0, 480]]}},
  {"id": 7, "kind": "frame", "name": "Armchair", "file": "armchair.obj", "scale": 437.5, "rotation": [0.7071067811865476, 0.7071067811865476, 0, 0]},
  {"id": 8, "kind": "handle_curve", "name": "Lumbar", "patch": 2, "curve": {"degree": 1, "closed": false, "points": [[100, 300], [400, 300]]}, "target": {"degree": 1, "closed": false, "points": [[100, 300, 40], [400, 300, 40]]}},
  {"id": 9, "kind": "fancy_seam", "name": "Pipe", "patch": 2, "curve": {"degree": 1, "closed": false, "points": [[250, 0], [250, 200]]}}]}
)");
    EXPECT_EQ(writeDesign(Design()),
              "{\"format\": \"bolster-design\", \"version\": 1, \"unit\": \"mm\",\n \"settings\": "
              "{\"edge_length\": 12},\n \"elements\": []}\n");
}

TEST(DesignJson, FillsInDefaults)
{
    const Design design = test::soundDesign(
        wholeText(fabricText + R"(, {"id": 4, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3},
        {"id": 5, "kind": "seam", "a": {"patch": 2, "from": 1, "to": 2}, "b": {"patch": 6, "from": 3, "to": 4}},
        {"id": 7, "kind": "frame", "name": "F", "file": "f.obj"}, {"id": 8, "kind": "cushion", "name": "C", "frame": 7},
        {"id": 9, "kind": "foam", "name": "W", "cushion": 8})"));
    EXPECT_FALSE(design.find<Frame>(ElementId{7})->contact);
    Cushion cushion;
    cushion.name = "C";
    cushion.frame = ElementId{7};
    EXPECT_EQ(*design.find<Cushion>(ElementId{8}), cushion);
    EXPECT_EQ(cushion.voxel, 5);
    EXPECT_EQ(cushion.dilation, 30);
    EXPECT_EQ(cushion.strength, 1);
    EXPECT_TRUE(cushion.enabled);
    Foam foam;
    foam.name = "W";
    foam.cushion = ElementId{8};
    EXPECT_EQ(*design.find<Foam>(ElementId{9}), foam);
    const Fabric& fabric = *design.find<Fabric>(ElementId{1});
    EXPECT_EQ(fabric.poisson, 0.3);
    EXPECT_EQ(fabric.stiffness, 1);
    EXPECT_EQ(fabric.bendingLength, 6);
    EXPECT_EQ(fabric.color, "#7a4a2b");
    EXPECT_FALSE(design.find<FixationSeam>(ElementId{4})->reversed);
    EXPECT_FALSE(design.find<FixationSeam>(ElementId{4})->curveRange);
    EXPECT_TRUE(design.find<Seam>(ElementId{5})->reversed);
    EXPECT_EQ(design.find<Seam>(ElementId{5})->continuity, Continuity::C0);
    EXPECT_EQ(design.find<Frame>(ElementId{7})->scale, 1);
    EXPECT_EQ(design.settings().edgeLength, 12);
}

// Everything that is not a default, and numbers that need all their digits.
Design unusualDesign()
{
    Fabric fabric{"Stoff \"A\\B\" \xC3\xBC\n\x01 \xF0\x9F\xAA\x91", -0.1, 0.30000000000000004, 1e-7, "#00ff7f"};
    Patch patch;
    patch.name = "%1";
    patch.fabric = ElementId{1};
    patch.position = Vec2(-0.0, 1.0 / 3);
    patch.rotation = -180;
    patch.grain = 0;
    patch.pressure = 0.5;
    patch.wrongSideOut = true;
    patch.outline = BSpline2(2, true, {{0, 0}, {1e7, 0.1}, {100, 5e-324}, {-0.0, 80}}, {-1, 0.25, 0.25, 1.1, 2});
    Patch cornered = patch;
    cornered.outline = BSpline2::withCorners({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 2}, {1, 3}, {0.5, 1}}, {0, 3});
    FixationCurve curve{"", BSpline3(1, true, {{0, 0, 0}, {1, 0, 1}, {1, 1, 2}})};
    FixationSeam fixation{
        {ElementId{2}, 0.5, 0.5}, ElementId{9},
        std::pair(2.5, 0.5),      true,
        Match::Parameter,         {Orientation::Kind::Normal, {Vec3(0.1, 0, 2), Vec3(-1, 3e-5, 0)}, 0.3}};
    FixationSeam leaning;
    leaning.stretch = {ElementId{2}, 0, 1};
    leaning.orientation = {Orientation::Kind::Tangent, {Vec3(0, 0, -2)}, 1};
    Seam seam{{ElementId{2}, 0, 1}, {ElementId{3}, 6.5, 1}, false, Match::Parameter, Continuity::G1};
    Frame frame{{25.4, Vec3(1, -2, 3e-300), Quat(0.5, -0.5, 0.5, 0.5)}, "F", "a/b.obj", true, 0.1, {}};
    HandleCurve handle{{"H", ElementId{2}, BSpline2(2, false, {{0, 0}, {1, 2}, {3, 4}}, {0, 0, 0, 0.5, 0.5, 0.5})},
                       BSpline3(1, false, {{0, 0, 0}, {1, 0, -0.0}}),
                       Match::Parameter,
                       {Orientation::Kind::Tangent, {Vec3(1, 2, 3)}, 2}};
    HandleCurve free{{"N", ElementId{2}, BSpline2(1, false, {{0, 0}, {1, 2}})}, {}, Match::Length, {}};
    free.orientation.directions = {Vec3(0, 0, 1)};
    FancySeam fancy{{"S", ElementId{2}, BSpline2(3, true, {{0, 0}, {1, 2}, {3, 4}})}, 0.1, -7, Profile::Welt};
    frame.contact = true;
    frame.contactGap = 0.1;
    frame.material = {FrameMaterial::Kind::Wood, "#7a5a33"};
    const Cushion cushion{"Foam",
                          ElementId{6},
                          {"Seat; \"upper\"", "Back"},
                          {ElementId{2}, ElementId{3}},
                          0.7,
                          12.3,
                          0.1 + 0.2,
                          Cushion::Distance::Euclidean,
                          false};
    Foam foam;
    foam.name = "Wedge";
    foam.scale = 25.4;
    foam.position = Vec3(1, 2, 3);
    foam.rotation = Quat(0, 1, 0, 0);
    foam.cushion = ElementId{7};
    foam.shape = Foam::Shape::Mesh;
    foam.size = Vec3(1, 2, 3.3);
    foam.file = "wedge.stl";
    foam.dilation = 5;
    foam.strength = 0.5;
    foam.cut = true;
    Scan scan{{1000, Vec3(-0.0, 2, 3), Quat(0.5, 0.5, 0.5, 0.5)},
              "S",
              "a/b.ply",
              0.1,
              9.75,
              false,
              ScanTarget::Point,
              {{{{Vec3(0, 0, -1), 0.1 + 0.2}, {Vec3(1e-9, 0, 0), -4}}, true}, {}}};
    const Measurement measured{"M", {ElementId{2}, {0.1 + 0.2, -0.0}}, {ElementId{3}, {1e-9, 2}}};
    Settings settings;
    settings.edgeLength = 7.1;
    const std::vector<ElementPtr> elements = {
        makeElement(settings), makeElement(fabric), makeElement(patch),    makeElement(cornered),
        makeElement(fixation), makeElement(seam),   makeElement(frame),    makeElement(handle),
        makeElement(fancy),    makeElement(curve),  makeElement(leaning),  makeElement(free),
        makeElement(cushion),  makeElement(foam),   makeElement(measured), makeElement(scan)};
    Edit edit;
    for (std::size_t i = 0; i < elements.size(); ++i)
        edit.changes.push_back({ElementId{static_cast<std::int32_t>(i)}, nullptr, elements[i]});
    edit.changes.front().id = settingsId;
    edit.changes.back().id = ElementId{largestElementId};
    return Design().with(edit);
}

TEST(DesignJson, ReadsBackEveryBitThatItWrites)
{
    const Design design = unusualDesign();
    const std::string text = writeDesign(design);
    const Design again = test::soundDesign(text);
    EXPECT_EQ(again, design);
    EXPECT_EQ(writeDesign(again), text);
    EXPECT_TRUE(std::signbit(again.find<Patch>(ElementId{2})->position.x())) << "-0 stays -0";
    EXPECT_TRUE(std::signbit(again.find<Patch>(ElementId{2})->outline.points()[3].x()));
    EXPECT_NE(text.find("0.30000000000000004"), std::string::npos);
    EXPECT_NE(text.find("\xC3\xBC"), std::string::npos) << "characters stay characters";
    EXPECT_NE(text.find("\"corners\": [0, 3]"), std::string::npos);
    EXPECT_NE(text.find("\"knots\": [-1, 0.25, 0.25, 1.1, 2]"), std::string::npos);
}

TEST(DesignJson, NotesAreKeptAndStandNowhereElse)
{
    const Design design = unusualDesign();
    EXPECT_EQ(writeDesign(design).find("note"), std::string::npos);
    Design noted = design;
    int count = 0;
    for (const auto& [id, element] : design.elements())
        if (id != settingsId) {
            Edit edit;
            edit.changes.push_back(
                {id, element, withNote(*element, std::string("ask \"Anna\"\nabout ").append(kindName(*element)))});
            noted = noted.with(edit);
            ++count;
        }
    const std::string text = writeDesign(noted);
    const Design again = test::soundDesign(text);
    EXPECT_EQ(again, noted);
    EXPECT_EQ(writeDesign(again), text);
    int found = 0;
    for (std::size_t at = text.find("\"note\": \"ask \\\"Anna\\\"\\u000aabout "); at != std::string::npos;
         at = text.find("\"note\": ", at + 1))
        ++found;
    EXPECT_EQ(found, count) << text;
}

TEST(DesignJson, IsCanonicalForRealDesigns)
{
    for (const char* name : test::designNames) {
        const Design design = test::soundDesign(test::designText(name));
        const std::string text = writeDesign(design);
        EXPECT_EQ(test::soundDesign(text), design) << name;
        EXPECT_EQ(writeDesign(test::soundDesign(text)), text) << name;
    }
}

TEST(DesignJson, ReadsEscapesAndAByteOrderMark)
{
    const Design design = test::soundDesign(
        "\xEF\xBB\xBF" + wholeText(R"({"id": 1, "kind": "fabric", "name": "\u00fc\ud83e\ude91\n\/\"\\"})"));
    EXPECT_EQ(design.find<Fabric>(ElementId{1})->name, "\xC3\xBC\xF0\x9F\xAA\x91\n/\"\\");
}

TEST(DesignJson, NormalisesRotationsAndColours)
{
    const Design design =
        test::soundDesign(wholeText(R"({"id": 1, "kind": "fabric", "name": "", "color": "#ABCDEF"},
                     {"id": 2, "kind": "frame", "name": "", "file": "f", "rotation": [1.0005, 0, 0, 0]})"));
    EXPECT_EQ(design.find<Fabric>(ElementId{1})->color, "#abcdef");
    EXPECT_EQ(design.find<Frame>(ElementId{2})->rotation.w(), 1);
}

struct Unreadable {
    const char* name;
    std::string text;
    const char* expected; ///< in the message
};

void PrintTo(const Unreadable& value, std::ostream* out)
{
    *out << value.name;
}

class UnreadableText : public testing::TestWithParam<Unreadable> {};

TEST_P(UnreadableText, IsRefusedWithItsPlace)
{
    const ReadDesign read = readDesign(GetParam().text);
    EXPECT_FALSE(read.readable);
    EXPECT_EQ(read.design, Design());
    ASSERT_EQ(read.problems.size(), 1u);
    EXPECT_EQ(read.problems[0].severity, Severity::Error);
    EXPECT_EQ(read.problems[0].element, settingsId);
    EXPECT_NE(read.problems[0].english().find(GetParam().expected), std::string::npos)
        << read.problems[0].english();
}

const std::string bomb(1'000'000, '[');

INSTANTIATE_TEST_SUITE_P(
    Texts, UnreadableText,
    testing::Values(
        Unreadable{"Empty", "", "the file is empty"}, Unreadable{"Spaces", "  \n ", "the file is empty"},
        Unreadable{"Comma", "{\"format\": \"bolster-design\",\n \"version\" 1}", "Line 2, column 12: a colon"},
        Unreadable{"Bracket", "{\"a\": [1, 2}", "Line 1, column 12"},
        Unreadable{"Ends", "{\"a\": [1, 2", "Line 1, column 12"},
        Unreadable{"Key", "{\"a\": 1, 2}", "a key in quotes"},
        Unreadable{"NaN", wholeText(R"({"id": 1, "kind": "fabric", "name": "", "poisson": NaN})"), "NaN"},
        Unreadable{"Infinity", wholeText("[-Infinity]"), "this is no number"},
        Unreadable{"Number", "{\"a\": 01}", "this is no number"},
        Unreadable{"Number2", "{\"a\": 1.}", "this is no number"},
        Unreadable{"Number3", "{\"a\": .5}", "a value is expected"},
        Unreadable{"Number4", "{\"a\": 1e}", "no number"},
        Unreadable{"Quote", "{\"a\": \"b\n\"}", "Line 1, column 9"},
        Unreadable{"OpenQuote", "{\"a", "inside quotes"},
        Unreadable{"Escape", "{\"a\": \"\\x\"}", "no valid escape"},
        Unreadable{"Surrogate", "{\"a\": \"\\ud800\"}", "no valid escape"},
        Unreadable{"Surrogate2", "{\"a\": \"\\udc00\\ud800\"}", "no valid escape"},
        Unreadable{"Latin1", "{\"a\": \"\xFC\"}", "not UTF-8"},
        Unreadable{"Overlong", "{\"a\": \"\xC0\x80\"}", "not UTF-8"},
        Unreadable{"CutCharacter", "{\"a\": \"\xE2\x82\"}", "not UTF-8"},
        Unreadable{"Characters", "{\"\xC3\xBC\": x}", "Line 1, column 7"}, // columns count characters
        Unreadable{"Trailing", wholeText("") + " {}", "goes on after"},
        Unreadable{"Comment", "// a design\n{}", "Line 1"}, Unreadable{"Bomb", bomb, "nested"},
        Unreadable{"ObjectBomb", "{\"a\":" + bomb, "nested"}, Unreadable{"Number only", "17", "no Bolster design"},
        Unreadable{"List", "[1]", "no Bolster design"},
        Unreadable{"Other", R"({"format": "gltf", "version": 1, "elements": []})", "no Bolster design"},
        Unreadable{"Newer", R"({"format": "bolster-design", "version": 2, "unit": "mm", "elements": []})", "newer"},
        Unreadable{"Version", R"({"format": "bolster-design", "version": "1", "elements": []})", "version"},
        Unreadable{"Version0", R"({"format": "bolster-design", "version": 0, "elements": []})", "version"},
        Unreadable{"NoVersion", R"({"format": "bolster-design", "elements": []})", "version"},
        Unreadable{"Twice", R"({"format": "bolster-design", "version": 1, "elements": [], "elements": [1]})",
                   "twice"}),
    [](const auto& parameter) {
        std::string name = parameter.param.name;
        std::erase(name, ' ');
        return name;
    });

TEST(DesignJson, RefusesEndlessTexts)
{
    EXPECT_FALSE(readDesign(std::string(40u << 20, ' ')).readable);
}

struct BadElement {
    const char* name;
    std::string text; ///< of elements, in addition to a fabric 1
    const char* label;
    const char* field;
    const char* expected; ///< in the message
};

void PrintTo(const BadElement& value, std::ostream* out)
{
    *out << value.name;
}

class BadElementText : public testing::TestWithParam<BadElement> {};

TEST_P(BadElementText, IsQuarantinedAndKept)
{
    const std::string text = wholeText(fabricText + ", " + GetParam().text);
    const ReadDesign read = readDesign(text);
    ASSERT_TRUE(read.readable);
    ASSERT_EQ(read.problems.size(), 1u) << (read.problems.empty() ? "" : read.problems[1].english());
    const Problem& problem = read.problems[0];
    EXPECT_EQ(problem.label, GetParam().label);
    EXPECT_EQ(problem.field, GetParam().field);
    EXPECT_NE(problem.message.english().find(GetParam().expected), std::string::npos) << problem.english();
    EXPECT_NE(read.design.find<Fabric>(ElementId{1}), nullptr);

    const auto* quarantined = read.design.find<Quarantined>(problem.element);
    ASSERT_TRUE(quarantined);
    EXPECT_EQ(quarantined->problems, read.problems);
    EXPECT_NE(text.find(quarantined->text), std::string::npos);
    const std::string written = writeDesign(read.design);
    EXPECT_NE(written.find(quarantined->text), std::string::npos);
    EXPECT_EQ(readDesign(written).design, read.design);
    EXPECT_EQ(allProblems(read).size(), 1u) << "reported once, not by reading and by the rules";
}

const std::string goodOutline = R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]]})";

INSTANTIATE_TEST_SUITE_P(
    Elements, BadElementText,
    testing::Values(
        BadElement{"UnknownKind", R"({"id": 2, "kind": "button", "name": "B"})", "button 2 \"B\"", "kind",
                   "\"button\""},
        BadElement{"NoKind", R"({"id": 2})", "element 2", "kind", "missing"},
        BadElement{"KindType", R"({"id": 2, "kind": 5})", "element 2", "kind", "quotes"},
        BadElement{"NoId", R"({"kind": "fabric", "name": "W"})", "elements[1]", "id", "missing"},
        BadElement{"IdType", R"({"id": "2", "kind": "fabric", "name": "W"})", "elements[1]", "id", "whole number"},
        BadElement{"IdFraction", R"({"id": 2.5, "kind": "fabric", "name": "W"})", "elements[1]", "id",
                   "whole number"},
        BadElement{"IdZero", R"({"id": 0, "kind": "fabric", "name": "W"})", "elements[1]", "id", "whole number"},
        BadElement{"IdLarge", R"({"id": 2000000001, "kind": "fabric", "name": "W"})", "elements[1]", "id",
                   "2000000000"},
        BadElement{"IdTwice", R"({"id": 1, "kind": "fabric", "name": "W"})", "fabric 1 \"W\"", "id", "already"},
        BadElement{"NoObject", "[]", "elements[1]", "", "braces"},
        BadElement{"UnknownKey", R"({"id": 2, "kind": "fabric", "name": "W", "colour": "#112233"})",
                   "fabric 2 \"W\"", "colour", "unknown"},
        BadElement{"DoubleKey", R"({"id": 2, "kind": "fabric", "name": "W", "name": "V"})", "fabric 2 \"W\"",
                   "name", "twice"},
        BadElement{"NameType", R"({"id": 2, "kind": "fabric", "name": 7})", "fabric 2", "name", "quotes"},
        BadElement{"NumberType", R"({"id": 2, "kind": "fabric", "name": "W", "poisson": "0.3"})", "fabric 2 \"W\"",
                   "poisson", "number"},
        BadElement{"NumberNull", R"({"id": 2, "kind": "fabric", "name": "W", "poisson": null})", "fabric 2 \"W\"",
                   "poisson", "number"},
        BadElement{"Overflow", R"({"id": 2, "kind": "fabric", "name": "W", "stiffness": 1e999})", "fabric 2 \"W\"",
                   "stiffness", "1e999"},
        BadElement{"NoFabric", R"({"id": 2, "kind": "patch", "name": "S", )" + goodOutline + "}", "patch 2 \"S\"",
                   "fabric", "missing"},
        BadElement{"Position", patchText(R"("position": [1], )" + goodOutline), "patch 2 \"Seat\"", "position",
                   "2 numbers"},
        BadElement{"Flag", patchText(R"("wrong_side_out": 1, )" + goodOutline), "patch 2 \"Seat\"",
                   "wrong_side_out", "true or false"},
        BadElement{"NoOutline", patchText(R"("grain": 0)"), "patch 2 \"Seat\"", "outline", "missing"},
        BadElement{"OutlineType", patchText(R"("outline": [[0,0],[1,1],[1,0]])"), "patch 2 \"Seat\"", "outline",
                   "braces"},
        BadElement{"OpenOutline",
                   patchText(R"("outline": {"degree": 1, "closed": false, "points": [[0,0],[9,0],[9,9]]})"),
                   "patch 2 \"Seat\"", "outline.closed", "closed"},
        BadElement{"Degree0",
                   patchText(R"("outline": {"degree": 0, "closed": true, "points": [[0,0],[9,0],[9,9]]})"),
                   "patch 2 \"Seat\"", "outline.degree", "1 to 3"},
        BadElement{"Degree4",
                   patchText(R"("outline": {"degree": 4, "closed": true, "points": [[0,0],[9,0],[9,9]]})"),
                   "patch 2 \"Seat\"", "outline.degree", "1 to 3"},
        BadElement{"FewPoints", patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0]]})"),
                   "patch 2 \"Seat\"", "outline.points", "at least 3"},
        BadElement{"Point3D",
                   patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0,1],[9,9]]})"),
                   "patch 2 \"Seat\"", "outline.points[1]", "2 numbers"},
        BadElement{"PointText",
                   patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],["9",0],[9,9]]})"),
                   "patch 2 \"Seat\"", "outline.points[1]", "number"},
        BadElement{"FarPoint",
                   patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,1.1e7]]})"),
                   "patch 2 \"Seat\"", "outline.points[2]", "1.1e7"},
        BadElement{"PointsType", patchText(R"("outline": {"degree": 1, "closed": true, "points": 5})"),
                   "patch 2 \"Seat\"", "outline.points", "list"},
        BadElement{
            "KnotCount",
            patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]], "knots": [0,1]})"),
            "patch 2 \"Seat\"", "outline.knots", "4 knots, not 2"},
        BadElement{
            "KnotOrder",
            patchText(
                R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]], "knots": [0,2,1,3]})"),
            "patch 2 \"Seat\"", "outline.knots", "decrease"},
        BadElement{
            "KnotText",
            patchText(
                R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]], "knots": [0,1,"2",3]})"),
            "patch 2 \"Seat\"", "outline.knots[2]", "number"},
        BadElement{
            "NoKnots",
            patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]], "knots": []})"),
            "patch 2 \"Seat\"", "outline.knots", "empty"},
        BadElement{
            "CornersOfPolygon",
            patchText(R"("outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]], "corners": [0]})"),
            "patch 2 \"Seat\"", "outline.corners", "degree 3"},
        BadElement{
            "CornersTooClose",
            patchText(
                R"("outline": {"degree": 3, "closed": true, "points": [[0,0],[9,0],[9,9],[0,9]], "corners": [0,2]})"),
            "patch 2 \"Seat\"", "outline.corners", "two points between"},
        BadElement{
            "CornerRange",
            patchText(
                R"("outline": {"degree": 3, "closed": true, "points": [[0,0],[9,0],[9,9],[0,9]], "corners": [4]})"),
            "patch 2 \"Seat\"", "outline.corners[0]", "0 to 3"},
        BadElement{
            "CornersAndKnots",
            patchText(
                R"("outline": {"degree": 3, "closed": true, "points": [[0,0],[9,0],[9,9]], "corners": [0], "knots": [0,1,2,3]})"),
            "patch 2 \"Seat\"", "outline.corners", "either"},
        BadElement{
            "OpenCorners",
            curveText(
                R"({"degree": 3, "closed": false, "points": [[0,0,0],[1,0,0],[2,0,0],[3,0,0]], "corners": [0]})"),
            "fixation curve 3 \"Rail\"", "curve.corners", "closed"},
        BadElement{"ShortCurve",
                   curveText(R"({"degree": 3, "closed": false, "points": [[0,0,0],[1,0,0],[2,0,0]]})"),
                   "fixation curve 3 \"Rail\"", "curve.points", "at least 4"},
        BadElement{"CurveKey",
                   curveText(R"({"degree": 1, "closed": false, "points": [[0,0,0],[1,0,0]], "weights": []})"),
                   "fixation curve 3 \"Rail\"", "curve.weights", "unknown"},
        BadElement{"NoStretch", R"({"id": 5, "kind": "seam", "a": {"patch": 2, "from": 0, "to": 1}})", "seam 5",
                   "b", "missing"},
        BadElement{"StretchType",
                   R"({"id": 5, "kind": "seam", "a": {"patch": 2, "from": 0, "to": 1}, "b": [2, 0, 1]})", "seam 5",
                   "b", "stretch"},
        BadElement{
            "StretchKey",
            R"({"id": 5, "kind": "seam", "a": {"patch": 2, "from": 0, "to": 1}, "b": {"patch": 2, "from": 2}})",
            "seam 5", "b.to", "missing"},
        BadElement{
            "Continuity",
            R"({"id": 5, "kind": "seam", "a": {"patch": 2, "from": 0, "to": 1}, "b": {"patch": 2, "from": 2, "to": 3}, "continuity": "G2"})",
            "seam 5", "continuity", "\"C0\", \"C1\", \"G1\""},
        BadElement{
            "Match",
            R"({"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3, "match": "width"})",
            "fixation seam 5", "match", "\"length\", \"parameter\""},
        BadElement{
            "HalfRange",
            R"({"id": 5, "kind": "fixation_seam", "patch": 2, "from": 0, "to": 1, "curve": 3, "curve_from": 0})",
            "fixation seam 5", "curve_to", "missing"},
        BadElement{"Quaternion",
                   R"({"id": 7, "kind": "frame", "name": "F", "file": "f.obj", "rotation": [1, 1, 0, 0]})",
                   "frame 7 \"F\"", "rotation", "1.414"},
        BadElement{"Rotation", R"({"id": 7, "kind": "frame", "name": "F", "file": "f.obj", "rotation": [1, 0, 0]})",
                   "frame 7 \"F\"", "rotation", "4 numbers"},
        BadElement{"NoFile", R"({"id": 7, "kind": "frame", "name": "F"})", "frame 7 \"F\"", "file", "missing"},
        BadElement{"NoFrame", R"({"id": 7, "kind": "cushion", "name": "C"})", "cushion 7 \"C\"", "frame",
                   "missing"},
        BadElement{"Parts", R"({"id": 7, "kind": "cushion", "name": "C", "frame": 6, "parts": ["Seat", 3]})",
                   "cushion 7 \"C\"", "parts[1]", "text"},
        BadElement{"NoParts", R"({"id": 7, "kind": "cushion", "name": "C", "frame": 6, "parts": []})",
                   "cushion 7 \"C\"", "parts", "leave it out"},
        BadElement{"Patches", R"({"id": 7, "kind": "cushion", "name": "C", "frame": 6, "patches": [0]})",
                   "cushion 7 \"C\"", "patches[0]", "1"},
        BadElement{"Distance", R"({"id": 7, "kind": "cushion", "name": "C", "frame": 6, "distance": "far"})",
                   "cushion 7 \"C\"", "distance", "\"city-block\", \"euclidean\""},
        BadElement{"Shape", R"({"id": 7, "kind": "foam", "name": "W", "cushion": 6, "shape": "cone"})",
                   "foam 7 \"W\"", "shape", "\"box\", \"cylinder\", \"sphere\", \"mesh\""},
        BadElement{"Size", R"({"id": 7, "kind": "foam", "name": "W", "cushion": 6, "size": [1, 2]})",
                   "foam 7 \"W\"", "size", "3 numbers"},
        BadElement{"ScanTarget", R"({"id": 7, "kind": "scan", "name": "S", "file": "s.ply", "target": "line"})",
                   "scan 7 \"S\"", "target", "\"plane\", \"point\""},
        BadElement{"ScanCuts", R"({"id": 7, "kind": "scan", "name": "S", "file": "s.ply", "cuts": {}})",
                   "scan 7 \"S\"", "cuts", "list"},
        BadElement{"ScanCut", R"({"id": 7, "kind": "scan", "name": "S", "file": "s.ply", "cuts": [7]})",
                   "scan 7 \"S\"", "cuts[0]", "braces"},
        BadElement{"ScanPlanes",
                   R"({"id": 7, "kind": "scan", "name": "S", "file": "s.ply", "cuts": [{"keep": true}]})",
                   "scan 7 \"S\"", "cuts[0].planes", "missing"},
        BadElement{"ScanPlane",
                   R"({"id": 7, "kind": "scan", "name": "S", "file": "s.ply", "cuts": [{"planes": [[0, 0, 1]]}]})",
                   "scan 7 \"S\"", "cuts[0].planes[0]", "4 numbers"}),
    [](const auto& parameter) { return parameter.param.name; });

TEST(DesignJson, ReportsEveryProblemAndReadsTheRest)
{
    const ReadDesign read = readDesign(R"({"format": "bolster-design", "version": 1, "author": "me",
        "settings": {"edge_length": "fine", "speed": 3},
        "elements": [{"id": 3, "kind": "fabric", "poisson": true, "x": 1}, {"id": 4, "kind": "fabric", "name": "W"}]})");
    EXPECT_TRUE(read.readable);
    std::vector<std::string> fields;
    for (const Problem& problem : read.problems)
        fields.push_back(problem.label + ":" + problem.field);
    EXPECT_EQ(fields, (std::vector<std::string>{"design:author", "settings:edge_length", "settings:speed",
                                                "fabric 3:name", "fabric 3:poisson", "fabric 3:x"}));
    EXPECT_EQ(read.design.settings().edgeLength, 12);
    EXPECT_NE(read.design.find<Fabric>(ElementId{4}), nullptr);
    EXPECT_NE(read.design.find<Quarantined>(ElementId{3}), nullptr);
}

TEST(DesignJson, RefusesAnotherUnitAsAWhole)
{
    for (const char* unit : {"\"inch\"", "5", "\"\""}) {
        const ReadDesign read = readDesign(std::string(R"({"format": "bolster-design", "version": 1, "unit": )") +
                                           unit + R"(, "elements": []})");
        EXPECT_FALSE(read.readable) << unit;
        ASSERT_EQ(read.problems.size(), 1U);
        EXPECT_EQ(read.problems.front().field, "unit");
    }
}

TEST(DesignJson, KeepsTheNumbersOfOthersWhenItNumbersBadElements)
{
    const ReadDesign read = readDesign(wholeText(R"({"kind": "x"}, {"id": 2, "kind": "fabric", "name": "A"},
        {"id": 2, "kind": "fabric", "name": "B"}, {"id": 3, "kind": "fabric", "name": "C"},
        {"id": 2, "kind": "fabric",
         "name": "D"}, 7)"));
    EXPECT_EQ(read.design.elements().size(), 6u);
    EXPECT_EQ(read.design.find<Fabric>(ElementId{2})->name, "A");
    EXPECT_EQ(read.design.find<Fabric>(ElementId{3})->name, "C");
    for (const int id : {1, 4, 5, 6})
        EXPECT_NE(read.design.find<Quarantined>(ElementId{id}), nullptr) << id;
    EXPECT_EQ(read.design.find<Quarantined>(ElementId{5})->text.find('\n'), std::string::npos);
    const ReadDesign again = readDesign(writeDesign(read.design));
    EXPECT_EQ(again.design.elements().size(), 6u);
    EXPECT_EQ(writeDesign(again.design), writeDesign(read.design));
}

std::string repeated(const std::string& item, int count)
{
    std::string text;
    for (int i = 0; i < count; ++i)
        text += i == 0 ? item : ", " + item;
    return text;
}

TEST(DesignJson, RefusesMoreThanAnybodyCanUse)
{
    EXPECT_FALSE(readDesign(wholeText(repeated("7", 100'001))).readable);
    const ReadDesign read = readDesign(wholeText(
        patchText(R"("outline": {"degree": 1, "closed": true, "points": [)" + repeated("[0, 1]", 10'001) + "]}")));
    ASSERT_EQ(read.problems.size(), 1u);
    EXPECT_EQ(read.problems[0].field, "outline.points");
}

TEST(DesignJson, CopesWithThousandsOfBadElements)
{
    std::string elements;
    for (int i = 1; i <= 20'000; ++i)
        elements += R"({"id": )" + std::to_string(i) + R"(, "kind": "fabric", "name": ""}, 7, )";
    const ReadDesign read = readDesign(wholeText(elements + "7"));
    EXPECT_EQ(read.design.elements().size(), 40'001u);
    EXPECT_EQ(read.problems.size(), 20'001u);
    EXPECT_EQ(allProblems(read).size(), 20'001u);
    EXPECT_EQ(readDesign(writeDesign(read.design)).design, read.design);
}

TEST(DesignJson, GivesUpCountingAfterAHundredProblems)
{
    const ReadDesign read = readDesign(wholeText(
        patchText(R"("outline": {"degree": 1, "closed": true, "points": [)" + repeated("[0]", 5000) + "]}")));
    ASSERT_EQ(read.problems.size(), 101u);
    EXPECT_NE(read.problems.back().english().find("4900 more"), std::string::npos)
        << read.problems.back().english();
}

} // namespace
} // namespace bolster
