// Held normals.
#include "TestDesigns.h"

#include "DesignJson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bolster::test {
namespace {

constexpr double length = 200, width = 120; // mm
constexpr double degrees = std::numbers::pi / 180;

Vec3 leaning(double angle)
{
    return {0, -std::sin(angle), std::cos(angle)};
}

/// Normals of a patch fixed along its first side, y = 0, where the cover is asked to lean.
double leanOfFlap(const Orientation& wish, double bendingLength)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(length, width), b.fabric(0.3, bendingLength));
    FixationSeam fixed;
    fixed.stretch = {patch, 0, 1};
    fixed.curve = b.add(FixationCurve{"Rail", polyline({{0, 0, 0}, {length, 0, 0}})});
    fixed.orientation = wish;
    b.add(fixed);
    const SolveResult result = solved(b.design(), 1e-7);
    double least = 180;
    double most = -180;
    for (const Eigen::Vector3f& normal : result.surface->normals) {
        const double angle = std::atan2(-normal.y(), normal.z()) / degrees;
        least = std::min(least, angle);
        most = std::max(most, angle);
    }
    EXPECT_LT(most - least, 0.5) << "nothing else bends it";
    return 0.5 * (least + most);
}

TEST(Orientations, TurnAFreeFlap)
{
    for (const double angle : {-60.0, 25.0, 80.0})
        for (const double bendingLength : {0.0, 12.0})
            EXPECT_NEAR(leanOfFlap({Orientation::Kind::Normal, {leaning(angle * degrees)}, 1}, bendingLength),
                        angle, 0.5);
}

TEST(Orientations, ATangentLeavesTheSideOpen)
{
    const Vec3 up(0, std::cos(50 * degrees), std::sin(50 * degrees));
    for (const Vec3& direction : {up, Vec3(-up)})
        EXPECT_NEAR(std::remainder(leanOfFlap({Orientation::Kind::Tangent, {direction}, 1}, 12), 180), 50, 0.5);
}

/// A strip held at both ends, nearer together than it is long: how far it leans at the first end.
double leanOfArch(const Orientation& start, const Orientation& end)
{
    DesignBuilder b(8);
    const ElementId patch = b.patch(rectangle(100, 200), b.fabric(0.3, 8));
    const auto fix = [&](Stretch stretch, std::vector<Vec3> points, const Orientation& wish) {
        FixationSeam fixed;
        fixed.stretch = stretch;
        fixed.curve = b.add(FixationCurve{"Rail", polyline(std::move(points))});
        fixed.orientation = wish;
        b.add(fixed);
    };
    fix({patch, 0, 1}, {{0, 0, 0}, {100, 0, 0}}, start);
    fix({patch, 2, 3}, {{100, 180, 0}, {0, 180, 0}}, end);
    const SolveResult result = solved(b.design(), 1e-7);
    const auto& pattern = result.surface->topology->pattern;
    double lean = 0;
    int count = 0;
    for (std::size_t v = 0; v < pattern.size(); ++v)
        if (pattern[v].y() == 0 && pattern[v].x() > 20 && pattern[v].x() < 80) {
            const Eigen::Vector3f n = result.surface->normals[v];
            lean += std::abs(std::atan2(-n.y(), n.z())) / degrees;
            ++count;
        }
    return lean / count;
}

TEST(Orientations, ClampTheEndsOfAnArch)
{
    const Orientation free, level{Orientation::Kind::Normal, {Vec3(0, 0, 1)}, 1};
    EXPECT_GT(leanOfArch(free, free), 30);
    EXPECT_LT(leanOfArch(level, level), 8); // of a triangle beside the rail
    const Orientation faint{Orientation::Kind::Normal, {Vec3(0, 0, 1)}, 0};
    EXPECT_NEAR(leanOfArch(faint, faint), leanOfArch(free, free), 1e-6);
}

TEST(Orientations, AreInterpolatedAlongTheStretch)
{
    const Orientation wish{Orientation::Kind::Normal, {Vec3(0, 0, 2), Vec3(0, 0, 1), Vec3(0, -3, 0)}, 1};
    EXPECT_TRUE(wish.at(0.25).isApprox(Vec3(0, 0, 1)));
    EXPECT_TRUE(wish.at(0.75).isApprox(Vec3(0, -1, 1).normalized()));
    EXPECT_TRUE(wish.at(1).isApprox(Vec3(0, -1, 0)));
}

TEST(Orientations, HoldAStretchWithoutACurve)
{
    // Fixed along y = 0 only; what is held stands at the far side.
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(length, width), b.fabric(0.3, 30));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {length, 0, 0}}));
    FixationSeam held;
    held.stretch = {patch, 2, 3};
    held.orientation.directions = {leaning(40 * degrees)};
    b.add(held);
    const SolveResult result = solved(b.design(), 1e-7);
    for (const Eigen::Vector3f& normal : result.surface->normals)
        EXPECT_NEAR(std::atan2(-normal.y(), normal.z()) / degrees, 40, 1);
}

TEST(Orientations, HoldAHandleWithoutATarget)
{
    DesignBuilder b(10);
    const ElementId patch = b.patch(rectangle(length, width), b.fabric(0.3, 30));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {length, 0, 0}}));
    HandleCurve handle;
    handle.patch = patch;
    handle.curve = BSpline2(1, false, {{30, 60}, {170, 60}});
    handle.orientation.directions = {leaning(35 * degrees)};
    b.add(handle);
    const SolveResult result = solved(b.design(), 1e-7);
    EXPECT_TRUE(result.warnings.empty());
    for (const Eigen::Vector3f& normal : result.surface->normals)
        EXPECT_NEAR(std::atan2(-normal.y(), normal.z()) / degrees, 35, 1);
    EXPECT_EQ(result.report.constraints.fixed, 21) << "the handle's vertices are free";
}

} // namespace
} // namespace bolster::test
