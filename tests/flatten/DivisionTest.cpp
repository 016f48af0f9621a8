// Forms that cannot be laid flat as they are, divided until they can.
#include "Division.h"
#include "Fiedler.h"
#include "SheetCut.h"
#include "TestForms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using namespace bolster::test;

constexpr double radius = 200; // mm

/// Of gridMesh's square; without its poles, whose triangles have no area.
TriangleMesh sphere(const std::string& name = "Ball", double from = -1, double to = 1)
{
    return gridMesh(
        48, 24,
        [&](double u, double v) {
            const double height = (from + v * (to - from)) * std::numbers::pi / 2,
                         around = 2 * std::numbers::pi * u;
            return Vec3(radius * std::cos(height) * std::cos(around), radius * std::cos(height) * std::sin(around),
                        radius * std::sin(height));
        },
        name);
}

TriangleMesh closedBox(const Vec3& size = {400, 300, 120}, int fineness = 8)
{
    const auto wall = [&](const Vec3& corner, const Vec3& right, const Vec3& up) {
        return gridMesh(fineness, fineness, [=](double u, double v) { return Vec3(corner + u * right + v * up); });
    };
    const Vec3 x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z()), o = Vec3::Zero();
    TriangleMesh box = wall(o, y, x);
    for (const TriangleMesh& side : {wall(z, x, y), wall(o, x, z), wall(y, z, x), wall(o, z, y), wall(x, y, z)})
        box = sideBySide(box, side);
    box.parts = {{"Box", 0, static_cast<std::uint32_t>(box.triangles.size())}};
    return box;
}

double areaOf(const Form& form, const FormPiece& piece)
{
    double area = 0;
    for (const auto& [a, b, c] : piece.triangles) {
        const auto at = [&](int vertex) { return form.points[piece.points[vertex]]; };
        area += (at(b) - at(a)).cross(at(c) - at(a)).norm() / 2;
    }
    return area;
}

double areaOf(const Form& form)
{
    double area = 0;
    for (const FormPiece& piece : form.pieces)
        area += areaOf(form, piece);
    return area;
}

/// All of it, with no more strain than is allowed.
void expectLiesFlat(const Form& form, const FormPatternOrder& order)
{
    const std::vector<FlatPiece> flat = flatten(form, {order.fabric.poisson});
    const FormPattern pattern = formPattern(form, flat, order);
    EXPECT_EQ(std::ranges::count(pattern.patches, noElement), 0);
    for (std::size_t p = 0; p < flat.size(); ++p)
        EXPECT_LE(flat[p].strainP99, 1.1 * bearableStrain(order.fabric)) << form.pieces[p].name;
}

/// The second one is turned, moved and numbered otherwise.
TriangleMesh twoEggs()
{
    TriangleMesh egg = sphere("Left");
    for (Vec3& point : egg.points)
        point = {point.x(), (point.x() > 0 ? 1.3 : 1.1) * point.y(), (point.z() > 0 ? 1.7 : 1.4) * point.z()};
    TriangleMesh other = egg;
    other.parts[0].name = "Right";
    const Eigen::AngleAxisd turn(1, Vec3(1, 2, 0.5).normalized());
    for (Vec3& point : other.points)
        point = turn * point + Vec3(1000, 300, 0);
    std::ranges::rotate(other.triangles, other.triangles.begin() + 100);
    return sideBySide(egg, other);
}

/// The second one mirrors the first, and is shifted; each of its triangles is four.
TriangleMesh mirroredEggs()
{
    TriangleMesh egg = sphere("Left");
    for (Vec3& point : egg.points)
        point = {point.x(), (point.x() > 0 ? 1.3 : 1.1) * point.y(), (point.z() > 0 ? 1.7 : 1.4) * point.z()};
    TriangleMesh other = quartered(egg);
    other.parts = {{"Right", 0, static_cast<std::uint32_t>(other.triangles.size())}};
    for (Vec3& point : other.points)
        point = {1000 - point.x(), point.y() + 30, point.z()};
    for (auto& corners : other.triangles)
        std::swap(corners[0], corners[1]);
    return sideBySide(egg, other);
}

/// mm^2, of the pieces that a part has become, the smallest first.
std::vector<double> areasOf(const Form& form, const std::string& part)
{
    std::vector<double> areas;
    for (const FormPiece& piece : form.pieces)
        if (piece.part == part)
            areas.push_back(areaOf(form, piece));
    std::ranges::sort(areas);
    return areas;
}

std::ptrdiff_t openEdges(const Form& form)
{
    std::ptrdiff_t open = 0;
    for (const FormPiece& piece : form.pieces)
        open += std::ranges::count_if(piece.mates, &EdgeMate::none);
    return open;
}

/// A cut into a saddle does not open: it closes over itself. The piece is worth more than the cut.
TEST(Division, CutsThatWouldCloseOverThemselvesAreLeftOut)
{
    const auto bowed = [](double across) {
        return gridMesh(40, 40, [=](double u, double v) {
            const double x = 400 * (u - 0.5), y = 400 * (v - 0.5);
            return Vec3(x, y, (-x * x + across * y * y) / 1500);
        });
    };
    const auto leavesOut = [](const Form& one) { return formPattern(one, flatten(one, {}), {}).isEmpty(); };
    FormCuts cuts;
    cuts.lines = {{"Cut", {{-200, 0, -27}, {-100, 0, -7}, {10, 0, 0}}, false}};
    const Form form = cutForm(bowed(1), cuts);
    ASSERT_EQ(form.openEnds.size(), 1U);
    ASSERT_TRUE(leavesOut(form)) << "else there is nothing to mend";
    for (const Form& mended : {withoutClosedSlits(form, {}), divided(form, {})}) {
        EXPECT_EQ(mended.pieces.size(), 1U);
        EXPECT_FALSE(leavesOut(mended));
        ASSERT_EQ(mended.notes.size(), 1U);
        EXPECT_NE(mended.notes.front().english().find("A line is not cut in"), std::string::npos);
        EXPECT_EQ(mended.openEnds.size(), 1U) << "it can still be led on";
    }
    const Form open = cutForm(bowed(-1), cuts); // one that opens stays
    const Form same = withoutClosedSlits(open, {});
    EXPECT_EQ(same.notes, open.notes);
    EXPECT_FALSE(leavesOut(same));
}

} // namespace

TEST(Division, ABallBecomesPiecesThatTheFabricBears)
{
    const Form ball = cutForm(sphere(), {});
    ASSERT_NE(problemOf(ball), "");
    const FormPatternOrder order;
    const Form form = divided(ball, order);
    EXPECT_EQ(problemOf(form), "");
    EXPECT_GE(form.pieces.size(), 4u);
    EXPECT_LE(form.pieces.size(), 16u);
    EXPECT_EQ(openEdges(form), 0); // sewn all around
    EXPECT_NEAR(areaOf(form), 4 * std::numbers::pi * radius * radius, 0.01 * areaOf(form));
    expectLiesFlat(form, order);
}

TEST(Division, AFabricThatBearsMoreNeedsFewerPieces)
{
    const Form ball = cutForm(sphere(), {});
    FormPatternOrder stiff, soft;
    stiff.fabric.limits = {4, 4, 10};
    soft.fabric.limits = {25, 25, 10};
    EXPECT_GT(divided(ball, stiff).pieces.size(), divided(ball, soft).pieces.size());
}

TEST(Division, ABoxIsCutAlongItsEdges)
{
    const Form box = cutForm(closedBox(), {});
    ASSERT_NE(problemOf(box), "");
    const FormPatternOrder order;
    const Form form = divided(box, order);
    EXPECT_LE(form.pieces.size(), 6u);
    EXPECT_EQ(openEdges(form), 0);
    EXPECT_NEAR(areaOf(form), areaOf(cutForm(closedBox(), {false, 30})), 1);
    const std::vector<FlatPiece> flat = flatten(form, {});
    for (const FlatPiece& piece : flat) // a box is plane between its edges
        EXPECT_LT(piece.strainRms, 0.01);
    expectLiesFlat(form, order);
}

TEST(Division, ACubeIsCutAlongItsEdgesHoweverItIsTurned)
{
    const TriangleMesh cube = closedBox({300, 300, 300}, 12);
    for (const double degrees : {0, 20, 45, 77}) {
        const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vec3(1, 2, 0.5).normalized());
        TriangleMesh turned = cube;
        for (Vec3& point : turned.points)
            point = turn * point;
        std::ranges::reverse(turned.triangles);
        const Form form = divided(cutForm(turned, {}), {});
        EXPECT_LE(form.pieces.size(), 3u);
        for (const FlatPiece& piece : flatten(form, {}))
            EXPECT_LT(piece.strainP99, 0.001) << degrees;
    }
}

/// Many ways to go on are equally good there.
TEST(Division, APrismIsDividedAlikeHoweverItsTrianglesAreNumbered)
{
    TriangleMesh prism;
    constexpr std::uint32_t sides = 5;
    for (const double height : {0.0, 200.0})
        for (std::uint32_t k = 0; k < sides; ++k)
            prism.points.emplace_back(200 * std::cos(k * 2 * std::numbers::pi / sides),
                                      200 * std::sin(k * 2 * std::numbers::pi / sides), height);
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t next = (k + 1) % sides;
        prism.triangles.push_back({k, next, sides + next});
        prism.triangles.push_back({k, sides + next, sides + k});
        if (k > 1) {
            prism.triangles.push_back({0, k, k - 1});
            prism.triangles.push_back({sides, sides + k - 1, sides + k});
        }
    }
    const std::size_t count = divided(cutForm(prism, {}), {}).pieces.size();
    EXPECT_LE(count, 3u);
    for (std::size_t first = 3; first < prism.triangles.size(); first += 3) {
        TriangleMesh other = prism;
        std::ranges::rotate(other.triangles, other.triangles.begin() + static_cast<std::ptrdiff_t>(first));
        EXPECT_EQ(divided(cutForm(other, {}), {}).pieces.size(), count) << first;
    }
}

TEST(Division, LikePartsAreDividedAlike)
{
    const Form form = divided(cutForm(twoEggs(), {}), {});
    const std::vector<double> left = areasOf(form, "Left"), right = areasOf(form, "Right");
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t k = 0; k < left.size(); ++k)
        EXPECT_NEAR(left[k], right[k], 0.05 * left[k]);
}

/// A cut that divides nothing, on one of them.
TEST(Division, WhatALineDoesNotTouchStaysAsItIs)
{
    FormCuts cuts;
    cuts.divides = true;
    const Form without = divided(cutForm(twoEggs(), cuts), {});
    cuts.lines = {{"Dart", {{200, 0, 0}, {190, 60, 0}, {170, 100, 0}}}};
    const Form with = divided(cutForm(twoEggs(), cuts), {});
    const std::vector<double> before = areasOf(without, "Right"), after = areasOf(with, "Right");
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k)
        EXPECT_NEAR(before[k], after[k], 1e-3 * before[k]);
    EXPECT_LE(areasOf(with, "Left").size(), areasOf(without, "Left").size() + 1);
    for (const double area : areasOf(with, "Left"))
        EXPECT_GT(area, 1000) << "a crumb";
}

TEST(Division, TheInsideOfAClosedFormIsInside)
{
    TriangleMesh box = closedBox();
    for (auto& [a, b, c] : box.triangles)
        std::swap(b, c);
    for (const TriangleMesh& mesh : {closedBox(), box}) {
        const Form form = divided(cutForm(mesh, {}), {});
        const Vec3 middle(200, 150, 60);
        for (const FormPiece& piece : form.pieces)
            for (const auto& [a, b, c] : piece.triangles) {
                const auto at = [&](int vertex) { return form.points[piece.points[vertex]]; };
                EXPECT_GT((at(b) - at(a)).cross(at(c) - at(a)).dot(at(a) - middle), 0);
            }
    }
}

TEST(Division, ARoughFormIsNotDividedWithoutEnd)
{
    TriangleMesh rough = sphere();
    for (std::size_t v = 0; v < rough.points.size(); ++v)
        rough.points[v] *= 1 + 0.05 * std::sin(static_cast<double>(7 * v * v % 1000));
    const Form form = cutForm(rough, {}), same = divided(form, {});
    EXPECT_EQ(same.points, form.points);
    EXPECT_EQ(same.problem, form.problem);
    EXPECT_EQ(same.notes, form.notes);
    ASSERT_EQ(same.undivided.size(), 1u);
    EXPECT_EQ(same.undivided.front().args, (std::vector<std::string>{"Ball", "100"}));
}

/// What stands beside it is divided nevertheless.
TEST(Division, ARoughPartStaysAlone)
{
    TriangleMesh rough = sphere("Rough");
    for (std::size_t v = 0; v < rough.points.size(); ++v)
        rough.points[v] *= 1 + 0.05 * std::sin(static_cast<double>(7 * v * v % 1000));
    TriangleMesh box = closedBox();
    for (Vec3& point : box.points)
        point.x() += 1000;
    const Form form = divided(cutForm(sideBySide(rough, box), {}), {});
    ASSERT_EQ(form.undivided.size(), 1u);
    EXPECT_EQ(form.undivided.front().args.front(), "Rough");
    EXPECT_EQ(areasOf(form, "Rough").size(), 1u);
    EXPECT_GE(areasOf(form, "Box").size(), 2u);
}

/// As two arms, of which each is a mesh of its own.
TEST(Division, PartsThatMirrorEachOtherAreDividedAlike)
{
    const FormPatternOrder order;
    const Form form = divided(cutForm(mirroredEggs(), {}), order);
    const std::vector<double> left = areasOf(form, "Left"), right = areasOf(form, "Right");
    ASSERT_GE(left.size(), 4u);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t k = 0; k < left.size(); ++k)
        EXPECT_NEAR(left[k], right[k], 1e-6 * left[k]);
    expectLiesFlat(form, order);
}

TEST(Division, WhatLiesFlatStaysAsItIs)
{
    const Form pipe = cutForm(halfPipe(100, 200), {});
    const Form form = divided(pipe, {});
    ASSERT_EQ(form.pieces.size(), 1u);
    EXPECT_EQ(form.points, pipe.points);
    EXPECT_EQ(form.notes, pipe.notes);
}

/// Also beside what is closed all around, which is a problem of its own.
TEST(Division, PartsAndDartsStay)
{
    const Vec3 from(0, -100, -5), to(0, -100, 70); // up the middle of the pipe
    for (const TriangleMesh& ball : {sphere("Ball", 0.1, 0.9), sphere("Ball")}) {
        const TriangleMesh mesh = sideBySide(halfPipe(100, 200), ball);
        const Form form = divided(cutForm(mesh, {true, {}, {{"Dart", {from, to}}}}), {});
        const auto isPipe = [](const FormPiece& piece) { return piece.part == "Sheet"; };
        ASSERT_EQ(std::ranges::count_if(form.pieces, isPipe), 1);
        EXPECT_GE(std::ranges::count_if(form.pieces, [](const FormPiece& piece) { return piece.part == "Ball"; }),
                  2);
        const auto pipe = std::ranges::find_if(form.pieces, isPipe);
        const auto own = static_cast<int>(pipe - form.pieces.begin());
        double length = 0;
        for (std::size_t k = 0; k < pipe->border.size(); ++k)
            if (pipe->mates[k].piece == own)
                length += (form.points[pipe->points[pipe->border[pipe->after(k)]]] -
                           form.points[pipe->points[pipe->border[k]]])
                              .norm() /
                          2;
        EXPECT_NEAR(length, 70, 5);
    }
}

TEST(Division, AnotherProblemStays)
{
    const Form nothing = cutForm({}, {});
    EXPECT_EQ(divided(nothing, {}).problem, nothing.problem);
}

TEST(Division, IsTheSameEachTime)
{
    const Form box = cutForm(closedBox(), {});
    const Form once = divided(box, {}), again = divided(box, {});
    EXPECT_EQ(once.points, again.points);
}

/// What smoothing had left of a half was two triangles, and then two of what was left, without end.
TEST(Division, HalvesThatSmoothingTakesAwayArePartedAlongEdges)
{
    const TriangleMesh grid = gridMesh(20, 20, [](double u, double v) { return Vec3(400 * u, 400 * v, 0); });
    FormSheet sheet{grid.points, {}};
    for (const auto& [a, b, c] : grid.triangles)
        sheet.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    Halves halves;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        halves.ofTriangles.push_back(sheet.center(t).x() < 360 ? -1 : 1);
    for (const Vec3& at : sheet.points) // hardly so but at a corner
        halves.ofPoints.push_back(at.x() < 360 ? -1 : at.x() + at.y() > 799 ? 10 : 0.001);
    const std::array<FormSheet, 2> parts = cutInTwo(sheet, halves);
    EXPECT_NEAR(parts[1].area() / sheet.area(), 0.1, 0.05);
}

} // namespace bolster
