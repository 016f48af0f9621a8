// What may change in a design, each by one number.
#include "ArcLength.h"
#include "TestFreedoms.h"
#include "TestPaths.h"
#include "TwinEdits.h"

#include "DesignJson.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <numeric>
#include <sstream>

namespace bolster::test {
namespace {

const Patch& patchOf(const Design& design, ElementId id)
{
    return *design.find<Patch>(id);
}

double areaOf(const Design& design, ElementId id)
{
    return std::abs(patchOf(design, id).outline.signedArea());
}

double perimeterOf(const BSpline2& outline)
{
    return ArcLength2(outline).between(outline.domainStart(), outline.domainEnd());
}

Design designWithTwins()
{
    std::ifstream file(dataFolder() + "/designs/built-seat.json");
    std::stringstream text;
    text << file.rdbuf();
    return readDesign(text.str()).design;
}

constexpr ElementId left{4}, right{12}, leftRail{6}, rightRail{14}; // of the design with twins

TEST(Freedom, OffsetGrowsASquareByItsPerimeter)
{
    DesignBuilder b(10);
    const ElementId fabric = b.fabric(0.3, 5);
    const ElementId square = b.patch(rectangle(200, 200), fabric);
    std::vector<Vec2> clockwise = rectangle(200, 200);
    std::ranges::reverse(clockwise);
    const ElementId other = b.patch(clockwise, fabric);
    for (const ElementId id : {square, other}) {
        const Freedom offset{.kind = Freedom::Kind::Offset, .element = id};
        const Design larger = changedBy(b.design(), offset, 1), smaller = changedBy(b.design(), offset, -1);
        EXPECT_NEAR(areaOf(larger, id), 202 * 202, 1e-9) << "corners are mitred";
        EXPECT_NEAR(areaOf(smaller, id), 198 * 198, 1e-9);
    }
}

TEST(Freedom, OffsetGrowsPatchesOfSamplesByTheirPerimeter)
{
    for (const char* name : {"box-cushion", "cylinder", "pillow", "car-seat", "trapezoid"}) {
        const Design design = sample(name);
        design.each<Patch>([&](ElementId id, const Patch& patch) {
            const Design larger = changedBy(design, {.kind = Freedom::Kind::Offset, .element = id}, 1);
            const double perimeter = perimeterOf(patch.outline);
            EXPECT_NEAR(areaOf(larger, id) - areaOf(design, id), perimeter, 0.02 * perimeter)
                << name << ", " << patch.name;
        });
    }
}

/// The square's lower edge goes outwards; those beside it are prolonged, the upper one stays.
TEST(Freedom, OffsetOfOneEdgeKeepsTheOthersOnTheirLines)
{
    DesignBuilder b(10);
    const ElementId id = b.patch(rectangle(200, 200), b.fabric(0.3, 5));
    const Design lower =
        changedBy(b.design(), {.kind = Freedom::Kind::Offset, .element = id, .from = 0, .to = 1}, 3);
    EXPECT_EQ(patchOf(lower, id).outline.points(), (std::vector<Vec2>{{0, -3}, {200, -3}, {200, 200}, {0, 200}}));
    const Design first =
        changedBy(b.design(), {.kind = Freedom::Kind::Offset, .element = id, .from = 3, .to = 4}, 3);
    EXPECT_EQ(patchOf(first, id).outline.points(), (std::vector<Vec2>{{-3, 0}, {200, 0}, {200, 200}, {-3, 200}}))
        << "the edge that ends where the outline begins";
}

/// A trapezoid's edges that stay are not at right angles to the one that goes.
TEST(Freedom, OffsetOfAnEdgeProlongsSlantedNeighbours)
{
    DesignBuilder b(10);
    const ElementId id = b.patch({{0, 0}, {300, 0}, {250, 200}, {50, 200}}, b.fabric(0.3, 5));
    const Design lower =
        changedBy(b.design(), {.kind = Freedom::Kind::Offset, .element = id, .from = 0, .to = 1}, 4);
    const std::vector<Vec2>& points = patchOf(lower, id).outline.points();
    EXPECT_TRUE(points[0].isApprox(Vec2(-1, -4), 1e-6)) << points[0].transpose();
    EXPECT_TRUE(points[1].isApprox(Vec2(301, -4), 1e-6)) << points[1].transpose();
}

TEST(Freedom, OffsetOfOneCurvedEdgeKeepsTheOthers)
{
    const Design design = sample("pillow");
    const ElementId id{2};
    const Design changed = changedBy(design, {.kind = Freedom::Kind::Offset, .element = id, .from = 0, .to = 3}, 2);
    const BSpline2 &before = patchOf(design, id).outline, &after = patchOf(changed, id).outline;
    for (int k = 1; k < 120; ++k) {
        if (k % 30 == 0)
            continue; // corners
        const double t = k / 10.0, off = (before.closest(after.at(t)).point - after.at(t)).norm();
        EXPECT_NEAR(off, t < 3 ? 2 : 0, t < 3 ? 0.1 : 0.005) << t;
    }
    EXPECT_EQ(after.points()[6], before.points()[6]) << "a corner that has nothing to do with it";
}

TEST(Freedom, SizeScalesAboutTheMiddle)
{
    const Design design = sample("pillow");
    const ElementId id{2};
    const Design larger = changedBy(design, {.kind = Freedom::Kind::Size, .element = id}, 1);
    EXPECT_NEAR(areaOf(larger, id) / areaOf(design, id), 1.0201, 1e-12);
    EXPECT_LT(
        (patchOf(larger, id).outline.boundingBox().center() - patchOf(design, id).outline.boundingBox().center())
            .norm(),
        1e-9);
    EXPECT_EQ(patchOf(larger, ElementId{3}), patchOf(design, ElementId{3}));
}

TEST(Freedom, TwinsFollow)
{
    const Design design = designWithTwins();
    ASSERT_TRUE(patchOf(design, right).twin);
    const auto isMirrored = [](const Design& changed, ElementId original, ElementId follower) {
        return edits::mirroredElement(changed, original) == follower;
    };
    const double before = areaOf(design, left);
    EXPECT_NEAR(areaOf(design, right), before, 1e-6 * before);
    const Design offset = changedBy(design, {.kind = Freedom::Kind::Offset, .element = left}, 1);
    EXPECT_NE(areaOf(offset, left), before);
    EXPECT_NEAR(areaOf(offset, right), areaOf(offset, left), 1e-6 * before);
    EXPECT_TRUE(isMirrored(offset, left, right));
    const Design shifted =
        changedBy(design, {.kind = Freedom::Kind::CurvePlace, .element = leftRail, .axis = 0}, 2);
    const auto& one = design.find<FixationCurve>(rightRail)->curve.points();
    const auto& other = shifted.find<FixationCurve>(rightRail)->curve.points();
    for (std::size_t k = 0; k < one.size(); ++k)
        EXPECT_LT((other[k] - one[k] - Vec3(-2, 0, 0)).norm(), 1e-9) << "on the other side, the other way";
    const Design fuller =
        changedBy(design, {.kind = Freedom::Kind::Number, .element = left, .field = "pressure"}, 0.1);
    EXPECT_NEAR(patchOf(fuller, right).pressure, patchOf(design, left).pressure + 0.1, 1e-12);
}

/// Two rails that meet end to end, a third one that ends on the first, and a ring.
TEST(Freedom, CurvesThatMeetStillDo)
{
    DesignBuilder b(10);
    const auto rail = [&](std::vector<Vec3> points, bool closed = false) {
        return b.add(FixationCurve{"Rail", polyline(std::move(points), closed)});
    };
    const ElementId first = rail({{0, 0, 0}, {100, 0, 0}, {200, 0, 0}}),
                    second = rail({{200, 0, 0}, {200, 300, 0}});
    const ElementId third = rail({{50, 0, 0}, {50, 80, 0}}), ring = rail({{0, 0, 9}, {9, 0, 9}, {0, 9, 9}}, true);
    const auto points = [](const Design& design, ElementId id) {
        return design.find<FixationCurve>(id)->curve.points();
    };
    const Design lifted =
        changedBy(b.design(), {.kind = Freedom::Kind::CurvePlace, .element = first, .axis = 2}, 4);
    EXPECT_EQ(points(lifted, first), (std::vector<Vec3>{{0, 0, 4}, {100, 0, 4}, {200, 0, 2}}));
    EXPECT_EQ(points(lifted, second), (std::vector<Vec3>{{200, 0, 2}, {200, 300, 0}}));
    EXPECT_EQ(points(lifted, third), (std::vector<Vec3>{{50, 0, 4}, {50, 80, 0}})) << "it ends on the first";
    EXPECT_EQ(points(lifted, ring), points(b.design(), ring));
    const std::array both{Freedom{.kind = Freedom::Kind::CurvePlace, .element = first, .axis = 2},
                          Freedom{.kind = Freedom::Kind::CurvePlace, .element = second, .axis = 2}};
    const Design together = withFreedoms(b.design(), both, Eigen::Vector2d(4, 4));
    EXPECT_EQ(points(together, second), (std::vector<Vec3>{{200, 0, 4}, {200, 300, 4}}));
    const Design other = changedBy(b.design(), {.kind = Freedom::Kind::CurvePlace, .element = third, .axis = 2}, 4);
    EXPECT_EQ(points(other, third), (std::vector<Vec3>{{50, 0, 0}, {50, 80, 4}})) << "the first one stays";
}

/// Whose fixation curves meet end to end.
TEST(Freedom, FixationsOfTheCarSeatMayMove)
{
    const Design design = sample("car-seat");
    const std::vector<Freedom> freedoms = fixationFreedoms(design);
    EXPECT_EQ(freedoms.size(), 36u);
    for (const Freedom& freedom : freedoms)
        EXPECT_FALSE(hasErrors(checkSolvable(changedBy(design, freedom, 1)))) << freedom.name;
}

/// A roof that falls by half of the way on both sides of the ridge at y = 0.
TriangleMesh roof()
{
    TriangleMesh mesh;
    mesh.points = {{0, -100, -50}, {400, -100, -50}, {0, 0, 0}, {400, 0, 0}, {0, 100, -50}, {400, 100, -50}};
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
    return mesh;
}

/// Held by a curve on the roof, on the side of negative y.
Design heldOnRoof(double y)
{
    Design design = sample("cylinder");
    ElementId curve{};
    design.each<FixationSeam>([&](ElementId, const FixationSeam& held) { curve = held.curve; });
    FixationCurve rail = *design.find<FixationCurve>(curve);
    rail.curve = BSpline3(1, false, {{100, y, -std::abs(y) / 2}, {300, y, -std::abs(y) / 2}});
    design = design.with({{}, {{curve, nullptr, makeElement(rail)}}});
    return design.with({{}, {{ElementId{900}, nullptr, makeElement(Frame{})}}});
}

TEST(Freedom, FixationCurvesSlideOnTheFrameThatTheyLieOn)
{
    const Design design = heldOnRoof(-20);
    DesignFiles files;
    files.meshes[ElementId{900}] = std::make_shared<TriangleMesh>(roof());
    std::vector<Freedom> slides;
    for (const Freedom& freedom : fixationFreedoms(design, files))
        if (freedom.kind == Freedom::Kind::CurveSlide)
            slides.push_back(freedom);
    ASSERT_EQ(slides.size(), 2U) << "sideways, and turned";
    const auto pointsAt = [&](double sideways, double turned) {
        const Design moved = withFreedoms(design, slides, Eigen::Vector2d(sideways, turned));
        return moved.find<FixationCurve>(slides.front().element)->curve.points();
    };
    const Vec3 upwards = Vec3(0, 2, 1).normalized();
    const std::vector<Vec3> near = pointsAt(10, 0), back = pointsAt(-10, 0), turned = pointsAt(0, 10);
    const double way = near[0].y() > -20 ? 1 : -1; // which side is left is not asked here
    EXPECT_LT((near[0] - Vec3(100, -20, -10) - way * 10 * upwards).norm(), 1e-3);
    EXPECT_LT((back[1] - Vec3(300, -20, -10) + way * 10 * upwards).norm(), 1e-3);
    EXPECT_LT((turned[0] - Vec3(100, -20, -10) + way * 10 * upwards).norm(), 1e-3);
    EXPECT_LT((turned[1] - Vec3(300, -20, -10) - way * 10 * upwards).norm(), 1e-3);
    for (const Vec3& point : pointsAt(way * 60, 0)) { // over the ridge
        EXPECT_GT(point.y(), 20);
        EXPECT_NEAR(point.z(), -point.y() / 2, 1e-3) << "on the other side of the roof";
    }
    EXPECT_TRUE(withFreedoms(design, slides, Eigen::Vector2d::Zero()) == design);
}

TEST(Freedom, FixationCurvesThatLieOnNoFrameGoAnywhere)
{
    Design design = heldOnRoof(-20);
    DesignFiles files;
    files.meshes[ElementId{900}] = std::make_shared<TriangleMesh>(roof());
    Frame above;
    above.position = {0, 0, 50}; // mm
    design = design.with({{}, {{ElementId{900}, nullptr, makeElement(above)}}});
    const std::vector<Freedom> freedoms = fixationFreedoms(design, files);
    EXPECT_EQ(freedoms.size(), fixationFreedoms(design).size());
    for (const Freedom& freedom : freedoms)
        EXPECT_EQ(freedom.kind, Freedom::Kind::CurvePlace);
}

/// Those of twins would be there twice.
TEST(Freedom, TwinsThatFollowAreNotFree)
{
    const Design design = designWithTwins();
    for (const std::vector<Freedom>& freedoms :
         {outlineFreedoms(design), fixationFreedoms(design), pressureFreedoms(design)}) {
        EXPECT_FALSE(freedoms.empty());
        for (const Freedom& freedom : freedoms) {
            EXPECT_NE(freedom.element, right);
            EXPECT_NE(freedom.element, rightRail);
        }
    }
}

TEST(Freedom, ZeroesChangeNothing)
{
    for (const Design& design : {sample("box-cushion"), sample("car-seat-cushioned"), designWithTwins()}) {
        std::vector<Freedom> freedoms = outlineFreedoms(design);
        for (const std::vector<Freedom>& more :
             {foamFreedoms(design), fixationFreedoms(design), pressureFreedoms(design)})
            freedoms.insert(freedoms.end(), more.begin(), more.end());
        design.each<Patch>([&](ElementId id, const Patch&) {
            freedoms.push_back({.kind = Freedom::Kind::Offset, .element = id});
            freedoms.push_back({.kind = Freedom::Kind::Size, .element = id});
        });
        EXPECT_TRUE(withFreedoms(design, freedoms, Eigen::VectorXd::Zero(std::ssize(freedoms))) == design);
    }
}

TEST(Freedom, SeveralAddUp)
{
    const Design design = sample("box-cushion");
    const ElementId top{2}, curve{7};
    const std::array freedoms{
        Freedom{.kind = Freedom::Kind::OutlinePoint, .element = top, .index = 1, .direction = Vec2::UnitX()},
        Freedom{.kind = Freedom::Kind::OutlinePoint, .element = top, .index = 1, .direction = Vec2::UnitY()},
        Freedom{.kind = Freedom::Kind::Offset, .element = top},
        Freedom{.kind = Freedom::Kind::CurvePlace, .element = curve, .axis = 2},
        Freedom{.kind = Freedom::Kind::CurvePlace, .element = curve, .axis = 0},
        Freedom{.kind = Freedom::Kind::Number, .element = top, .field = "pressure"},
        Freedom{.kind = Freedom::Kind::Number, .element = top, .field = "pressure"}};
    Eigen::VectorXd values(7);
    values << 3, 4, 1, 5, 6, 0.1, 0.1;
    const Design changed = withFreedoms(design, freedoms, values);
    EXPECT_LT((patchOf(changed, top).outline.points()[1] - Vec2(504, 3)).norm(), 1e-9);
    EXPECT_LT((changed.find<FixationCurve>(curve)->curve.points()[0] - Vec3(-244, -250, 5)).norm(), 1e-9);
    EXPECT_NEAR(patchOf(changed, top).pressure, 0.5, 1e-12);
}

TEST(Freedom, OfOutlinesAreAcrossThemAndBothWaysAtCorners)
{
    const Design design = sample("pillow");
    const std::vector<Freedom> freedoms = outlineFreedoms(design, std::array{ElementId{3}});
    EXPECT_EQ(freedoms.size(), 8u + 4 * 2) << "eight points on edges, four corners";
    const Vec2 middle = patchOf(design, ElementId{3}).outline.boundingBox().center();
    for (const Freedom& freedom : freedoms) {
        EXPECT_EQ(freedom.element, ElementId{3});
        EXPECT_NEAR(freedom.direction.norm(), 1, 1e-12);
        const bool isCorner = freedom.index % 3 == 0;
        const Vec2 at = patchOf(design, ElementId{3}).outline.points()[static_cast<std::size_t>(freedom.index)];
        EXPECT_TRUE(isCorner || freedom.direction.dot(at - middle) > 0) << "outwards: " << freedom.name;
    }
    EXPECT_EQ(outlineFreedoms(design).size(), 2 * freedoms.size());
}

TEST(Freedom, WhatIsNotThereChangesNothing)
{
    const Design design = sample("box-cushion");
    for (const Freedom::Kind kind : {Freedom::Kind::OutlinePoint, Freedom::Kind::Offset, Freedom::Kind::Size,
                                     Freedom::Kind::CurvePlace, Freedom::Kind::Number})
        EXPECT_TRUE(changedBy(design, {.kind = kind, .element = ElementId{999}, .field = "pressure"}, 1) == design);
    EXPECT_TRUE(changedBy(design, {.kind = Freedom::Kind::Number, .element = ElementId{2}, .field = "x"}, 1) ==
                design);
    EXPECT_TRUE(foamFreedoms(design).empty());
    EXPECT_EQ(foamFreedoms(sample("car-seat-cushioned")).size(), 1u);
}

} // namespace
} // namespace bolster::test
