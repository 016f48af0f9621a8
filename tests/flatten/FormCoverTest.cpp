// The cover of a form's pattern, with the form as the goal of its foam: how far it is from the form. Prints the
// figures.
#include "ElementEdits.h"
#include "Flatten.h"
#include "FormPattern.h"
#include "PointCloud.h"
#include "RestingSolve.h"
#include "TestForms.h"
#include "TruthForms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

namespace bolster::test {
namespace {

/// Points on the form's triangles, 2 to 3 mm from each other.
std::shared_ptr<PointCloud> pointsOn(const TriangleMesh& form)
{
    constexpr int parts = 4; // of an edge
    auto cloud = std::make_shared<PointCloud>();
    for (const auto& corners : form.triangles) {
        const Vec3 &a = form.points[corners[0]], b = form.points[corners[1]] - a, c = form.points[corners[2]] - a;
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j)
                cloud->points.emplace_back(a + (i + 1.0 / 3) / parts * b + (j + 1.0 / 3) / parts * c);
    }
    return cloud;
}

/// Ideal foam holds the cloth where the form is, and lets it slide along.
void expectCoverOnForm(const TriangleMesh& mesh)
{
    const Form form = cutForm(mesh, {});
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    Scan foam;
    foam.name = "Form";
    foam.file = "form.ply";
    const Edit added = edits::addElement(made.design, makeElement(foam));
    SolveInput input(made.design.with(added), {});
    input.files.clouds[added.changes.front().id] = pointsOn(mesh);
    const SolveResult result = solveResting(input, {});
    ASSERT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    ASSERT_EQ(result.report.scans.size(), 1u);
    const ScanFigures& found = result.report.scans.front().figures;
    std::cout << found.rms << " mm rms, " << found.p95 << " mm within 95 %, over " << 100 * found.coverage
              << " % of the cover; strain " << 100 * result.report.strain.rms << " % rms\n";
    EXPECT_LT(found.rms, 1.0);
    EXPECT_LT(found.p95, 3.0);
    EXPECT_GT(found.coverage, 0.99) << "else what is far off does not count";
    EXPECT_LT(result.report.strain.rms, 0.02) << "the pattern is the form's, it need not be stretched to it";
    EXPECT_EQ(result.report.flippedTriangles, 0);
}

TEST(FormCover, OfTheArmchairsBodyLiesOnIt)
{
    expectCoverOnForm(armchairForm());
}

/// With a rounded seam the tube's cover stayed dented.
TEST(FormCover, OfATubeIsThatTube)
{
    const Form form = cutForm(ringMesh(100, 100, 500), {});
    const FormPattern made = formPattern(form, flatten(form, {}), {});
    const SolveResult solved = solveResting(made.design, {});
    ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
    EXPECT_EQ(solved.report.flippedTriangles, 0);
    EXPECT_LT(solved.report.strain.rms, 0.005);
    for (const Vec3& at : solved.surface->positions)
        EXPECT_NEAR(at.head<2>().norm(), 100, 1);
}

/// Where on the form the border of a piece lies that is nearest to a place in the pattern.
Vec3 onForm(const Form& form, const FormPiece& piece, const FlatPiece& flat, const Vec2& place)
{
    double least = std::numeric_limits<double>::infinity();
    Vec3 found = Vec3::Zero();
    for (std::size_t k = 0; k < piece.border.size(); ++k) {
        const int from = piece.border[k], to = piece.border[piece.after(k)];
        const Vec2 way = flat.at[to] - flat.at[from];
        const double along = std::clamp((place - flat.at[from]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const double distance = (flat.at[from] + along * way - place).norm();
        if (distance < least) {
            least = distance;
            found = (1 - along) * form.points[piece.points[from]] + along * form.points[piece.points[to]];
        }
    }
    return found;
}

/// Every vertex that is held is where the cloth lies on the form.
void expectHeldOnForm(const TriangleMesh& mesh)
{
    const Form form = cutForm(mesh, {});
    const std::vector<FlatPiece> flat = flatten(form, {});
    const FormPattern made = formPattern(form, flat, {});
    const SolveResult solved = solveResting(made.design, {});
    ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
    std::size_t held = 0;
    for (const SurfaceTopology::Chain& chain : solved.surface->topology->fixations) {
        const ElementId patch = made.design.find<FixationSeam>(chain.seam)->stretch.patch;
        const auto p = static_cast<std::size_t>(std::ranges::find(made.patches, patch) - made.patches.begin());
        for (const std::uint32_t v : chain.a) {
            const Vec3 place = onForm(form, form.pieces[p], flat[p], solved.surface->topology->pattern[v]);
            EXPECT_LT((solved.surface->positions[v] - place).norm(), 0.5);
            ++held;
        }
    }
    EXPECT_GT(held, 80U);
}

/// A crowned sheet is not strained evenly along its border when it lies flat: by lengths alone its cover was held
/// beside where it lies, and sheared.
TEST(FormCover, IsHeldWhereItLiesOnTheForm)
{
    const double pi = std::numbers::pi;
    expectHeldOnForm(gridMesh(40, 30, [&](double u, double v) {
        return Vec3(400 * u, 300 * v, 120 * std::sin(pi * u) * std::sin(pi * v));
    }));
}

/// Laid flat its border is straight where it goes over the ridge: a smooth curve cut that corner.
TEST(FormCover, IsHeldAtCreasesThatLieFlat)
{
    const double pi = std::numbers::pi;
    const auto roof = [&](double way) {
        return gridMesh(
            6, 10,
            [&, way](double u, double v) {
                const double across = way > 0 ? u : 1 - u;
                return Vec3(300 * across, 250 * v,
                            150 - 300 * std::abs(across - 0.5) +
                                way * 10 * std::sin(pi * across) * std::sin(pi * v));
            },
            way > 0 ? "Above" : "Below");
    };
    expectHeldOnForm(sideBySide(roof(1), roof(-1)));
}

SolveResult coverOf(const Form& form, double edgeLength)
{
    FormPatternOrder order;
    order.edgeLength = edgeLength;
    return solveResting(formPattern(form, flatten(form, {}), order).design, {});
}

/// The lowest and the highest, mm.
std::pair<double, double> heightsOf(const SolveResult& solved)
{
    const auto [lowest, highest] =
        std::ranges::minmax(solved.surface->positions, {}, [](const Vec3& at) { return at.z(); });
    return {lowest.z(), highest.z()};
}

/// Its mirror image would be as much at rest.
TEST(FormCover, OfADomeStandsOnItsOutside)
{
    const double pi = std::numbers::pi;
    for (const double height : {40.0, 90.0, 160.0})
        for (const double edge : {10.0, 14.0, 18.0}) {
            const Form form = cutForm(gridMesh(24, 24,
                                               [&](double u, double v) {
                                                   const double high = std::sin(pi * u) * std::sin(pi * v);
                                                   return Vec3(400 * u, 360 * v, height * high);
                                               }),
                                      {});
            const SolveResult solved = coverOf(form, edge);
            ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
            const auto [lowest, highest] = heightsOf(solved);
            EXPECT_GT(lowest, -0.02 * height) << height << ", " << edge;
            EXPECT_GT(highest, 0.5 * height) << height << ", " << edge;
        }
}

/// Walls that go around a rim lay anywhere to begin with, and came to stand below it or turned inside out.
TEST(FormCover, OfTraysStandsOnItsOutside)
{
    const std::vector<std::vector<std::string>> plans{
        {"x ", "xx"}, {"x x", "xxx"}, {"xxx", "x x", "xxx"}, {" x ", "xxx", " x "}};
    for (const auto& plan : plans)
        for (const double edge : {12.0, 20.0})
            for (const double height : {60.0, 150.0}) {
                const Form form = cutForm(trayMesh(plan, 120, height), {});
                const SolveResult solved = coverOf(form, edge);
                ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
                const auto [lowest, highest] = heightsOf(solved);
                EXPECT_GT(lowest, -1) << plan.front() << ", " << edge << ", " << height;
                EXPECT_NEAR(highest, height, 0.05 * height) << plan.front() << ", " << edge;
                EXPECT_LT(solved.report.strain.rms, 0.06)
                    << "bending rounds its edges; " << plan.front() << ", " << edge;
            }
}

/// Also where the rim lies in no plane, and where what stands on it hangs down.
TEST(FormCover, OfATrayOnAWavyRimStandsOnItsOutside)
{
    TriangleMesh tray = trayMesh({"xxx", "x x", "xxx"}, 200, 200);
    for (Vec3& point : tray.points) {
        point.z() += point.z() > 0 ? 0 : 40 * std::sin(point.x() / 90) + 30 * std::cos(point.y() / 120);
        point = Vec3(point.x(), -point.y(), -point.z());
    }
    const Form form = cutForm(tray, {});
    const SolveResult solved = coverOf(form, FormPatternOrder{}.edgeLength);
    ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
    const auto [lowest, highest] = heightsOf(solved);
    EXPECT_NEAR(lowest, -200, 10);
    EXPECT_LT(highest, 75);
}

/// A smooth seam that ends in a thin tip, or in a short edge beside a corner, where triangles are small: such
/// covers turned about these places without end.
TEST(FormCover, OfATopThatIsCutToAThinTipComesToRest)
{
    struct Case {
        unsigned corners;
        double height;
        Vec3 from, to;
    };
    for (const Case& each : {Case{4, 60, Vec3(-133.67458112587252, 16.3254188741275, 60),
                                  Vec3(47.708164462380886, 102.29183553761911, 60)},
                             Case{6, 60, Vec3(-94.71107966782331, 98.72435952750821, 60),
                                  Vec3(-123.4222172883109, -51.913780744929724, 60)},
                             Case{6, 150, Vec3(-87.61635534046646, 117.00169715884093, 150),
                                  Vec3(145.25745266932498, 13.50935191428708, 150)}})
        for (const double edge : {10.0, 12.0}) {
            const FormLine line{"Line", {each.from, each.to}, false};
            const Form form = cutForm(hollowPrism(each.corners, 150, each.height), {false, 30, {line}});
            ASSERT_EQ(form.pieces.size(), each.corners + 2U);
            const SolveResult solved = coverOf(form, edge);
            EXPECT_EQ(solved.status, SolveResult::Status::Solved)
                << each.corners << ", " << each.height << ", " << edge;
        }
}

/// A strip narrower than the bending length beside a smooth seam.
TEST(FormCover, OfATopWithANarrowStripComesToRest)
{
    TriangleMesh top = hollowPrism(8, 150, 0);
    top.triangles.erase(top.triangles.begin(), top.triangles.end() - 6);
    top.parts = {{"Top", 0, 6}};
    for (const double second : {1.1, 1.2, 1.5, 2.2, 4.2})
        for (const double edge : {6.0, 10.0, 12.0}) {
            const Vec3 in(-std::cos(std::numbers::pi / 8), -std::sin(std::numbers::pi / 8), 0);
            const Vec3 from = top.points[8] + 4.2 * in, to = top.points[9] + second * in;
            const FormLine line{
                "Line", {from - 5 * (to - from).normalized(), to + 5 * (to - from).normalized()}, false};
            const Form form = cutForm(top, {false, std::nullopt, {line}});
            ASSERT_EQ(form.pieces.size(), 2U);
            const SolveResult solved = coverOf(form, edge);
            EXPECT_EQ(solved.status, SolveResult::Status::Solved)
                << second << ", " << edge << solved.reason.english();
        }
}

/// Straight lines over the top, wherever they are and however far they are drawn over its edges: all pieces are
/// plane.
TEST(FormCover, OfTopsThatAreCutAnyhowComesToRest)
{
    std::mt19937 random(19);
    const auto between = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    for (int round = 0; round < 60; ++round) {
        const unsigned corners = 4 + random() % 5;
        const double radius = random() % 2 == 0 ? 150 : 300, height = random() % 2 == 0 ? 60 : 150;
        const double off = between(-0.7, 0.7) * radius * std::cos(std::numbers::pi / corners);
        const double over = between(0, 8), turn = between(0, 2 * std::numbers::pi);
        const PrismCrossing top = acrossPrism(corners, radius, height, turn, off);
        const Vec3 along = (top.end - top.begin).normalized();
        const FormLine line{"Line", {top.begin - over * along, top.end + over * along}, false};
        const Form form = cutForm(hollowPrism(corners, radius, height), {false, 30, {line}});
        EXPECT_EQ(form.pieces.size(), corners + 2U) << round;
        FormPatternOrder order;
        const FormPattern made = formPattern(form, flatten(form, {}), order);
        EXPECT_EQ(std::ranges::count(made.patches, noElement), 0) << round;
        const SolveResult solved = solveResting(made.design, {});
        EXPECT_EQ(solved.status, SolveResult::Status::Solved) << round << ": " << solved.reason.english();
    }
}

/// Of one piece, sewn down its corners; its top is smaller than its rim by `lean` on each side, mm.
SolveResult coverOfBox(double width, double height, double lean, double edge)
{
    TriangleMesh box = trayMesh({"x"}, width, height);
    for (Vec3& point : box.points)
        if (point.z() > 0)
            for (int k = 0; k < 2; ++k)
                point[k] += point[k] > width / 2 ? -lean : lean;
    std::vector<FormLine> corners;
    for (const double x : {0.0, width})
        for (const double y : {0.0, width}) {
            const Vec3 foot(x, y, 0), way(x > 0 ? -lean : lean, y > 0 ? -lean : lean, height);
            corners.push_back({"Corner", {foot, foot + way}, false});
        }
    const Form form = cutForm(box, {false, std::nullopt, corners});
    EXPECT_EQ(form.pieces.size(), 1U);
    return coverOf(form, edge);
}

/// High ones were lifted a little above their rim to begin with, and carried through to hang below; low ones that
/// lean lay flat.
TEST(FormCover, OfABoxWithDartsStandsOnItsOutside)
{
    const auto expectStanding = [](double width, double height, double lean, double edge) {
        const SolveResult solved = coverOfBox(width, height, lean, edge);
        ASSERT_EQ(solved.status, SolveResult::Status::Solved) << solved.reason.english();
        const auto [lowest, highest] = heightsOf(solved);
        EXPECT_GT(lowest, -1) << width << ", " << height << ", " << lean << ", " << edge;
        EXPECT_GT(highest, height) << "its middle rises; " << width << ", " << height << ", " << lean << ", "
                                   << edge;
    };
    for (const double edge : {12.0, 20.0})
        for (const double lean : {-30.0, 0.0, 20.0})
            for (const double height : {180.0, 250.0, 350.0})
                expectStanding(240, height, lean, edge);
    for (const double edge : {8.0, 12.0})
        for (const double width : {300.0, 500.0})
            for (const double lean : {10.0, 20.0, 30.0})
                for (const double height : {16.0, 25.0})
                    expectStanding(width, height, lean, edge);
}

TEST(FormCover, OfTheCarSeatLiesOnIt)
{
    expectCoverOnForm(carSeatForm());
}

} // namespace
} // namespace bolster::test
