// Forms that are cut along lines drawn on them.
#include "DesignCheck.h"
#include "Flatten.h"
#include "FormPattern.h"
#include "MeshImport.h"
#include "OutlineSampling.h"
#include "StretchLength.h"
#include "TestForms.h"
#include "TestPaths.h"
#include "TruthForms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

namespace bolster::test {
namespace {

constexpr double radius = 100, height = 200; // mm, of half a pipe

/// From bottom to top of half a pipe, at an angle from its left edge; `missing` mm short of each border.
FormLine upright(double angle, double missing = 0)
{
    FormLine line{"Upright", {}, false};
    for (int k = 0; k <= 20; ++k)
        line.points.emplace_back(-radius * std::cos(angle), -radius * std::sin(angle),
                                 missing + (height - 2 * missing) * k / 20);
    return line;
}

Form cutAlongLines(const TriangleMesh& mesh, std::vector<FormLine> lines)
{
    FormCuts cuts;
    cuts.lines = std::move(lines);
    return cutForm(mesh, cuts);
}

void expectSound(const Form& form)
{
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    EXPECT_TRUE(made.notes.empty());
    for (const Problem& problem : checkDesign(made.design))
        EXPECT_NE(problem.severity, Severity::Error) << problem.english();
    for (const FormSeam& seam : made.seams)
        EXPECT_NEAR(seam.first, seam.second, 0.2);
}

TEST(FormLines, DivideAPipe)
{
    const Form form = cutAlongLines(halfPipe(radius, height), {upright(std::numbers::pi / 3)});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 2U);
    std::vector<double> areas;
    for (const FlatPiece& flat : flatten(form, {}))
        areas.push_back(flat.area);
    std::ranges::sort(areas);
    const double whole = std::numbers::pi * radius * height;
    EXPECT_NEAR(areas[0], whole / 3, 0.01 * whole);
    EXPECT_NEAR(areas[1], whole * 2 / 3, 0.01 * whole);
    expectSound(form);
}

TEST(FormLines, GoOnToABorderThatIsNear)
{
    const Form form = cutAlongLines(halfPipe(radius, height), {upright(1.2, 6)});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 2U);
    EXPECT_TRUE(form.notes.empty());
    expectSound(form);
}

TriangleMesh plane()
{
    return gridMesh(20, 20, [](double u, double v) { return Vec3(500 * u, 500 * v, 0); });
}

/// Straight on they would pass it by.
TEST(FormLines, GoOnToALineThatIsNearAlsoAslantAndFromEndToEnd)
{
    const FormLine across{"Across", {{0, 250, 0}, {500, 250, 0}}, false};
    const FormLine aslant{"Aslant", {{0, 428.7, 0}, {300, 255.5, 0}}, false};
    const FormLine lower{"Lower", {{250, 0, 0}, {250, 250, 0}}, false};
    const FormLine upper{"Upper", {{254, 500, 0}, {254, 254, 0}}, false};
    for (const auto& [lines, pieces] :
         {std::pair(std::vector{across, aslant}, 3U), std::pair(std::vector{lower, upper}, 2U)}) {
        const Form form = cutAlongLines(plane(), lines);
        ASSERT_EQ(problemOf(form), "");
        EXPECT_EQ(form.pieces.size(), pieces);
        for (const Message& note : form.notes)
            ADD_FAILURE() << note.english();
        expectSound(form);
    }
}

/// Their sides lie beside each other all along, and are as good as equally long.
TEST(FormLines, MayWindInAPlanePiece)
{
    for (const auto& [count, turns, first, last] :
         {std::tuple(300, 0.6, 200, 200), std::tuple(500, 2.5, 220, 40), std::tuple(60, 1.4, 150, 60)}) {
        FormLine spiral{"Spiral", {}, false};
        for (int k = 0; k < count; ++k) {
            const double share = double(k) / (count - 1), away = first + share * (last - first);
            const double angle = 0.3 + 2 * std::numbers::pi * turns * share;
            spiral.points.emplace_back(250 + away * std::cos(angle), 250 + away * std::sin(angle), 0);
        }
        const Form form = cutAlongLines(plane(), {spiral});
        ASSERT_EQ(form.pieces.size(), 1u);
        expectSound(form);
    }
}

TEST(FormLines, ThatEndInsideAreCutInAndSayWhere)
{
    FormLine line = upright(1.5);
    std::erase_if(line.points, [](const Vec3& at) { return at.z() > height / 2; });
    const Form form = cutAlongLines(halfPipe(radius, height), {line});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 1U);
    ASSERT_EQ(form.notes.size(), 1U);
    EXPECT_NE(form.notes.front().english().find("Upright ends inside a piece"), std::string::npos);
    ASSERT_EQ(form.openEnds.size(), 1U);
    const OpenEnd& end = form.openEnds.front();
    EXPECT_EQ(end.line, "Upright");
    const auto fromAxis = [](const Vec3& at) { return std::hypot(at.x(), at.y()); };
    EXPECT_NEAR(end.way.front().z(), line.points.back().z(), 5);
    EXPECT_TRUE(form.notes.front().english().find(" mm away") != std::string::npos);
    const Vec3& border = end.way.back(); // above it, or one of the straight edges
    EXPECT_TRUE(std::abs(border.z() - height) < 1e-6 || std::abs(border.y()) < 1e-6);
    for (const Vec3& at : end.way)
        EXPECT_NEAR(fromAxis(at), radius, 0.5) << "on the form";

    // Along that way the piece is divided.
    line.points.insert(line.points.end(), end.way.begin(), end.way.end());
    const Form divided = cutAlongLines(halfPipe(radius, height), {line});
    EXPECT_EQ(divided.pieces.size(), 2U);
    EXPECT_TRUE(divided.openEnds.empty());
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    EXPECT_EQ(made.seams.size(), 1U) << "as a dart is sewn";
    expectSound(form);
}

/// Where the form is cut anyway: where it bends, too; and rather ahead than a little nearer beside.
TEST(FormLines, ThatEndInsideGoOnAheadToABend)
{
    const TriangleMesh roof = gridMesh(
        20, 20, [](double u, double v) { return Vec3(400 * (u - 0.5), 400 * v, -std::abs(400 * (u - 0.5))); });
    FormCuts cuts;
    cuts.angle = 30;
    cuts.lines = {{"Line", {{-200, 55, -200}, {-50, 55, -50}}, false}};
    const Form form = cutForm(roof, cuts);
    ASSERT_EQ(form.openEnds.size(), 1U);
    EXPECT_LT((form.openEnds.front().way.back() - Vec3(0, 55, 0)).norm(), 12)
        << "the ridge, 71 mm ahead, and not the border, 55 mm beside";
}

TEST(FormLines, MayCross)
{
    FormLine across{"Across", {}, false};
    for (int k = 0; k <= 60; ++k) {
        const double angle = std::numbers::pi * k / 60;
        across.points.emplace_back(-radius * std::cos(angle), -radius * std::sin(angle), 0.4 * height);
    }
    const Form form = cutAlongLines(halfPipe(radius, height), {upright(1), upright(2), across});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 6U);
    EXPECT_TRUE(form.notes.empty());
    expectSound(form);
}

TEST(FormLines, MayBeClosed)
{
    const TriangleMesh bowl = gridMesh(60, 60, [](double u, double v) {
        const double x = 400 * (u - 0.5), y = 400 * (v - 0.5);
        return Vec3(x, y, 60 - (x * x + y * y) / 1000);
    });
    FormLine circle{"Circle", {}, true};
    for (int k = 0; k < 48; ++k) {
        const double angle = 2 * std::numbers::pi * k / 48;
        circle.points.emplace_back(90 * std::cos(angle), 90 * std::sin(angle), 60 - 8.1);
    }
    const Form form = cutAlongLines(bowl, {circle});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 2U);
    ASSERT_EQ(form.notes.size(), 1U) << "the ring around it is cut open";
    expectSound(form);
}

TEST(FormLines, KeepThePartsOfTheForm)
{
    const TriangleMesh both =
        sideBySide(gridMesh(
                       10, 10, [](double u, double v) { return Vec3(200 * u, 200 * v, 0); }, "Left"),
                   gridMesh(
                       10, 10, [](double u, double v) { return Vec3(200 + 200 * u, 200 * v, 0); }, "Right"));
    FormLine line{"Line", {{0, 77, 0}, {400, 77, 0}}, false};
    const Form form = cutAlongLines(both, {line});
    ASSERT_EQ(problemOf(form), "");
    std::vector<std::string> names;
    for (const FormPiece& piece : form.pieces)
        names.push_back(piece.name);
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"Left", "Left 2", "Right", "Right 2"}));
}

/// The form falls apart there as at a border: no dart is left beyond it, and no end inside a piece.
TEST(FormLines, GoOnToWhereTheFormIsCutAnyway)
{
    const auto side = [](double from, const std::string& name) {
        return gridMesh(
            10, 10, [&](double u, double v) { return Vec3(from + 200 * u, 200 * v, from > 0 ? 100 * u : 0); },
            name);
    };
    const FormLine line{"Line", {{0, 77, 0}, {195, 77, 0}}, false};
    FormCuts parts, bends;
    parts.lines = bends.lines = {line};
    bends.groups = false;
    bends.angle = 20;
    for (const FormCuts& cuts : {parts, bends}) {
        const Form form = cutForm(sideBySide(side(0, "Left"), side(200, "Right")), cuts);
        ASSERT_EQ(problemOf(form), "");
        EXPECT_EQ(form.pieces.size(), 3U);
        for (const Message& note : form.notes)
            ADD_FAILURE() << note.english();
        const FormPattern made = formPattern(form, flatten(form, {}), {});
        EXPECT_EQ(made.seams.size(), 3U) << "a dart is one, too";
    }
}

TEST(FormLines, CutFormsWithEdgesOfThreeFaces)
{
    TriangleMesh book = gridMesh(2, 2, [](double u, double v) { return Vec3(100 * u, 100 * v, 0); });
    const TriangleMesh page = gridMesh(2, 2, [](double u, double v) { return Vec3(50, 100 * v, 100 * u); });
    book = sideBySide(book, page);
    const Form form = cutAlongLines(book, {{"Line", {{0, 30, 0}, {100, 30, 0}}, false}});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 5U) << "two of either half, and the page";
    ASSERT_FALSE(form.notes.empty());
    EXPECT_NE(form.notes.front().english().find("more than two faces"), std::string::npos);
}

TEST(FormLines, CutFormsWithOneSide)
{
    const TriangleMesh band = gridMesh(60, 8, [](double u, double v) {
        const double around = 2 * std::numbers::pi * u, across = 60 * (v - 0.5);
        const double out = 150 + across * std::cos(around / 2);
        return Vec3(out * std::cos(around), out * std::sin(around), across * std::sin(around / 2));
    });
    const FormLine line{"Line", {{0, 129, -21}, {0, 150, 0}, {0, 171, 21}}, false};
    const Form form = cutAlongLines(band, {line});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 2U) << "it is open where its outside meets its inside, too";
    EXPECT_NE(form.notes.front().english().find("one side only"), std::string::npos);
    expectSound(form);
}

/// A gentle sheet of 500 x 500 mm in squares of 12.5 mm.
double onSheet(double x, double y)
{
    return 40 * std::sin(x / 130) * std::cos(y / 140);
}

TriangleMesh sheet()
{
    constexpr std::uint32_t count = 40;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= count; ++i)
        for (std::uint32_t j = 0; j <= count; ++j) {
            const double x = 12.5 * i, y = 12.5 * j;
            mesh.points.emplace_back(x, y, onSheet(x, y));
        }
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j < count; ++j) {
            const std::uint32_t a = i * (count + 1) + j, b = a + count + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    return mesh;
}

FormLine acrossSheet(double x, double from, double to, double step)
{
    FormLine line{"Across", {}, false};
    const int count = static_cast<int>(std::round((to - from) / step));
    for (int k = 0; k <= count; ++k) {
        const double y = from + (to - from) * k / count;
        line.points.emplace_back(x, y, onSheet(x, y));
    }
    return line;
}

void expectTwoHalves(const FormLine& line)
{
    const Form form = cutAlongLines(sheet(), {line});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 2U);
    const std::vector<FlatPiece> flat = flatten(form, {});
    double area = 0;
    for (const FlatPiece& piece : flat) {
        EXPECT_GT(piece.area, 0.1e6);
        EXPECT_LT(piece.strainMost, 0.05) << "at most 2 % without what lies on edges";
        area += piece.area;
    }
    EXPECT_NEAR(area, 0.2575e6, 0.006e6);
    expectSound(form);
    formPattern(form, flat, {}).design.each<Patch>([](ElementId, const Patch& patch) {
        EXPECT_TRUE(std::isfinite(patch.grain));
    });
}

TEST(FormLines, MayRunAlongEdgesOfTheForm)
{
    for (const double step : {5.0, 10.0, 12.5, 20.0, 25.0, 50.0})
        for (const double x : {225.0, 231.0, 231.25}) {
            SCOPED_TRACE(std::to_string(x) + " in steps of " + std::to_string(step));
            expectTwoHalves(acrossSheet(x, 0, 500, step));
        }
}

TEST(FormLines, MayRunOnBeyondTheBorder)
{
    for (const double beyond : {0.1, 1.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0, 15.0, 30.0})
        for (const double x : {225.0, 255.0}) {
            SCOPED_TRACE(std::to_string(x) + " by " + std::to_string(beyond));
            expectTwoHalves(acrossSheet(x, -beyond, 500 + beyond, 5));
        }
}

TEST(FormLines, MayRingPlacesOfAForm)
{
    for (const int count : {8, 16, 40})
        for (const double middle : {250.0, 243.0, 237.5}) {
            SCOPED_TRACE(std::to_string(count) + " around " + std::to_string(middle));
            FormLine ring{"Ring", {}, true};
            for (int k = 0; k < count; ++k) {
                const double angle = 2 * std::numbers::pi * k / count;
                const double x = middle + 100 * std::cos(angle), y = middle + 100 * std::sin(angle);
                ring.points.emplace_back(x, y, onSheet(x, y));
            }
            const Form form = cutAlongLines(sheet(), {ring});
            ASSERT_EQ(problemOf(form), "");
            ASSERT_EQ(form.pieces.size(), 2U);
            for (const FlatPiece& piece : flatten(form, {})) {
                EXPECT_GT(piece.area, 0.02e6);
                EXPECT_LT(piece.turnedShare, 0.003);
            }
        }
}

TEST(FormLines, AlongTheBorderCutNothing)
{
    FormLine round{"Border", {}, true};
    const auto add = [&](double x, double y) { round.points.emplace_back(x, y, onSheet(x, y)); };
    for (int k = 0; k < 50; ++k)
        add(10 * k, 0);
    for (int k = 0; k < 50; ++k)
        add(500, 10 * k);
    for (int k = 0; k < 50; ++k)
        add(500 - 10 * k, 500);
    for (int k = 0; k < 50; ++k)
        add(0, 500 - 10 * k);
    const Form whole = cutAlongLines(sheet(), {round});
    EXPECT_EQ(whole.pieces.size(), 1U);
    ASSERT_EQ(whole.notes.size(), 1U);
    EXPECT_EQ(whole.notes[0].english(), "Border runs along the border of the form, or where it is cut anyway, at "
                                        "(500, 500, 23.55): there is nothing "
                                        "to cut");

    // Along the border, across, and back along it.
    FormLine across{"Across", {}, false};
    for (int k = 0; k < 20; ++k)
        across.points.emplace_back(12.5 * k, 0, onSheet(12.5 * k, 0));
    for (const Vec3& place : acrossSheet(253, 0, 500, 10).points)
        across.points.push_back(place);
    for (int k = 21; k <= 40; ++k)
        across.points.emplace_back(12.5 * k, 500, onSheet(12.5 * k, 500));
    expectTwoHalves(across);

    // Along the border, and off it in a bend.
    FormLine bends{"Bends", {}, false};
    const auto bend = [&](double x, double y) { bends.points.emplace_back(x, y, onSheet(x, y)); };
    for (int x = 20; x < 100; x += 5)
        bend(x, 0.1 * std::sin(x));
    for (int k = 0; k <= 60; ++k)
        bend(100 + 150 * std::sin(std::numbers::pi / 120 * k), 150 - 150 * std::cos(std::numbers::pi / 120 * k));
    for (int y = 160; y <= 500; y += 10)
        bend(250, y);
    expectTwoHalves(bends);
}

TEST(FormLines, FarFromTheFormChangeNothing)
{
    FormLine far = upright(1);
    for (Vec3& at : far.points)
        at += Vec3(5000, 0, 0);
    const Form form = cutAlongLines(halfPipe(radius, height), {far});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 1U);
    ASSERT_EQ(form.notes.size(), 1U);
    EXPECT_NE(form.notes.front().english().find("away from the form, at (4946, "), std::string::npos)
        << form.notes.front().english();
}

/// It seemed to end before the refused one, and to have its name.
TEST(FormLines, ThatAreRefusedLeadNobodyOn)
{
    const FormLine ends{"Ends", {{250, 0, 0}, {250, 200, 0}}, false};
    const FormLine away{"Away", {{250, 205, 0}, {250, 205, 300}, {250, 205, 600}}, false};
    const Form form = cutAlongLines(plane(), {away, ends});
    ASSERT_EQ(form.notes.size(), 2U);
    EXPECT_TRUE(form.notes[0].english().starts_with("Away is 300 mm away from the form, at (250, 205, 300): "))
        << form.notes[0].english();
    EXPECT_TRUE(form.notes[1].english().starts_with("Ends ends inside a piece, at (250, 201, 0): "))
        << form.notes[1].english();
    EXPECT_NE(form.notes[1].english().find("border is 299 mm away"), std::string::npos)
        << form.notes[1].english() << ", ahead, and not 201 mm back";
}

TEST(FormLines, WithoutLengthChangeNothing)
{
    const Form form = cutAlongLines(halfPipe(radius, height),
                                    {{"Point", {{0, -radius, 90}, {0, -radius, 90}}, false},
                                     {"Dot", {{0, -radius, 90}, {1, -radius, 90}, {1, -radius, 91}}, true},
                                     {"Huge", {{0, -radius, 90}, {1e300, 0, 0}}, false}});
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 1U);
    EXPECT_EQ(form.notes.size(), 3U) << "each says so";
}

/// A ring that is flat already opens nowhere where it is cut open.
TEST(FormRings, ThatAreFlatBecomePatches)
{
    const TriangleMesh sheet = gridMesh(20, 20, [](double u, double v) { return Vec3(200 * u, 200 * v, 0); });
    TriangleMesh ring = sheet;
    std::erase_if(ring.triangles, [&](const auto& t) {
        const Vec3 middle = (ring.points[t[0]] + ring.points[t[1]] + ring.points[t[2]]) / 3;
        return (middle - Vec3(100, 100, 0)).cwiseAbs().maxCoeff() < 40;
    });
    ring.parts = {{"Ring", 0, static_cast<std::uint32_t>(ring.triangles.size())}};
    const Form form = cutForm(ring, {});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 1U);
    expectSound(form);
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    EXPECT_EQ(made.seams.size(), 1U);
}

/// Flat already, around the z axis, between 60 and 160 mm; cut from there to there.
void expectOpenRing(double angle, double from, double to)
{
    FormLine line{"Line", {}, false};
    for (const double radius : {from, (from + to) / 2, to})
        line.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    const Form form = cutAlongLines(ringMesh(60, 160, 0, 64, 8), {line});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 1U);
    expectSound(form);
    EXPECT_EQ(formPattern(form, flatten(form, {}), {}).seams.size(), 1U);
}

TEST(FormRings, ThatAreFlatMayBeCutAnywhere)
{
    for (int k = 0; k < 32; ++k)
        for (const double beyond : {0.0, 5.0, -1.0}) {
            const double angle = 2 * std::numbers::pi * k / 32 + 0.001 * (k % 3);
            SCOPED_TRACE(std::to_string(angle) + " by " + std::to_string(beyond));
            expectOpenRing(angle, 60 - beyond, 160 + beyond);
        }
}

TEST(FormRings, MayBeCutTwice)
{
    FormLine left{"Left", {{-60, 0, 0}, {-160, 0, 0}}, false}, right{"Right", {{60, 0, 0}, {160, 0, 0}}, false};
    const Form form = cutAlongLines(ringMesh(60, 160, 0, 64, 8), {left, right});
    ASSERT_EQ(form.pieces.size(), 2U);
    expectSound(form);
}

TEST(FormLines, ThatComeBackToWhereTheyBeginAreClosed)
{
    for (const double missing : {0.0, 0.02, 0.08}) {
        FormLine round{"Round", {}, false};
        for (int k = 0; k <= 24; ++k) {
            const double angle = (2 * std::numbers::pi - missing) * k / 24;
            round.points.emplace_back(110 * std::cos(angle), 110 * std::sin(angle), 0);
        }
        const FormLine across{"Across", {{-60, 0, 0}, {-160, 0, 0}}, false};
        const Form form = cutAlongLines(ringMesh(60, 160, 0, 64, 8), {across, round});
        ASSERT_EQ(problemOf(form), "");
        EXPECT_EQ(form.pieces.size(), 2U);
        EXPECT_TRUE(form.notes.empty()) << form.notes.front().english();
        expectSound(form);
    }
}

TEST(FormLines, MaySlitAFlatSheet)
{
    const TriangleMesh sheet = gridMesh(20, 20, [](double u, double v) { return Vec3(400 * u, 300 * v, 0); });
    const Form form = cutAlongLines(sheet, {{"Slit", {{160, 150, 0}, {240, 150, 0}}, false}});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 1U);
    expectSound(form);
}

TEST(FormTwins, AreWhereTheFormIsSymmetric)
{
    const TriangleMesh both = sideBySide(
        gridMesh(
            12, 8, [](double u, double v) { return Vec3(-200 + 200 * u, 150 * v, 30 * u * u); }, "Right"),
        gridMesh(
            12, 8, [](double u, double v) { return Vec3(200 * u, 150 * v, 30 * (1 - u) * (1 - u)); }, "Left"));
    const Form form = cutForm(both, {});
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    int twins = 0;
    made.design.each<Patch>([&](ElementId, const Patch& patch) { twins += patch.twin.has_value(); });
    EXPECT_EQ(twins, 1);
    FormPatternOrder alone;
    alone.twins = false;
    const FormPattern single = formPattern(form, flatten(form, {}), alone);
    single.design.each<Patch>([&](ElementId, const Patch& patch) { EXPECT_FALSE(patch.twin); });
}

/// Edges of half a millimetre beside each other: a twin's outline brings corners, and ends of seams must not come
/// to lie at the wrong ones.
TEST(FormTwins, KeepTheSeamsOfVeryShortEdges)
{
    const auto block = [](double x0, double x1, double y0, double y1, const std::string& name) {
        const int rows = y1 - y0 > 1 ? 8 : 1;
        return gridMesh(
            6, rows, [&](double u, double v) { return Vec3(x0 + (x1 - x0) * u, y0 + (y1 - y0) * v, 0); }, name);
    };
    TriangleMesh all;
    for (const double side : {1.0, -1.0}) {
        const auto add = [&](double from, double to, double y0, double y1, const char* name) {
            const double a = side * from, b = side * to;
            const TriangleMesh part =
                block(std::min(a, b), std::max(a, b), y0, y1, std::string(name) + (side > 0 ? " left" : " right"));
            all = all.triangles.empty() ? part : sideBySide(all, part);
        };
        double y = 0;
        for (const double height : {40.0, 0.45, 0.35, 40.0}) {
            add(20, 100, y, y + height, "Strip");
            add(100, 160, y, y + height, "Outer");
            y += height;
        }
    }
    const Form form = cutForm(all, {});
    ASSERT_EQ(problemOf(form), "");
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    for (const FormSeam& seam : made.seams) {
        const auto* found = made.design.find<Seam>(seam.seam);
        ASSERT_TRUE(found);
        EXPECT_NEAR(stretchLength(made.design, found->a), seam.first, 0.5) << number(seam.seam);
        EXPECT_NEAR(stretchLength(made.design, found->b), seam.second, 0.5) << number(seam.seam);
    }
}

/// That is the same line twice, or one where the form falls apart anyway: it would leave crumbs.
TEST(FormLines, AreCutOnceWhereTheyLieOnEachOtherOrOnACut)
{
    const TriangleMesh both =
        sideBySide(gridMesh(
                       10, 10, [](double u, double v) { return Vec3(200 * u, 200 * v, 20 * u * u); }, "A"),
                   gridMesh(
                       10, 10, [](double u, double v) { return Vec3(200 + 200 * u, 200 * v, 20 + 40 * u); }, "B"));
    const FormLine middle{"Middle", {{-1, 100, 0}, {200, 100, 20}, {401, 100, 60}}, false};
    FormLine again = middle;
    again.name = "Again";
    const FormLine along{"Along", {{200.1, 0, 20}, {199.9, 100, 20}, {200.1, 200, 20}}, false};
    FormCuts cuts;
    cuts.lines = {middle, again, along};
    const Form form = cutForm(both, cuts);
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 4U);
    ASSERT_EQ(form.notes.size(), 2U);
    EXPECT_EQ(form.notes[0].english(), "Again runs along Middle, at (200, 100, 20): it is cut there once");
    EXPECT_NE(form.notes[1].english().find("Along runs along the border"), std::string::npos);
}

/// Smooth as it was: no needle among the triangles that stand in is taken for a bend, and none turns over.
TEST(FormOfManyTriangles, StaysSmooth)
{
    const TriangleMesh large = gridMesh(420, 420, [](double u, double v) {
        const double x = 600 * u - 300, y = 600 * v - 300;
        return Vec3(x, y, 120 - (x * x + y * y) / 1500);
    });
    ASSERT_GT(large.triangles.size(), mostFormTriangles);
    FormCuts cuts;
    cuts.angle = 20;
    const Form form = cutForm(large, cuts);
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.pieces.size(), 1U);
    EXPECT_LE(form.pieces.front().triangles.size(), mostFormTriangles);
    double narrowest = 1; // height over the longest side
    for (const auto& [a, b, c] : form.pieces.front().triangles) {
        const auto at = [&](int v) -> const Vec3& {
            return form.points[static_cast<std::size_t>(form.pieces.front().points[static_cast<std::size_t>(v)])];
        };
        const Vec3 ab = at(b) - at(a), ac = at(c) - at(a), bc = at(c) - at(b);
        narrowest = std::min(narrowest, ab.cross(ac).norm() /
                                            std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()}));
    }
    EXPECT_GT(narrowest, 0.02);
}

TEST(FormOfManyTriangles, IsMadeSimplerWithANote)
{
    const TriangleMesh large = gridMesh(400, 400, [](double u, double v) {
        return Vec3(1000 * u, 1000 * v, 50 * std::sin(3 * u) * std::cos(2 * v));
    });
    ASSERT_GT(large.triangles.size(), mostFormTriangles);
    const Form form = cutForm(large, {});
    ASSERT_EQ(problemOf(form), "");
    ASSERT_EQ(form.notes.size(), 1U);
    EXPECT_NE(form.notes.front().english().find("320000 triangles"), std::string::npos);
    EXPECT_EQ(form.pieces.size(), 1U);
}

/// Lines that stay are cut once; the pieces are those of a form that is cut anew, but for how closely lines follow
/// it.
TEST(FormLines, DraftsGoOnFromWhatStays)
{
    const TriangleMesh mesh = halfPipe(200, 400);
    const auto lineAt = [](const char* name, double z) {
        FormLine line{name, {}, false};
        for (int k = 0; k <= 30; ++k) {
            const double angle = std::numbers::pi * (1 + k / 30.0);
            line.points.emplace_back(200 * std::cos(angle), 200 * std::sin(angle), z);
        }
        return line;
    };
    const auto draft = newFormDraft();
    for (const double z : {100.0, 110.0, 125.0, 125.0, 90.0}) {
        FormCuts cuts;
        cuts.lines = {lineAt("stays", 300), lineAt("moves", z)};
        const Form quick = cutForm(mesh, cuts, {}, draft.get()), whole = cutForm(mesh, cuts);
        ASSERT_EQ(problemOf(quick), "");
        ASSERT_EQ(quick.pieces.size(), whole.pieces.size()) << z;
        std::vector<double> heights, wholeHeights; // of the pieces' middles
        for (const auto& [form, found] : {std::pair(&quick, &heights), std::pair(&whole, &wholeHeights)}) {
            for (const FormPiece& piece : form->pieces) {
                Box3 box;
                for (const int p : piece.points)
                    box.extend(form->points[static_cast<std::size_t>(p)]);
                found->push_back(box.center().z());
            }
            std::ranges::sort(*found);
        }
        for (std::size_t k = 0; k < heights.size(); ++k)
            EXPECT_NEAR(heights[k], wholeHeights[k], 0.3) << z;
    }
}

/// Drawn by hand, a little beside it now here and now there.
FormLine byHand(const std::vector<Vec3>& corners, double beside)
{
    FormLine line{"Line", {}, false};
    int step = 0;
    for (std::size_t k = 1; k < corners.size(); ++k)
        for (int i = 0; i <= 6; ++i, ++step)
            line.points.emplace_back(corners[k - 1] + (corners[k] - corners[k - 1]) * i / 6 +
                                     beside * Vec3(std::sin(step), std::sin(2.0 * step), std::cos(step)));
    return line;
}

constexpr double boxSide = 300, boxHeight = 200; // mm

/// It fell into crumbs on both sides of the edge.
TEST(FormLines, AlongSharpEdgesAreCutOnThem)
{
    const std::vector<Vec3> rim{{0, 0, boxHeight},
                                {boxSide, 0, boxHeight},
                                {boxSide, boxSide, boxHeight},
                                {0, boxSide, boxHeight},
                                {0, 0, boxHeight}};
    for (const double beside : {0.0, 0.3, 0.9}) {
        FormCuts cuts;
        cuts.groups = false;
        cuts.lines = {byHand(rim, beside)};
        for (const Vec3& corner : {rim[0], rim[1], rim[2], rim[3]})
            cuts.lines.push_back(byHand({Vec3(corner.x(), corner.y(), -3), corner}, beside));
        const Form form = cutForm(trayMesh({"x"}, boxSide, boxHeight), cuts);
        ASSERT_EQ(problemOf(form), "");
        for (const Message& note : form.notes)
            ADD_FAILURE() << beside << ": " << note.english();
        ASSERT_EQ(form.pieces.size(), 5U) << beside;
        for (const FlatPiece& flat : flatten(form, {})) {
            EXPECT_LT(flat.strainMost, 1e-6) << beside << ": cut on its edges a box is flat";
            EXPECT_TRUE(std::abs(flat.area - boxSide * boxSide) < 1 ||
                        std::abs(flat.area - boxSide * boxHeight) < 1)
                << beside << ": " << flat.area;
        }
        expectSound(form);
    }
}

/// Along an edge to its middle, and from there down a side.
TEST(FormLines, MayLeaveSharpEdges)
{
    for (const double beside : {0.0, 0.3, 0.9}) {
        FormCuts cuts;
        cuts.groups = false;
        const Vec3 middle(boxSide / 2, 0, boxHeight);
        cuts.lines = {byHand({Vec3(0, -2, -1), Vec3(0, 0, boxHeight), middle, Vec3(middle.x(), 0, -1)}, beside)};
        const Form form = cutForm(trayMesh({"x"}, boxSide, boxHeight), cuts);
        ASSERT_EQ(problemOf(form), "");
        EXPECT_TRUE(form.notes.empty()) << beside << ": " << form.notes.front().english();
        ASSERT_EQ(form.pieces.size(), 2U) << beside;
        std::vector<double> areas;
        for (const FlatPiece& flat : flatten(form, {}))
            areas.push_back(flat.area);
        EXPECT_NEAR(std::ranges::min(areas), boxSide / 2 * boxHeight, 0.01 * boxSide * boxHeight) << beside;
    }
}

/// A sliver that was flipped kept its part, and half of its neighbour got it: another face was cut from corner to
/// corner.
TEST(FormLines, BesideAnEdgeCutNoOtherFace)
{
    const TriangleMesh tray = trayMesh({"x x", "xxx"}, 200, 100);
    const FormLine line{
        "Beside", {{5.337, 0, 92.92}, {201.457, 0, 91.279}, {397.576, 0, 92.835}, {593.684, 0, 95.104}}, false};
    const Form form = cutAlongLines(tray, {line});
    ASSERT_EQ(problemOf(form), "");
    double top = 0;
    const std::vector<FlatPiece> flat = flatten(form, {});
    for (std::size_t p = 0; p < flat.size(); ++p)
        top += form.pieces[p].part == "Top" ? flat[p].area : 0;
    EXPECT_NEAR(top, 5 * 200 * 200, 1);
    EXPECT_EQ(form.pieces.size(), 3U) << "the top, what is above the line and what is below it";
}

/// What holds a bench's cover runs along the edges of its foam, a little beside them.
TEST(FormLines, CurvesAlongTheSharpEdgesOfAFrameDivideIt)
{
    const std::string folder = samplesFolder() + "/../templates/";
    const ImportedMesh mesh = importMesh(QString::fromStdString(folder + "bench-foam.obj"));
    ASSERT_TRUE(mesh.mesh);
    const Form form = cutAlongLines(*mesh.mesh, linesOf(designIn(folder + "bench.json")));
    ASSERT_EQ(problemOf(form), "");
    EXPECT_EQ(form.pieces.size(), 6U);
    for (const FlatPiece& flat : flatten(form, {}))
        EXPECT_LT(flat.strainMost, 1e-4);
}

/// Curves by the rounded edges of frames made cuts that went through themselves: CGAL came to no end with some of
/// them, and crashed with others. What is not cut is said.
TEST(FormLines, CurvesByRoundedEdgesOfFramesAreCutOrLeftOut)
{
    const std::string folder = samplesFolder() + "/../templates/";
    for (const auto& [design, frame] :
         {std::pair("dining-chair", "dining-chair-board"), std::pair("dining-chair", "dining-chair-wood"),
          std::pair("wing-chair", "wing-chair-body")}) {
        const ImportedMesh mesh = importMesh(QString::fromStdString(folder + frame + ".obj"));
        ASSERT_TRUE(mesh.mesh) << frame;
        FormCuts cuts;
        const auto sheets = [](const Form& cut) { return std::ranges::count_if(cut.pieces, &FormPiece::isSheet); };
        const auto uncut = sheets(cutForm(*mesh.mesh, cuts));
        cuts.lines = linesOf(designIn(folder + design + ".json"));
        ASSERT_FALSE(cuts.lines.empty());
        const Form form = cutForm(*mesh.mesh, cuts);
        const auto sharp = [](const Message& note) {
            return note.key.find("bends too sharply at") != std::string::npos ||
                   note.key.find("The form goes through itself at") != std::string::npos;
        };
        EXPECT_TRUE(sheets(form) > uncut || std::ranges::any_of(form.notes, sharp) || problemOf(form) != "")
            << frame;
        EXPECT_NO_THROW(formPattern(form, flatten(form, {}), {})) << frame;
    }
}

/// All of its faces look outwards.
TriangleMesh boxMesh(const Vec3& low, const Vec3& high, const std::string& name)
{
    TriangleMesh mesh;
    for (const double z : {low.z(), high.z()})
        for (const auto& [x, y] : {std::pair(low.x(), low.y()), std::pair(high.x(), low.y()),
                                   std::pair(high.x(), high.y()), std::pair(low.x(), high.y())})
            mesh.points.emplace_back(x, y, z);
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t next = (k + 1) % 4;
        mesh.triangles.push_back({k, next, next + 4});
        mesh.triangles.push_back({k, next + 4, k + 4});
    }
    mesh.parts = {{name, 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

/// As an arm that stands in a seat does: the line lies on the arm, and what it crosses of the seat stays whole.
TEST(FormLines, GoAroundWhatStandsInSomethingElse)
{
    const TriangleMesh arm = boxMesh({0, 0, 0}, {100, 100, 400}, "Arm"),
                       seat = boxMesh({-200, 50, 100}, {300, 600, 200}, "Seat");
    const FormLine around{"Around", {{50, 0, 0}, {50, 100, 0}, {50, 100, 400}, {50, 0, 400}}, true};
    const Form form = cutAlongLines(sideBySide(arm, seat), {around});
    EXPECT_TRUE(form.problem.empty()) << form.problem.english();
    ASSERT_EQ(form.notes.size(), 1U);
    EXPECT_NE(form.notes.front().english().find("go through each other"), std::string::npos);
    ASSERT_EQ(form.pieces.size(), 3U);
    for (const FormPiece& piece : form.pieces)
        EXPECT_EQ(piece.isSheet(), piece.part == "Arm") << piece.name << ": the seat is closed all around";
}

/// Points every few millimetres are as good as few: sections of the ribbon around an edge crossed inside the form.
TEST(FormLines, OfManyPointsGoOverEdgesThatAreNotCut)
{
    const double side = 400, height = 100;
    FormCuts cuts;
    cuts.groups = false;
    for (const double step : {1.3, 7.0, 50.0})
        for (const TriangleMesh& box :
             {trayMesh({"x"}, side, height), quartered(quartered(trayMesh({"x"}, side, height)))}) {
            FormLine line{"Line", {}, false};
            for (double z = 0; z < height; z += step)
                line.points.emplace_back(0, 235.5, z);
            for (double x = 0; x < side; x += step)
                line.points.emplace_back(x, 235.5, height);
            for (double z = height; z > 0; z -= step)
                line.points.emplace_back(side, 235.5, z);
            line.points.emplace_back(side, 235.5, 0);
            cuts.lines = {line};
            const Form form = cutForm(box, cuts);
            EXPECT_EQ(form.pieces.size(), 2U) << step;
            EXPECT_TRUE(form.notes.empty()) << step << ": " << form.notes.front().english();
        }
}

/// Nobody means the few millimetres that a line goes on behind an edge, beside the form or down the next face.
TEST(FormLines, EndOnTheEdgesThatTheyAreDrawnOver)
{
    const double side = 300, height = 80;
    const TriangleMesh box = trayMesh({"x"}, side, height);
    for (const double over : {0.0, 1.0, 2.5, 3.3, 4.0, 4.8})
        for (const bool down : {false, true})
            for (const double angle : {30.0, 100.0}) {
                const Vec3 begin(0, 90, height), end(side, 170, height);
                const Vec3 way = over * (end - begin).normalized();
                FormLine line{"Line", {begin - way, end + way}, false};
                if (down)
                    line.points = {begin - over * Vec3::UnitZ(), begin, end, end - over * Vec3::UnitZ()};
                const Form form = cutForm(box, {angle > 90, angle, {line}});
                EXPECT_EQ(form.pieces.size(), angle > 90 ? 3U : 6U) << over << ", " << down;
                const FormPattern made = formPattern(form, flatten(form, {}), {});
                EXPECT_EQ(std::ranges::count(made.patches, noElement), 0) << over << ", " << down;
                for (const FormPiece& piece : form.pieces)
                    for (const int vertex : piece.border) {
                        const Vec3& at = form.points[piece.points[vertex]];
                        EXPECT_TRUE(at.z() > height - 0.01 || at.z() < 0.01)
                            << "a cut into a wall, at " << at.transpose();
                    }
            }
}

/// Its end lies on the border; the next corner is within reach, but lies along the border.
TEST(FormLines, ThatEndAtABorderNeedNotGoOnToItsCorner)
{
    TriangleMesh top;
    top.points.emplace_back(0, 0, 0);
    for (int k = 0; k < 5; ++k) {
        const double angle = k * 2 * std::numbers::pi / 5;
        top.points.emplace_back(300 * std::cos(angle), 300 * std::sin(angle), 0);
        top.triangles.push_back({0U, k + 1U, (k + 1) % 5 + 1U});
    }
    top.parts = {{"Top", 0, 5}};
    const FormLine line{
        "Line",
        {Vec3(298.0940382287631, -2.6233313230397357, 0), Vec3(-242.70509831248427, -73.53369980227504, 0)},
        false};
    const Form form = cutForm(top, {false, std::nullopt, {line}});
    ASSERT_EQ(form.pieces.size(), 2U);
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    EXPECT_EQ(std::ranges::count(made.patches, noElement), 0);
}

/// Three points around a corner of a box: where they are cut into its edges, edges of some nanometres were left,
/// and the design of that ended the program.
TEST(FormLines, LoopsAroundACornerMakeDesignsThatCanBeSewn)
{
    std::mt19937 random(7);
    const auto between = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    const Vec3 corner(0, 0, 180);
    for (int round = 0; round < 60; ++round) {
        FormLine loop{"Loop", {}, true};
        loop.points = {corner + Vec3(between(8, 60), between(8, 60), 0),
                       corner + Vec3(0, between(8, 60), -between(8, 60)),
                       corner + Vec3(between(8, 60), 0, -between(8, 60))};
        const Form form = cutForm(trayMesh({"x"}, 300, 180), {false, 15, {loop}});
        const FormPattern made = formPattern(form, flatten(form, {}), {});
        for (const Problem& problem : checkDesign(made.design))
            EXPECT_NE(problem.severity, Severity::Error) << round << ": " << problem.english();
        for (const Problem& problem : sampleOutlines(made.design).problems)
            ADD_FAILURE() << round << ": " << problem.english();
    }
}

/// The strip between such a line and the edge went to the face around the edge, which lay over itself then.
TEST(FormLines, AStripBelowAnEdgeStaysOnItsFace)
{
    const double side = 300, height = 80;
    for (const double deep : {4.5, 6.0, 9.0})
        for (const double shallow : {1.5, 4.2}) {
            const FormLine line{"Line", {Vec3(50, 0, height - deep), Vec3(250, 0, height - shallow)}, false};
            const Form form = cutForm(trayMesh({"x"}, side, height), {false, 30, {line}});
            const std::vector<FlatPiece> flat = flatten(form, {});
            const FormPattern made = formPattern(form, flat, {});
            EXPECT_EQ(std::ranges::count(made.patches, noElement), 0) << deep << ", " << shallow;
            const double largest = std::ranges::max(flat, {}, &FlatPiece::area).area;
            EXPECT_NEAR(largest, side * side, 1) << "the top; " << deep << ", " << shallow;
        }
}

/// CGAL numbers some of the edges that it makes by where they lie in memory.
TEST(FormLines, AreCutTheSameWhateverElseIsInMemory)
{
    std::mt19937 random(5);
    FormLine loop{"Loop", {}, true};
    for (int k = 0; k < 24; ++k) {
        const double angle = k * std::numbers::pi / 12;
        loop.points.emplace_back(150 + 40 * std::cos(angle), 40 * std::sin(angle), 60);
    }
    const TriangleMesh prism = quartered(quartered(hollowPrism(5, 300, 60)));
    const Form first = cutForm(prism, {false, 30, {loop}});
    std::vector<std::vector<char>> others;
    for (int round = 0; round < 20; ++round) {
        for (int k = 0; k < 2000; ++k)
            others.emplace_back(16 + random() % 2000);
        std::erase_if(others, [&](const auto&) { return random() % 2 == 0; });
        const Form again = cutForm(prism, {false, 30, {loop}});
        ASSERT_EQ(again.points, first.points) << round;
        ASSERT_EQ(again.pieces.size(), first.pieces.size()) << round;
        for (std::size_t p = 0; p < first.pieces.size(); ++p)
            ASSERT_EQ(again.pieces[p].triangles, first.pieces[p].triangles) << round;
    }
}

/// What is said of lines is not said of bends.
TEST(FormLines, ABendThatFadesOutIsNoLineThatEndsInside)
{
    const TriangleMesh sheet = gridMesh(20, 20, [](double u, double v) {
        return Vec3(400 * u, 400 * v, 200 * std::abs(u - 0.5) * std::max(0.0, 1 - 1.2 * v));
    });
    const FormLine line{"Line", {Vec3(0, 380, 0), Vec3(400, 380, 0)}, false};
    const Form form = cutForm(sheet, {false, 20, {line}});
    EXPECT_EQ(form.pieces.size(), 2U);
    EXPECT_TRUE(form.notes.empty()) << form.notes.front().english();
    const Form uncut = cutForm(sheet, {false, 20, {}});
    const auto edgesInside = [](const Form& of) {
        return std::ranges::count_if(of.pieces.front().mates, [](const EdgeMate& mate) { return mate.piece == 0; });
    };
    EXPECT_GT(edgesInside(uncut), 4) << "it is cut in there";
    EXPECT_EQ(edgesInside(form), edgesInside(uncut));
}

/// It ran along the edges of the inner corner there, and was said to bend too sharply.
TEST(FormLines, MayLeaveTheFormAndComeBack)
{
    const double side = 200, height = 60;
    const TriangleMesh tray = trayMesh({"x ", "xx"}, side, height);
    for (const double outside : {4.0, 25.0, 90.0})
        for (const TriangleMesh& form : {tray, quartered(quartered(quartered(tray)))}) {
            const Vec3 from(outside, 2 * side, height), to(2 * side, outside, height);
            const Form cut = cutForm(form, {false, 60, {{"Line", {from, to}, false}}});
            const std::vector<FlatPiece> flat = flatten(cut, {});
            const FormPattern made = formPattern(cut, flat, {});
            EXPECT_EQ(std::ranges::count(made.patches, noElement), 0) << outside;
            EXPECT_EQ(cut.pieces.size(), 9U) << "six walls, and the top in three; " << outside;
            EXPECT_TRUE(cut.notes.empty()) << outside << ": " << cut.notes.front().english();
        }
}

} // namespace
} // namespace bolster::test
