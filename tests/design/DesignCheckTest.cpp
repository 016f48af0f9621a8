#include "DesignCheck.h"
#include "PatternSize.h"

#include "TestData.h"

namespace bolster {
namespace {

// Two patches side by side, sewn and fixed: nothing to complain about.
struct Parts {
    Settings settings;
    Fabric fabric;
    Patch seat;
    Patch side;
    FixationCurve rail;
    FixationSeam fixation;
    Seam seam;
    Frame frame;
    HandleCurve handle;
    FancySeam fancy;
    Cushion cushion;
    Foam foam;
    Scan scan;

    Parts()
    {
        fabric.name = "Leather";
        seat.name = "Seat";
        seat.fabric = ElementId{1};
        seat.outline = BSpline2(1, true, {{0, 0}, {500, 0}, {500, 480}, {0, 480}});
        side.name = "Side";
        side.fabric = ElementId{1};
        side.outline = BSpline2(1, true, {{0, 0}, {120, 0}, {120, 480}, {0, 480}});
        rail.name = "Rail";
        rail.curve = BSpline3(1, false, {{0, 0, 0}, {500, 0, 0}});
        fixation.stretch = {ElementId{2}, 0, 1};
        fixation.curve = ElementId{4};
        seam.a = {ElementId{2}, 1, 2};
        seam.b = {ElementId{3}, 3, 4};
        frame.name = "Chair";
        frame.file = "chair.obj";
        handle.name = "Lumbar";
        handle.patch = ElementId{2};
        handle.curve = BSpline2(1, false, {{100, 300}, {400, 300}});
        handle.target = BSpline3(1, false, {{100, 300, 40}, {400, 300, 40}});
        fancy.name = "Pipe";
        fancy.patch = ElementId{2};
        fancy.curve = BSpline2(1, false, {{250, 0}, {250, 200}});
        cushion.name = "Padding";
        cushion.frame = ElementId{7};
        cushion.patches = {ElementId{2}};
        foam.name = "Wedge";
        foam.cushion = ElementId{10};
        scan.name = "Measured";
        scan.file = "chair.ply";
        scan.cuts = {{{{Vec3::UnitZ(), 5}}}};
    }

    Design design() const
    {
        return Design().with({{},
                              {{settingsId, nullptr, makeElement(settings)},
                               {ElementId{1}, nullptr, makeElement(fabric)},
                               {ElementId{2}, nullptr, makeElement(seat)},
                               {ElementId{3}, nullptr, makeElement(side)},
                               {ElementId{4}, nullptr, makeElement(rail)},
                               {ElementId{5}, nullptr, makeElement(fixation)},
                               {ElementId{6}, nullptr, makeElement(seam)},
                               {ElementId{7}, nullptr, makeElement(frame)},
                               {ElementId{8}, nullptr, makeElement(handle)},
                               {ElementId{9}, nullptr, makeElement(fancy)},
                               {ElementId{10}, nullptr, makeElement(cushion)},
                               {ElementId{11}, nullptr, makeElement(foam)},
                               {ElementId{12}, nullptr, makeElement(scan)}}});
    }
};

TEST(DesignCheck, FindsNothingInASoundDesign)
{
    for (const Problem& problem : checkDesign(Parts().design()))
        ADD_FAILURE() << problem.english();
    EXPECT_TRUE(checkDesign(Design()).empty());
}

struct Rule {
    const char* name;
    void (*spoil)(Parts&);
    int element;
    const char* field;
    const char* expected; ///< in the message
    Severity severity = Severity::Error;
};

void PrintTo(const Rule& rule, std::ostream* out)
{
    *out << rule.name;
}

class DesignRule : public testing::TestWithParam<Rule> {};

TEST_P(DesignRule, NamesElementFieldAndRemedy)
{
    Parts parts;
    GetParam().spoil(parts);
    Problems problems = checkDesign(parts.design());
    std::erase_if(problems,
                  [](const Problem& problem) { return problem.field.empty(); }); // free in space, as a result
    ASSERT_EQ(problems.size(), 1u) << (problems.size() > 1 ? problems[0].english() + "\n" + problems[1].english()
                                                           : "");
    EXPECT_EQ(number(problems[0].element), GetParam().element);
    EXPECT_EQ(problems[0].field, GetParam().field);
    EXPECT_EQ(problems[0].severity, GetParam().severity);
    EXPECT_NE(problems[0].english().find(GetParam().expected), std::string::npos) << problems[0].english();
    for (const char digit : {'1', '2', '3', '4', '5'})
        EXPECT_EQ(problems[0].english().find(std::string("%") + digit), std::string::npos)
            << "an argument is missing";

    Problems leftOut;
    const Design usable = usablePart(parts.design(), problems, &leftOut);
    EXPECT_FALSE(hasErrors(checkDesign(usable)));
    EXPECT_EQ(leftOut.empty(), GetParam().severity == Severity::Warning);
    EXPECT_EQ(usable == parts.design(), GetParam().severity == Severity::Warning);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Rules, DesignRule,
    testing::Values(
        Rule{"EdgeZero", [](Parts& p) { p.settings.edgeLength = 0; }, 0, "edge_length", "positive"},
        Rule{"EdgeNaN", [](Parts& p) { p.settings.edgeLength = nan; }, 0, "edge_length", "NaN"},
        Rule{"EdgeHuge",
             [](Parts& p) {
                 p.settings.edgeLength = 1e8;
                 p.fabric.bendingLength = 1e7;
                 p.fabric.bendingLength = 1e7;
             },
             0, "edge_length", "100000000"},
        Rule{"EdgeTiny", [](Parts& p) { p.settings.edgeLength = 0.1; }, 0, "edge_length", "at least 0.38 mm"},
        Rule{"PoissonHigh", [](Parts& p) { p.fabric.poisson = 0.51; }, 1, "poisson", "0.51"},
        Rule{"PoissonLow", [](Parts& p) { p.fabric.poisson = -0.9; }, 1, "poisson", "-0.5"},
        Rule{"PoissonNaN", [](Parts& p) { p.fabric.poisson = nan; }, 1, "poisson", "NaN"},
        Rule{"Stiffness", [](Parts& p) { p.fabric.stiffness = 0; }, 1, "stiffness", "0.001"},
        Rule{"BendingNegative", [](Parts& p) { p.fabric.bendingLength = -1; }, 1, "bending_length", "-1"},
        Rule{"BendingSmall", [](Parts& p) { p.fabric.bendingLength = 2; }, 1, "bending_length", "cannot resolve",
             Severity::Warning},
        Rule{"Color", [](Parts& p) { p.fabric.color = "brown"; }, 1, "color", "#7a4a2b"},
        Rule{"NoFabric", [](Parts& p) { p.side.fabric = ElementId{99}; }, 3, "fabric", "no element 99"},
        Rule{"FabricKind", [](Parts& p) { p.side.fabric = ElementId{4}; }, 3, "fabric",
             "fixation curve 4 \"Rail\" is no fabric"},
        Rule{"FabricItself", [](Parts& p) { p.side.fabric = noElement; }, 3, "fabric", "no element 0"},
        Rule{"PatchPosition", [](Parts& p) { p.side.position.y() = 2e7; }, 3, "position", "20000000"},
        Rule{"PatchRotation", [](Parts& p) { p.side.rotation = nan; }, 3, "rotation", "NaN"},
        Rule{"PatchGrain", [](Parts& p) { p.side.grain = 1e9; }, 3, "grain", "1000000000"},
        Rule{"PatchPressure", [](Parts& p) { p.side.pressure = -1e4; }, 3, "pressure", "-10000"},
        Rule{"BowTie",
             [](Parts& p) {
                 p.side.outline = BSpline2(1, true, {{0, 0}, {120, 480}, {120, 0}, {0, 480}});
             },
             3, "outline.points", "(60, 240)"},
        Rule{"TwoPlaces",
             [](Parts& p) {
                 p.side.outline = BSpline2(1, true, {{0, 0}, {0, 480}, {0, 480}, {0, 480}});
             },
             3, "outline.points", "three points"},
        Rule{"OnePlace",
             [](Parts& p) {
                 p.side.outline = BSpline2(3, true, {{5, 5}, {5, 5}, {5, 5}, {5, 5}});
             },
             3, "outline.points", "three points"},
        Rule{"Line",
             [](Parts& p) {
                 p.side.outline = BSpline2(1, true, {{0, 0}, {120, 120}, {240, 240}, {300, 300}});
             },
             3, "outline.points", "one line"},
        Rule{"OpenOutline",
             [](Parts& p) {
                 p.frame.name = "";
                 p.frame.scale = -1;
             },
             7, "scale", "positive"},
        Rule{"CurveLength",
             [](Parts& p) {
                 p.rail.curve = BSpline3(1, false, {{1, 2, 3}, {1, 2, 3}});
             },
             4, "curve.points", "no length"},
        Rule{"FixationPatch", [](Parts& p) { p.seam.a.patch = ElementId{4}; }, 6, "a.patch", "no patch"},
        Rule{"FixationNoPatch", [](Parts& p) { p.seam.b.patch = ElementId{50}; }, 6, "b.patch", "no element 50"},
        Rule{"FixationFrom", [](Parts& p) { p.fixation.stretch.from = -0.5; }, 5, "from", "-0.5"},
        Rule{"FixationTo", [](Parts& p) { p.fixation.stretch.to = 4.5; }, 5, "to", "between 0 and 4"},
        Rule{"FixationNaN", [](Parts& p) { p.fixation.stretch.to = nan; }, 5, "to", "NaN"},
        Rule{"FixationEnd", [](Parts& p) { p.fixation.stretch.from = 4; }, 5, "from", "write 0"},
        Rule{"FixationCurve", [](Parts& p) { p.fixation.curve = ElementId{7}; }, 5, "curve",
             "frame 7 \"Chair\" is no fixation curve"},
        Rule{"RangeOutside",
             [](Parts& p) {
                 p.fixation.curveRange = {0.0, 1.5};
             },
             5, "curve_to", "1.5"},
        Rule{"RangeBackwards",
             [](Parts& p) {
                 p.fixation.curveRange = {0.75, 0.25};
             },
             5, "curve_to", "larger than"},
        Rule{"RangeEmpty",
             [](Parts& p) {
                 p.fixation.curveRange = {0.75, 0.75};
             },
             5, "curve_to", "larger than"},
        Rule{"StretchEmpty", [](Parts& p) { p.seam.a.to = 1 + 1e-12; }, 6, "a.to", "empty"},
        Rule{"StretchNoLength",
             [](Parts& p) {
                 p.seat.outline = BSpline2(1, true, {{0, 0}, {500, 0}, {500, 0}, {500, 480}, {0, 480}});
             },
             6, "a.to", "no length"},
        Rule{"SeamToItself", [](Parts& p) { p.seam.b = p.seam.a; }, 6, "b", "itself"},
        Rule{"SeamOverlap",
             [](Parts& p) {
                 p.seam.a = {ElementId{2}, 3.5, 0.5};
                 p.seam.b = {ElementId{2}, 0.25, 1};
             },
             6, "b", "3.5 to 0.5"},
        Rule{"SeamWhole",
             [](Parts& p) {
                 p.seam.a = {ElementId{2}, 1, 1};
                 p.seam.b = {ElementId{2}, 2, 3};
             },
             6, "b", "itself"},
        Rule{"WrongSide", [](Parts& p) { p.seam.reversed = false; }, 6, "reversed", "wrong side",
             Severity::Warning},
        Rule{"WrongSideC1",
             [](Parts& p) {
                 p.seam.reversed = false;
                 p.seam.continuity = Continuity::C1;
             },
             6, "reversed", "wrong side"},
        Rule{"WrongSideG1",
             [](Parts& p) {
                 p.side.wrongSideOut = true;
                 p.seam.continuity = Continuity::G1;
             },
             6, "reversed", "wrong side"},
        Rule{"NormalZero", [](Parts& p) { p.fixation.orientation.directions = {Vec3(0, 0, 0)}; }, 5, "normal",
             "not all 0"},
        Rule{"NormalTurnsRound",
             [](Parts& p) {
                 p.fixation.orientation.directions = {Vec3(0, 0, 1), Vec3(0, 0, -2)};
             },
             5, "normal", "opposite"},
        Rule{"TangentNaN",
             [](Parts& p) {
                 p.fixation.orientation = {Orientation::Kind::Tangent, {Vec3(0, nan, 1)}, 1};
             },
             5, "tangent", "three numbers"},
        Rule{"NormalWeight", [](Parts& p) { p.fixation.orientation.weight = -1; }, 5, "normal_weight", "-1"},
        Rule{"RangeOfNoCurve",
             [](Parts& p) {
                 p.fixation.curve = {};
                 p.fixation.curveRange = std::pair(0.0, 1.0);
                 p.fixation.orientation.directions = {Vec3(0, 0, 1)};
             },
             5, "curve_from", "no curve"},
        Rule{"Ease",
             [](Parts& p) {
                 p.seam.b = {ElementId{3}, 3, 0.25};
             },
             6, "b", "6.25", Severity::Warning},
        Rule{"EaseTheOtherWay",
             [](Parts& p) {
                 p.seam.b = {ElementId{3}, 3, 0.25};
                 p.seam.ease = -30; // the second side is the longer one
             },
             6, "b", "6.25", Severity::Warning},
        Rule{"FrameFile", [](Parts& p) { p.frame.file = "../chair.obj"; }, 7, "file", "folder"},
        Rule{"FramePosition", [](Parts& p) { p.frame.position.z() = nan; }, 7, "position", "NaN"},
        Rule{"HandlePatch", [](Parts& p) { p.handle.patch = ElementId{4}; }, 8, "patch", "is no patch"},
        Rule{"HandleCurve", [](Parts& p) { p.handle.curve = BSpline2(1, false, {{1, 1}, {1, 1}}); }, 8,
             "curve.points", "no length"},
        Rule{"HandleTarget", [](Parts& p) { p.handle.target = BSpline3(); }, 8, "target.points", "no length"},
        Rule{"HandleClosed",
             [](Parts& p) { p.handle.target = BSpline3(1, true, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}); }, 8,
             "target.closed", "both be open"},
        Rule{"FancyPatch", [](Parts& p) { p.fancy.patch = ElementId{99}; }, 9, "patch", "name a patch"},
        Rule{"FancyWidth", [](Parts& p) { p.fancy.width = 0; }, 9, "width", "between 0.1 and 1000"},
        Rule{"FancyDepth", [](Parts& p) { p.fancy.depth = nan; }, 9, "depth", "NaN"},
        Rule{"FrameRotation", [](Parts& p) { p.frame.rotation = Quat(2, 0, 0, 0); }, 7, "rotation", "length 2"},
        Rule{"FrameColour", [](Parts& p) { p.frame.material.color = "brown"; }, 7, "material.color", "is no colour"},
        Rule{"ContactGap", [](Parts& p) { p.frame.contactGap = -1; }, 7, "contact_gap", "between 0 and 100"},
        Rule{"CushionFrame", [](Parts& p) { p.cushion.frame = ElementId{2}; }, 10, "frame", "is no frame"},
        Rule{"CushionPatch", [](Parts& p) { p.cushion.patches.push_back(ElementId{4}); }, 10, "patches[1]",
             "no patch"},
        Rule{"CushionVoxel", [](Parts& p) { p.cushion.voxel = 0; }, 10, "voxel_mm", "between 0.5 and 100"},
        Rule{"CushionDilation", [](Parts& p) { p.cushion.dilation = nan; }, 10, "dilation_mm", "NaN"},
        Rule{"CushionStrength", [](Parts& p) { p.cushion.strength = -0.1; }, 10, "strength", "-0.1"},
        Rule{"FoamCushion", [](Parts& p) { p.foam.cushion = ElementId{7}; }, 11, "cushion", "is no cushion"},
        Rule{"FoamSize", [](Parts& p) { p.foam.size.y() = 0; }, 11, "size", "between 1 and"},
        Rule{"FoamFile", [](Parts& p) { p.foam.shape = Foam::Shape::Mesh; }, 11, "file", "no file"},
        Rule{"FoamScale", [](Parts& p) { p.foam.scale = 0; }, 11, "scale", "positive"},
        Rule{"FoamStrength", [](Parts& p) { p.foam.strength = 11; }, 11, "strength", "11"},
        Rule{"ScanFile", [](Parts& p) { p.scan.file = ""; }, 12, "file", "beside the design"},
        Rule{"ScanScale", [](Parts& p) { p.scan.scale = 0; }, 12, "scale", "positive"},
        Rule{"ScanThreshold", [](Parts& p) { p.scan.threshold = 0; }, 12, "threshold_mm", "between 0.1"},
        Rule{"ScanStrength", [](Parts& p) { p.scan.strength = 101; }, 12, "strength", "between 0 and 100"},
        Rule{"ScanCut", [](Parts& p) { p.scan.cuts[0].halfSpaces[0].normal.setZero(); }, 12, "cuts[0].planes[0]",
             "normal"}),
    [](const auto& parameter) { return parameter.param.name; });

TEST(DesignCheck, EaseThatIsWantedIsNoWarning)
{
    Parts parts;
    parts.seam.b = {ElementId{3}, 3, 0.25};
    EXPECT_EQ(checkDesign(parts.design()).size(), 1u);
    parts.seam.ease = 30;
    EXPECT_TRUE(checkDesign(parts.design()).empty());
}

TEST(DesignCheck, RefusesTheSameSeamTheOtherWayRound)
{
    Parts parts;
    Seam again = parts.seam;
    std::swap(again.a, again.b);
    const auto problemsWith = [&](const Seam& seam) {
        return checkDesign(parts.design().with({{}, {{ElementId{50}, nullptr, makeElement(seam)}}}));
    };
    const Problems twice = problemsWith(again);
    ASSERT_EQ(twice.size(), 1U);
    EXPECT_EQ(twice.front().severity, Severity::Warning);
    EXPECT_NE(twice.front().english().find("seam 6"), std::string::npos) << twice.front().english();

    again.reversed = !again.reversed;
    const Problems crossed = problemsWith(again);
    ASSERT_EQ(crossed.size(), 1U);
    EXPECT_EQ(crossed.front().severity, Severity::Error);
    EXPECT_EQ(crossed.front().element, ElementId{50});
}

TEST(DesignCheck, LetsTwoSeamsShareAStretch)
{
    Parts parts;
    const Design three = parts.design().with(
        {{}, {{ElementId{8}, nullptr, makeElement(parts.side)}, {ElementId{9}, nullptr, makeElement([&] {
                                                                     Seam other = parts.seam;
                                                                     other.b.patch = ElementId{8};
                                                                     return other;
                                                                 }())}}});
    EXPECT_TRUE(checkDesign(three).empty());
}

TEST(DesignCheck, AcceptsEveryWayToWalkAClosedOutline)
{
    for (const auto& [from, to] : {std::pair(0.0, 4.0), std::pair(0.0, 0.0), std::pair(3.0, 0.0),
                                   std::pair(3.5, 0.5), std::pair(2.0, 2.0), std::pair(3.0, 4.0)}) {
        Parts parts;
        parts.fixation.stretch = {ElementId{2}, from, to};
        EXPECT_FALSE(hasErrors(checkDesign(parts.design()))) << from << " to " << to;
    }
}

TEST(DesignCheck, AddressesAShiftedDomainFromZeroOrFromItsFirstKnot)
{
    Parts parts;
    parts.seat.outline = BSpline2(1, true, parts.seat.outline.points(), {1, 2, 3, 4, 5});
    for (const auto& [from, to] : {std::pair(0.0, 1.0), std::pair(4.0, 5.0), std::pair(1.0, 1.0)}) {
        parts.fixation.stretch = {ElementId{2}, from, to};
        parts.seam.a = {ElementId{2}, 2, 3};
        EXPECT_FALSE(hasErrors(checkDesign(parts.design()))) << from << " to " << to;
    }
    parts.fixation.stretch = {ElementId{2}, 0, 4.5};
    EXPECT_TRUE(hasErrors(checkDesign(parts.design()))) << "more than once round";
}

TEST(DesignCheck, TakesRightSidesFromTheWayOutlinesRun)
{
    const auto warned = [](bool reversed, bool clockwiseA, bool clockwiseB, bool outA, bool outB) {
        Parts parts;
        parts.seam.reversed = reversed;
        parts.seat.wrongSideOut = outA;
        parts.side.wrongSideOut = outB;
        if (clockwiseA) {
            parts.seat.outline = parts.seat.outline.reversed();
            parts.seam.a = {ElementId{2}, 2, 3};
        }
        if (clockwiseB) {
            parts.side.outline = parts.side.outline.reversed();
            parts.seam.b = {ElementId{3}, 0, 1};
        }
        const Problems problems = checkDesign(parts.design());
        return !problems.empty() && problems[0].field == "reversed";
    };
    for (int bits = 0; bits < 32; ++bits) {
        const auto bit = [&](int k) { return (bits >> k & 1) != 0; };
        const bool flips = (bit(1) != bit(2)) != (bit(3) != bit(4));
        EXPECT_EQ(warned(bit(0), bit(1), bit(2), bit(3), bit(4)), bit(0) == flips) << bits;
    }
}

TEST(DesignCheck, WarnsOfEachComponentThatIsFreeInSpace)
{
    Parts parts;
    Design design = parts.design().with({{}, {{ElementId{5}, nullptr, nullptr}}});
    EXPECT_TRUE(checkDesign(design).empty()) << "a handle holds it";
    design = design.with({{}, {{ElementId{8}, nullptr, nullptr}}});
    Problems problems = checkDesign(design);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, ElementId{2});
    EXPECT_EQ(problems[0].severity, Severity::Warning);
    EXPECT_NE(problems[0].english().find("and the 1 sewn to it are free in space"), std::string::npos);

    design = parts.design().with({{}, {{ElementId{6}, nullptr, nullptr}}});
    problems = checkDesign(design);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, ElementId{3});
    EXPECT_NE(problems[0].english().find("free in space"), std::string::npos);
    parts.side.pressure = 0.3;
    EXPECT_TRUE(checkDesign(parts.design().with({{}, {{ElementId{6}, nullptr, nullptr}}})).empty()) << "a cushion";
}

TEST(DesignCheck, RepeatsTheProblemsOfUnreadableElements)
{
    const ReadDesign read = readDesign(R"({"format": "bolster-design", "version": 1, "elements": [
        {"id": 1, "kind": "fabric", "name": 5}, {"id": 2, "kind": "patch", "name": "P", "fabric": 1,
         "outline": {"degree": 1, "closed": true, "points": [[0,0],[9,0],[9,9]]}}]})");
    const Problems problems = checkDesign(read.design);
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[0], read.problems[0]);
    EXPECT_EQ(problems[2].field, "fabric");
    EXPECT_NE(problems[2].english().find("cannot be read"), std::string::npos);
    EXPECT_EQ(allProblems(read), problems);
}

TEST(UsablePart, TakesDependantsAlong)
{
    Parts parts;
    parts.seat.outline = BSpline2(1, true, {{0, 0}, {500, 480}, {500, 0}, {0, 480}});
    Problems leftOut;
    const Design usable = usablePart(parts.design(), checkDesign(parts.design()), &leftOut);
    std::vector<int> gone;
    for (const Problem& problem : leftOut)
        gone.push_back(number(problem.element));
    EXPECT_EQ(gone, (std::vector<int>{2, 5, 6, 8, 9, 10, 11}));
    EXPECT_NE(leftOut[1].english().find("needs patch 2 \"Seat\""), std::string::npos) << leftOut[1].english();
    EXPECT_EQ(usable.elements().size(), 5u);
}

TEST(UsablePart, GivesABadFabricTheUsualValues)
{
    Parts parts;
    parts.fabric.poisson = 3;
    Problems leftOut;
    const Design usable = usablePart(parts.design(), checkDesign(parts.design()), &leftOut);
    EXPECT_EQ(usable.elements().size(), parts.design().elements().size());
    usable.each<Fabric>([](ElementId, const Fabric& fabric) { EXPECT_EQ(fabric.poisson, Fabric{}.poisson); });
    ASSERT_EQ(leftOut.size(), 1U);
    EXPECT_NE(leftOut.front().english().find("usual values"), std::string::npos);
}

TEST(UsablePart, FallsBackToAnEdgeLengthThatWorks)
{
    Parts parts;
    parts.settings.edgeLength = -1;
    Problems leftOut;
    EXPECT_EQ(usablePart(parts.design(), checkDesign(parts.design()), &leftOut).settings().edgeLength, 12);
    ASSERT_EQ(leftOut.size(), 1u);
    EXPECT_EQ(leftOut[0].english(), "settings, edge_length: an edge length of 12 mm is used instead");

    parts.seat.outline = BSpline2(1, true, {{0, 0}, {1e6, 0}, {1e6, 1e6}, {0, 1e6}});
    parts.seam.a = {ElementId{2}, 1, 1.00048};
    const Problems problems = checkDesign(parts.design());
    const Design usable = usablePart(parts.design(), problems, &leftOut);
    EXPECT_GT(usable.settings().edgeLength, 600);
    EXPECT_FALSE(hasErrors(checkDesign(usable)));
}

TEST(PatternSize, IsThatOfAllPatches)
{
    Parts parts;
    EXPECT_DOUBLE_EQ(patternArea(parts.design()), (500 + 120) * 480);
    EXPECT_DOUBLE_EQ(patternArea(Design()), 0);
}

/// A honeycomb: six triangles meet in each vertex.
TEST(PatternSize, VerticesAreHalfOfTheTriangles)
{
    EXPECT_NEAR(2 * vertexCount(1000, 2) * (std::sqrt(3) / 4 * 2 * 2), 1000, 1e-9);
    EXPECT_NEAR(edgeLengthFor(1000, vertexCount(1000, 2)), 2, 1e-12);
}

TEST(SeamEase, IsTheShareOfTheLongerSide)
{
    Parts parts;
    EXPECT_NEAR(seamEase(parts.design(), parts.seam), 0, 1e-12);
    parts.seam.b = {ElementId{3}, 3, 0.25};
    EXPECT_NEAR(seamEase(parts.design(), parts.seam), 30.0 / 480, 1e-12);
    std::swap(parts.seam.a, parts.seam.b);
    EXPECT_NEAR(seamEase(parts.design(), parts.seam), 30.0 / 480, 1e-12);
    parts.seam.a.patch = ElementId{99};
    EXPECT_EQ(seamEase(parts.design(), parts.seam), 0);
}

} // namespace
} // namespace bolster
