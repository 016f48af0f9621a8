// Fancy seams: the depth is reached in the middle, the outer lines stay on the surface, no gap opens.
#include "TestDesigns.h"

#include "DesignCheck.h"
#include "OutlineSampling.h"
#include "PreparedSheet.h"
#include "SolvePlan.h"
#include "SolverThread.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster::test {
namespace {

FancySeam fancy(ElementId patch, BSpline2 curve, double width = 16, double depth = 5,
                Profile profile = Profile::Round)
{
    FancySeam seam;
    seam.name = "Groove";
    seam.patch = patch;
    seam.curve = std::move(curve);
    seam.width = width;
    seam.depth = depth;
    seam.profile = profile;
    return seam;
}

/// A flat sheet that hangs between two rails at x = 0 and x = 400, with raw edges at y = 0 and y = 300.
struct Sheet {
    DesignBuilder builder;
    ElementId patch;

    explicit Sheet(double edge = 12, double height = 0)
        : builder(edge)
    {
        patch = builder.patch(rectangle(400, 300), builder.fabric(0.3, 6));
        builder.fix({patch, 1, 2}, polyline({{400, 0, height}, {400, 300, height}}));
        builder.fix({patch, 3, 4}, polyline({{0, 300, height}, {0, 0, height}}));
    }
};

double zAt(const SurfaceMesh& surface, std::uint32_t v)
{
    return surface.positions[v].z();
}

TEST(FancySeam, ReachesItsDepthInTheMiddleAndLeavesTheOuterLines)
{
    for (const Profile profile : {Profile::Round, Profile::Sharp, Profile::Welt})
        for (const double depth : {5.0, -3.0}) {
            SCOPED_TRACE(depth);
            Sheet sheet;
            const ElementId id = sheet.builder.add(
                fancy(sheet.patch, BSpline2(1, false, {{200, 0}, {200, 300}}), 16, depth, profile));
            const SolveResult result = solved(sheet.builder.design());
            const SurfaceMesh& surface = *result.surface;
            int lines = 0;
            for (const auto& line : surface.topology->lines) {
                ASSERT_EQ(line.element, id);
                ++lines;
                for (std::uint32_t v : line.vertices) {
                    EXPECT_NEAR(zAt(surface, v), -depth * fancyProfile(profile, line.across), 1e-6);
                    EXPECT_NEAR(surface.topology->pattern[v].x(), 200 - 8 * line.across, 1e-9);
                }
            }
            EXPECT_EQ(lines, 7);
            ASSERT_EQ(result.report.fancySeams.size(), 1u);
            EXPECT_NEAR(result.report.fancySeams[0].value, depth, 1e-12);
            EXPECT_EQ(result.report.flippedTriangles, 0);
            EXPECT_GT(result.report.strain.max, 0.02) << "strain is that of what is seen";
        }
}

TEST(FancySeam, ItsProfilesAreWhatTheirNamesSay)
{
    for (const Profile profile : {Profile::Round, Profile::Sharp, Profile::Welt}) {
        EXPECT_EQ(fancyProfile(profile, 0), 1);
        for (const double side : {-1.0, 1.0}) {
            EXPECT_NEAR(fancyProfile(profile, side), 0, 1e-15);
            EXPECT_NEAR(fancyProfile(profile, 2 * side), 0, 1e-15);
            EXPECT_EQ(fancyProfile(profile, 0.3), fancyProfile(profile, 0.3 * side));
        }
    }
    EXPECT_GT(fancyProfile(Profile::Welt, 0.5), fancyProfile(Profile::Round, 0.5));
    EXPECT_GT(fancyProfile(Profile::Round, 0.5), fancyProfile(Profile::Sharp, 0.5));
}

TEST(FancySeam, FadesOutWhereItIsFixedSewnOrEnds)
{
    Sheet sheet;
    sheet.builder.add(fancy(sheet.patch, BSpline2(1, false, {{0, 100}, {400, 100}})));
    sheet.builder.add(fancy(sheet.patch, BSpline2(1, false, {{100, 200}, {300, 200}})));
    const SolveResult result = solved(sheet.builder.design());
    const SurfaceMesh& surface = *result.surface;
    ASSERT_FALSE(surface.topology->lines.empty());
    for (const auto& line : surface.topology->lines) {
        EXPECT_NEAR(zAt(surface, line.vertices.front()), 0, 1e-9);
        EXPECT_NEAR(zAt(surface, line.vertices.back()), 0, 1e-9);
        if (line.across == 0) {
            EXPECT_NEAR(zAt(surface, line.vertices[line.vertices.size() / 2]), -5, 1e-6);
        }
    }
    EXPECT_LT(result.report.fixationError.max, 1e-9);

    const SolveResult sewn = [] {
        DesignBuilder b(12);
        const ElementId fabric = b.fabric(0.3, 6);
        const ElementId left = b.patch(rectangle(200, 200), fabric), right = b.patch(rectangle(200, 200), fabric);
        b.seam({left, 1, 2}, {right, 3, 4});
        b.fix({left, 3, 4}, polyline({{0, 200, 0}, {0, 0, 0}}));
        b.fix({right, 1, 2}, polyline({{400, 0, 0}, {400, 200, 0}}));
        b.add(fancy(left, BSpline2(1, false, {{0, 90}, {200, 110}})));
        return solved(b.design());
    }();
    EXPECT_EQ(sewn.report.seamGap.max, 0);
    EXPECT_NEAR(sewn.report.fancySeams[0].value, 5, 1e-9);
}

TEST(FancySeam, AShortOneReachesLessAndTheReportSaysSo)
{
    Sheet sheet;
    sheet.builder.add(fancy(sheet.patch, BSpline2(1, false, {{200, 150}, {220, 150}}), 16, 5));
    const SolveResult result = solved(sheet.builder.design());
    EXPECT_LT(result.report.fancySeams[0].value, 4);
    EXPECT_GT(result.report.fancySeams[0].value, 0.5);
}

TEST(FancySeam, FollowsTheSurface)
{
    Sheet low, high(12, 50);
    const BSpline2 curve(1, false, {{200, 0}, {200, 300}});
    low.builder.add(fancy(low.patch, curve));
    high.builder.add(fancy(high.patch, curve));
    const SolveResult a = solved(low.builder.design()), b = solved(high.builder.design());
    ASSERT_EQ(a.surface->positions.size(), b.surface->positions.size());
    for (std::size_t v = 0; v < a.surface->positions.size(); ++v)
        EXPECT_LT((a.surface->positions[v] + Vec3(0, 0, 50) - b.surface->positions[v]).norm(), 1e-5);
}

TEST(FancySeam, HasNoEffectOnTheSurfaceBesideIt)
{
    Design plain = box(200, 60, 10, 4, 0.3);
    const ElementId top = [&] {
        ElementId first{};
        plain.each<Patch>([&](ElementId id, const Patch&) { first = first == noElement ? id : first; });
        return first;
    }();
    const auto with = [&](double depth) {
        return plain.with({{},
                           {{plain.nextId(), nullptr,
                             makeElement(fancy(top, BSpline2(1, false, {{100, 0}, {100, 200}}), 16, depth))}}});
    };
    const SolveResult shallow = solved(with(0)), deep = solved(with(6));
    ASSERT_EQ(shallow.surface->positions.size(), deep.surface->positions.size());
    std::set<std::uint32_t> inside;
    for (const auto& line : deep.surface->topology->lines)
        if (std::abs(line.across) < 1)
            inside.insert(line.vertices.begin(), line.vertices.end());
    for (std::uint32_t v = 0; v < deep.surface->topology->vertexCount(); ++v)
        if (!inside.contains(v)) {
            EXPECT_EQ(shallow.surface->positions[v], deep.surface->positions[v]);
        }
    EXPECT_EQ(shallow.report.iterations, deep.report.iterations);
    double most = 0;
    for (std::uint32_t v : inside)
        most = std::max(most, (shallow.surface->positions[v] - deep.surface->positions[v]).norm());
    EXPECT_NEAR(most, 6, 1e-6);
}

TEST(FancySeam, TurnsCornersAndClosesLoops)
{
    const std::vector<BSpline2> curves = {
        BSpline2(1, false, {{100, 0}, {100, 150}, {300, 150}, {300, 300}}),
        BSpline2(1, false, {{100, 80}, {200, 220}, {300, 80}}),
        BSpline2(1, true, {{100, 80}, {300, 80}, {300, 220}, {100, 220}}),
        BSpline2(3, true, {{100, 80}, {300, 80}, {300, 220}, {100, 220}}),
        BSpline2(3, false, {{-20, 80}, {100, 250}, {300, 20}, {430, 200}}),
    };
    for (std::size_t k = 0; k < curves.size(); ++k)
        for (const double width : {3.0, 16.0, 40.0}) {
            SCOPED_TRACE(std::to_string(k) + " " + std::to_string(width));
            Sheet sheet;
            const ElementId id = sheet.builder.add(fancy(sheet.patch, curves[k], width));
            TriangulationCache cache;
            const PreparedSheet prepared = *prepareSheet(sheet.builder.design(), cache);
            for (const Problem& problem : prepared.errors)
                ADD_FAILURE() << problem.english();
            ASSERT_FALSE(prepared.mesh.reliefs.empty());
            EXPECT_EQ(prepared.mesh.reliefs[0].seam, id);
            EXPECT_GT(leastAngle(prepared.mesh), 5);
            for (const auto& line : prepared.mesh.topology->lines) {
                EXPECT_EQ(line.vertices.front() == line.vertices.back(), curves[k].closed());
                for (std::uint32_t v : line.vertices) {
                    const double distance = curves[k].closest(prepared.mesh.rest()[v]).distance;
                    EXPECT_LT(distance, std::abs(line.across) * width / 2 * 1.8 + 1) << "at most mitred";
                    if (distance < std::abs(line.across) * width / 2 - 0.05 * width - 0.1) {
                        ADD_FAILURE() << "too near at " << prepared.mesh.rest()[v].transpose();
                    }
                }
            }
        }
}

TEST(FancySeam, MakesDecentTriangles)
{
    for (const double width : {4.0, 12.0, 30.0})
        for (const double slope : {0.0, 30.0, 90.0}) {
            SCOPED_TRACE(std::to_string(width) + " " + std::to_string(slope));
            Sheet sheet;
            sheet.builder.add(
                fancy(sheet.patch, BSpline2(1, false, {{200 - slope, 0}, {200 + slope, 300}}), width));
            TriangulationCache cache;
            const PreparedSheet prepared = *prepareSheet(sheet.builder.design(), cache);
            ASSERT_FALSE(hasErrors(prepared.errors)) << prepared.errors[0].english();
            EXPECT_GT(leastAngle(prepared.mesh), 12);
        }
}

struct RefusedFancySeam {
    const char* name;
    BSpline2 curve;
    double width;
    const char* expected;
};

void PrintTo(const RefusedFancySeam& refusal, std::ostream* out)
{
    *out << refusal.name;
}

class FancyRefusal : public testing::TestWithParam<RefusedFancySeam> {};

TEST_P(FancyRefusal, NamesTheSeamAndTheRemedy)
{
    Sheet sheet;
    sheet.builder.add(fancy(sheet.patch, BSpline2(1, false, {{50, 250}, {350, 250}})));
    const ElementId bad = sheet.builder.add(fancy(sheet.patch, GetParam().curve, GetParam().width));
    const Problems problems = sampleOutlines(sheet.builder.design()).problems;
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, bad);
    EXPECT_NE(problems[0].english().find(GetParam().expected), std::string::npos) << problems[0].english();
    SolveOptions options;
    options.lenient = true;
    EXPECT_EQ(solveResting(sheet.builder.design(), options).status, SolveResult::Status::Solved);
}

INSTANTIATE_TEST_SUITE_P(
    All, FancyRefusal,
    testing::Values(
        RefusedFancySeam{"CrossingAnother", BSpline2(1, false, {{200, 0}, {200, 300}}), 16, "crosses Groove, or"},
        RefusedFancySeam{"OverlappingAnother", BSpline2(1, false, {{50, 236}, {350, 236}}), 16,
                         "crosses Groove, or"},
        RefusedFancySeam{"Loop", BSpline2(1, false, {{50, 50}, {250, 200}, {330, 120}, {250, 40}, {50, 190}}), 16,
                         "itself"},
        RefusedFancySeam{"TightBend", BSpline2(3, false, {{100, 50}, {200, 50}, {200, 70}, {100, 70}}), 60,
                         "bends too sharply"},
        RefusedFancySeam{"Hairpin", BSpline2(1, false, {{100, 100}, {300, 110}, {100, 120}}), 6,
                         "bends too sharply"},
        RefusedFancySeam{"TooWide", BSpline2(1, false, {{100, 50}, {300, 50}}), 110, "beyond its patch"},
        RefusedFancySeam{"TooNarrow", BSpline2(1, false, {{100, 50}, {300, 50}}), 1, "too narrow"},
        RefusedFancySeam{"Outside", BSpline2(1, false, {{500, 50}, {600, 50}}), 16, "outside its patch"},
        RefusedFancySeam{"LeavesAndComesBack", BSpline2(2, false, {{100, 50}, {200, -150}, {300, 50}}), 16,
                         "comes back"},
        RefusedFancySeam{"Flat", BSpline2(1, false, {{20, 0}, {380, 60}}), 16, "outline"}),
    [](const auto& test) { return test.param.name; });

TEST(FancySeam, PlansAreAsLightAsCanBe)
{
    Sheet sheet;
    const ElementId id = sheet.builder.add(fancy(sheet.patch, BSpline2(1, false, {{100, 100}, {300, 100}})));
    const Design& design = sheet.builder.design();
    const auto planWith = [&](auto change) {
        FancySeam changed = *design.find<FancySeam>(id);
        change(changed);
        return planSolve(design, design.with({{}, {{id, design.element(id), makeElement(changed)}}}));
    };
    EXPECT_EQ(planWith([](FancySeam& s) { s.name = "Other"; }), SolvePlan::Nothing);
    EXPECT_EQ(planWith([](FancySeam& s) { s.depth = 1; }), SolvePlan::Republish);
    EXPECT_EQ(planWith([](FancySeam& s) { s.profile = Profile::Welt; }), SolvePlan::Republish);
    EXPECT_EQ(planWith([](FancySeam& s) { s.width = 9; }), SolvePlan::Warp);
    EXPECT_EQ(planSolve(design, design.with({{}, {{id, design.element(id), nullptr}}})), SolvePlan::Rebuild);
}

} // namespace
} // namespace bolster::test
