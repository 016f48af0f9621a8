// Handle curves: embedded exactly, held exactly, refused where they cannot be embedded.
#include "TestDesigns.h"

#include "DesignCheck.h"
#include "HandleEdits.h"
#include "OutlineSampling.h"
#include "PatternLocator.h"
#include "PreparedSheet.h"
#include "SolvePlan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace bolster::test {
namespace {

/// A closed cubic very near a circle.
BSpline2 flatCircle(const Vec2& centre, double radius)
{
    std::vector<Vec2> points;
    const BSpline3 round = circle(radius, 0);
    for (const Vec3& p : round.points())
        points.emplace_back(centre + p.head<2>());
    return BSpline2(3, true, std::move(points));
}

BSpline3 raised(const BSpline2& curve, double z)
{
    std::vector<Vec3> points;
    for (const Vec2& p : curve.points())
        points.emplace_back(p.x(), p.y(), z);
    return BSpline3(curve.degree(), curve.closed(), std::move(points), curve.knots());
}

HandleCurve handle(ElementId patch, BSpline2 curve, double z)
{
    HandleCurve handle;
    handle.name = "Handle";
    handle.patch = patch;
    handle.target = raised(curve, z);
    handle.curve = std::move(curve);
    return handle;
}

/// A flat square, fixed all round at z = 0 to where it lies in the pattern.
struct Square {
    DesignBuilder builder;
    ElementId patch;

    explicit Square(double size = 400, double edge = 12)
        : builder(edge)
    {
        patch = builder.patch(rectangle(size, size), builder.fabric(0, 0));
        builder.fix({patch, 0, 0}, polyline({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}}, true));
    }
};

const SurfaceTopology::Line& lineOf(const SurfaceMesh& surface, ElementId element)
{
    for (const SurfaceTopology::Line& line : surface.topology->lines)
        if (line.element == element)
            return line;
    ADD_FAILURE() << "no line";
    static const SurfaceTopology::Line none;
    return none;
}

TEST(Handle, ARaisedCircleMakesATent)
{
    Square square;
    const double height = 60;
    const ElementId id = square.builder.add(handle(square.patch, flatCircle({200, 200}, 80), height));
    const SolveResult result = solved(square.builder.design());
    const SurfaceMesh& surface = *result.surface;
    const auto& line = lineOf(surface, id);
    ASSERT_GT(line.vertices.size(), 30u);
    EXPECT_EQ(line.vertices.front(), line.vertices.back());
    for (std::uint32_t v : line.vertices) {
        EXPECT_NEAR(surface.positions[v].z(), height, 1e-9);
        EXPECT_NEAR((surface.positions[v].head<2>() - Vec2(200, 200)).norm(), 80, 0.05);
        EXPECT_LT((surface.positions[v].head<2>() - surface.topology->pattern[v]).norm(), 0.05);
    }
    for (std::uint32_t v = 0; v < surface.topology->vertexCount(); ++v) {
        const Vec2& rest = surface.topology->pattern[v];
        const double radius = (rest - Vec2(200, 200)).norm();
        if (radius < 79) {
            EXPECT_GT(surface.positions[v].z(), height - 0.1)
                << "the lid is round, for cloth passes the handle smoothly";
            EXPECT_LT(surface.positions[v].z(), height + 0.2 * (80 - radius) + 3);
        } else {
            EXPECT_GT(surface.positions[v].z(), -0.5);
            EXPECT_LT(surface.positions[v].z(), height + 0.5);
        }
    }
    // Along the axis the wall falls like a membrane: steadily.
    double above = height + 1;
    for (double x = 285; x < 400; x += 15) {
        double z = 0, nearest = 1e9;
        for (std::uint32_t v = 0; v < surface.topology->vertexCount(); ++v)
            if (const double d = (surface.topology->pattern[v] - Vec2(x, 200)).norm(); d < nearest) {
                nearest = d;
                z = surface.positions[v].z();
            }
        EXPECT_LT(z, above);
        above = z;
    }
    ASSERT_EQ(result.report.handles.size(), 1u);
    EXPECT_EQ(result.report.handles[0].element, id);
    EXPECT_LT(result.report.handles[0].value, 1e-9);
    EXPECT_EQ(result.report.flippedTriangles, 0);
}

TEST(Handle, AnOpenOneKeepsItsCornersAndThoseOfItsTarget)
{
    Square square;
    HandleCurve bent = handle(square.patch, BSpline2(1, false, {{100, 100}, {200, 150}, {200, 300}}), 0);
    // The target has a corner of its own at a quarter of its length.
    const double length = bent.target.empty() ? 0 : std::hypot(100, 50) + 150;
    bent.target =
        polyline({{100, 100, 0}, {100 + 0.25 * length, 100, 0}, {100 + 0.25 * length, 100 + 0.75 * length, 0}});
    const ElementId id = square.builder.add(bent);
    const OutlineSampling sampling = sampleOutlines(square.builder.design());
    ASSERT_TRUE(sampling.problems.empty()) << sampling.problems.front().english();
    ASSERT_EQ(sampling.outlines[0].lines.size(), 1u);
    const auto& points = sampling.outlines[0].lines[0].shape.points;
    const auto contains = [&](const Vec2& wanted) {
        return std::any_of(points.begin(), points.end(), [&](const Vec2& p) { return (p - wanted).norm() < 1e-6; });
    };
    EXPECT_TRUE(contains({100, 100}) && contains({200, 150}) && contains({200, 300}));
    const auto& targets = sampling.handles[0].targets;
    EXPECT_TRUE(std::any_of(targets.begin(), targets.end(),
                            [&](const Vec3& p) { return (p - Vec3(100 + 0.25 * length, 100, 0)).norm() < 1e-6; }));
    EXPECT_EQ(sampling.handles[0].fixation, id);
}

TEST(Handle, MatchesByLengthOrByParameter)
{
    for (const Match match : {Match::Length, Match::Parameter}) {
        Square square;
        HandleCurve uneven = handle(square.patch, BSpline2(1, false, {{100, 200}, {300, 200}}), 0);
        uneven.target = BSpline3(2, false, {{100, 200, 10}, {120, 200, 10}, {300, 200, 10}});
        uneven.match = match;
        square.builder.add(uneven);
        const auto chain = sampleOutlines(square.builder.design()).handles[0];
        ASSERT_GT(chain.targets.size(), 10u);
        const double step = 200.0 / static_cast<double>(chain.targets.size() - 1);
        for (std::size_t k = 0; k < chain.targets.size(); ++k) {
            const double x =
                match == Match::Length
                    ? 100 + step * static_cast<double>(k)
                    : uneven.target.at(static_cast<double>(k) / static_cast<double>(chain.targets.size() - 1)).x();
            EXPECT_NEAR(chain.targets[k].x(), x, 1e-6);
        }
    }
}

TEST(Handle, MayEndAtTheOutline)
{
    // Two squares side by side, sewn; the handle runs from the free edge of the first to the seam.
    DesignBuilder b(12);
    const ElementId fabric = b.fabric(0.3, 5);
    const ElementId left = b.patch(rectangle(200, 200), fabric), right = b.patch(rectangle(200, 200), fabric);
    b.seam({left, 1, 2}, {right, 3, 4});
    b.fix({right, 1, 2}, polyline({{400, 0, 0}, {400, 200, 0}}));
    HandleCurve across = handle(left, BSpline2(1, false, {{0, 93}, {200, 93}}), 0);
    const ElementId id = b.add(across);
    const SolveResult result = solved(b.design());
    const SurfaceMesh& surface = *result.surface;
    const auto& line = lineOf(surface, id);
    const auto& range = surface.topology->patches[0];
    EXPECT_LT(line.vertices.front(), range.firstVertex + range.outlineCount) << "on the outline";
    EXPECT_LT(line.vertices.back(), range.firstVertex + range.outlineCount);
    EXPECT_LT((surface.topology->pattern[line.vertices.back()] - Vec2(200, 93)).norm(), 1e-9);
    EXPECT_LT((surface.positions[line.vertices.back()] - Vec3(200, 93, 0)).norm(), 1e-9);
    EXPECT_EQ(result.report.seamGap.max, 0);
}

TEST(Handle, AloneHoldsAPatch)
{
    DesignBuilder b(12);
    const ElementId patch = b.patch(rectangle(200, 200), b.fabric(0.3, 5));
    HandleCurve ring = handle(patch, flatCircle({100, 100}, 50), 300);
    const ElementId id = b.add(ring);
    EXPECT_TRUE(checkDesign(b.design()).empty()) << "it is not free in space";
    const SolveResult result = solved(b.design());
    for (std::uint32_t v = 0; v < result.surface->topology->vertexCount(); ++v) {
        const Vec2& rest = result.surface->topology->pattern[v];
        EXPECT_LT((result.surface->positions[v] - Vec3(rest.x(), rest.y(), 300)).norm(), 0.1);
    }
    EXPECT_LT(result.report.handles[0].value, 1e-9);
    EXPECT_GT(result.surface->normals[0].z(), 0.9) << "right side up";
    EXPECT_EQ(lineOf(*result.surface, id).element, id);
}

/// The largest distance of two covers, vertex by vertex of b through the pattern.
double largestDistance(const SurfaceMesh& a, const SurfaceMesh& b)
{
    double largest = 0;
    for (std::size_t p = 0; p < b.topology->patches.size(); ++p) {
        const PatternLocator locator(*a.topology, a.topology->patches[p]);
        const auto& range = b.topology->patches[p];
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v) {
            const PatternPlace at = locator.locate(b.topology->pattern[v]);
            Vec3 there = Vec3::Zero();
            for (int k = 0; k < 3; ++k)
                there += at.weights[k] * a.positions[at.corners[static_cast<std::size_t>(k)]];
            largest = std::max(largest, (there - b.positions[v]).norm());
        }
    }
    return largest;
}

TEST(Handle, AddingOneLeavesTheSurfaceAsItIs)
{
    // A sheet bent over a half circle, stretched unevenly.
    DesignBuilder b(12);
    const ElementId patch = b.patch(rectangle(300, 400), b.fabric(0.3, 6));
    const auto arch = [](double x, double radius) {
        std::vector<Vec3> points;
        for (int k = 0; k <= 40; ++k)
            points.emplace_back(x, -radius * std::cos(std::numbers::pi * k / 40),
                                radius * std::sin(std::numbers::pi * k / 40));
        return polyline(points);
    };
    b.fix({patch, 1, 2}, arch(300, 127));
    b.fix({patch, 3, 4}, arch(0, 133), true);
    const SolveResult before = solved(b.design());
    const struct {
        const char* name;
        std::optional<BSpline2> curve;
    } cases[] = {{"straight", edits::drawnCurve({{60, 80}, {240, 300}}, false, false)},
                 {"corner", edits::drawnCurve({{60, 80}, {220, 120}, {120, 340}}, false, false)},
                 {"smooth", edits::drawnCurve({{60, 80}, {220, 120}, {80, 250}, {240, 340}}, false, true)},
                 {"loop", edits::drawnCurve({{60, 80}, {240, 100}, {220, 300}, {80, 320}}, true, true)},
                 {"square", edits::drawnCurve({{60, 80}, {240, 100}, {220, 300}, {80, 320}}, true, false)},
                 {"across", edits::drawnCurve({{150, 0}, {170, 400}}, false, false)}};
    for (const auto& [name, curve] : cases) {
        SCOPED_TRACE(name);
        const Edit edit = edits::addHandleCurve(b.design(), *before.surface, patch, *curve, "Handle");
        ASSERT_EQ(edit.changes.size(), 1u);
        const Design with = b.design().with(edit);
        const auto& added = *with.find<HandleCurve>(edit.changes[0].id);
        EXPECT_EQ(added.target.closed(), curve->closed());
        EXPECT_LT(added.target.pointCount(), 24);
        const SolveResult after = solved(with);
        EXPECT_LT(largestDistance(*before.surface, *after.surface), 0.3);
    }
    EXPECT_TRUE(edits::addHandleCurve(b.design(), *before.surface, ElementId{99}, *cases[0].curve, "").empty());
}

struct RefusedHandle {
    const char* name;
    BSpline2 curve;
    const char* expected; ///< in the message
};

void PrintTo(const RefusedHandle& refusal, std::ostream* out)
{
    *out << refusal.name;
}

class HandleRefusal : public testing::TestWithParam<RefusedHandle> {};

TEST_P(HandleRefusal, NamesTheHandleAndTheRemedy)
{
    Square square;
    square.builder.add(handle(square.patch, BSpline2(1, false, {{50, 200}, {350, 200}}), 0));
    const ElementId bad = square.builder.add(handle(square.patch, GetParam().curve, 0));
    const Problems problems = sampleOutlines(square.builder.design()).problems;
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, bad);
    EXPECT_EQ(problems[0].field, "curve");
    EXPECT_NE(problems[0].english().find(GetParam().expected), std::string::npos) << problems[0].english();
    SolveOptions options;
    EXPECT_EQ(solveResting(square.builder.design(), options).status, SolveResult::Status::Failed);
    options.lenient = true;
    EXPECT_EQ(solveResting(square.builder.design(), options).status, SolveResult::Status::Solved);
}

INSTANTIATE_TEST_SUITE_P(
    All, HandleRefusal,
    testing::Values(
        RefusedHandle{"Crossing", BSpline2(1, false, {{200, 100}, {200, 300}}), "crosses Handle, or"},
        RefusedHandle{"Touching", BSpline2(1, false, {{200, 100}, {200, 200}}), "crosses Handle, or"},
        RefusedHandle{"CrossingTheOutline", BSpline2(1, false, {{200, 300}, {200, 500}}), "beyond its patch"},
        RefusedHandle{"Outside", BSpline2(1, false, {{500, 300}, {600, 300}}), "beyond its patch"},
        RefusedHandle{"AlongTheOutline", BSpline2(1, false, {{50, 398}, {350, 398}}), "outline"},
        RefusedHandle{"CrossingItself",
                      BSpline2(1, false, {{100, 250}, {250, 250}, {250, 350}, {175, 350}, {175, 225}}),
                      "crosses itself"},
        RefusedHandle{"ClosedEight", BSpline2(1, true, {{100, 250}, {300, 350}, {300, 250}, {100, 350}}),
                      "crosses itself"},
        RefusedHandle{"Folded", BSpline2(1, false, {{100, 250}, {250, 250}, {110, 252}}), "crosses itself"},
        RefusedHandle{"Short", BSpline2(1, false, {{100, 100}, {105, 100}}), "5 mm long"}),
    [](const auto& test) { return test.param.name; });

TEST(Handle, HoldsNoPointInTwoPlaces)
{
    Square square;
    HandleCurve rim = handle(square.patch, BSpline2(1, false, {{0, 200}, {200, 200}}), 0);
    EXPECT_TRUE(sampleOutlines([&] {
                    Square sound;
                    sound.builder.add(rim);
                    return sound.builder.design();
                }())
                    .problems.empty());
    rim.target = raised(rim.curve, 5);
    const ElementId id = square.builder.add(rim);
    const Problems problems = sampleOutlines(square.builder.design()).problems;
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, id);
    EXPECT_EQ(problems[0].field, "target");
}

TEST(Handle, PlansAreAsLightAsCanBe)
{
    Square square;
    const ElementId id = square.builder.add(handle(square.patch, BSpline2(1, false, {{50, 200}, {350, 200}}), 0));
    const Design& design = square.builder.design();
    const auto planWith = [&](auto change) {
        HandleCurve changed = *design.find<HandleCurve>(id);
        change(changed);
        return planSolve(design, design.with({{}, {{id, design.element(id), makeElement(changed)}}}));
    };
    EXPECT_EQ(planWith([](HandleCurve& h) { h.name = "Other"; }), SolvePlan::Nothing);
    EXPECT_EQ(planWith([](HandleCurve& h) { h.target = h.target.withPoint(0, {0, 0, 9}); }), SolvePlan::Retarget);
    EXPECT_EQ(planWith([](HandleCurve& h) { h.target = h.target.withKnot(0.5); }), SolvePlan::Rebuild);
    EXPECT_EQ(planWith([](HandleCurve& h) { h.curve = h.curve.withPoint(0, {60, 200}); }), SolvePlan::Warp);
    EXPECT_EQ(planSolve(design, design.with({{}, {{id, design.element(id), nullptr}}})), SolvePlan::Rebuild);
}

TEST(Handle, RetargetingIsTheSameAsSamplingAgain)
{
    Square square;
    const ElementId id = square.builder.add(handle(square.patch, flatCircle({200, 200}, 80), 30));
    OutlineSampling sampling = sampleOutlines(square.builder.design());
    HandleCurve moved = *square.builder.design().find<HandleCurve>(id);
    moved.target = moved.target.withPoint(3, {300, 250, 90});
    const Design after = square.builder.design().with({{}, {{id, nullptr, makeElement(moved)}}});
    retarget(sampling, after);
    EXPECT_EQ(sampling.handles[0].targets, sampleOutlines(after).handles[0].targets);
}

TEST(Handle, RandomCurvesAreEmbeddedOrRefused)
{
    std::mt19937 random(7);
    const auto somewhere = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    int embedded = 0;
    double least = 180;
    for (int round = 0; round < 120; ++round) {
        SCOPED_TRACE(round);
        Square square(300, 10);
        const int degree = 1 + round % 3, count = degree + 1 + round % 4;
        std::vector<Vec2> points;
        for (int k = 0; k < count; ++k)
            points.emplace_back(somewhere(5, 295), somewhere(5, 295));
        const bool closed = round % 5 == 0 && count > 2;
        const BSpline2 curve(degree, closed, points);
        const ElementId id = square.builder.add(handle(square.patch, curve, 20));
        TriangulationCache cache;
        const PreparedSheet sheet = *prepareSheet(square.builder.design(), cache);
        if (hasErrors(sheet.errors)) {
            EXPECT_EQ(sheet.errors[0].element, id);
            EXPECT_EQ(sheet.mesh.topology->lines.size(), 0u);
            continue;
        }
        ++embedded;
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
        for (const auto& t : sheet.mesh.topology->triangles)
            for (int k = 0; k < 3; ++k)
                edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
        const auto& vertices = sheet.mesh.topology->lines.at(0).vertices;
        for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
            EXPECT_TRUE(edges.contains(std::minmax(vertices[k], vertices[k + 1]))) << k;
        for (std::uint32_t v : vertices)
            EXPECT_LT(curve.closest(sheet.mesh.rest()[v]).distance, 2.6) << "moved at most to the outline";
        least = std::min(least, leastAngle(sheet.mesh));
    }
    EXPECT_GT(embedded, 30);
    EXPECT_GT(least, 12);
}

} // namespace
} // namespace bolster::test
