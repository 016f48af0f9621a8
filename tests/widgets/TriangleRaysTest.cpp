#include "TriangleRays.h"
#include "CoverOcclusion.h"
#include "CoverSetup.h"
#include "FrameShapes.h"

#include <QTest>

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace bolster::test {
namespace {

using Vec3f = Eigen::Vector3f;

struct Soup {
    std::vector<Vec3f> points;
    std::vector<TriangleRays::Triangle> triangles;
};

Soup randomSoup(int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-100, 100), size(-12, 12);
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const Vec3f center(place(random), place(random), place(random));
        for (int corner = 0; corner < 3; ++corner)
            soup.points.push_back(center + Vec3f(size(random), size(random), size(random)));
        const auto first = static_cast<std::uint32_t>(3 * i);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// Each triangle alone.
std::optional<TriangleRays::Hit> slowly(const Soup& soup, const Vec3f& origin, const Vec3f& direction)
{
    std::optional<TriangleRays::Hit> best;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
        TriangleRays one;
        one.build(soup.points, {soup.triangles[t]});
        const auto hit = one.first(origin, direction);
        if (hit && (!best || hit->distance < best->distance))
            best = TriangleRays::Hit{t, hit->distance};
    }
    return best;
}

TEST(TriangleRays, FindsTheNearestPlace)
{
    const Soup soup = randomSoup(300);
    TriangleRays rays;
    rays.build(soup.points, soup.triangles);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> place(-130, 130);
    constexpr float far = std::numeric_limits<float>::max();
    for (int i = 0; i < 100; ++i) {
        const Vec3f point(place(random), place(random), place(random));
        const auto found = rays.nearest(point, far);
        ASSERT_TRUE(found);
        const float distance = (found->point - point).norm();
        EXPECT_FALSE(rays.nearest(point, 0.99F * distance));
        // No place of any triangle is nearer, wherever it is.
        for (const TriangleRays::Triangle& t : soup.triangles)
            for (int u = 0; u <= 6; ++u)
                for (int v = 0; u + v <= 6; ++v) {
                    const Vec3f p = soup.points[t[0]] +
                                    static_cast<float>(u) / 6 * (soup.points[t[1]] - soup.points[t[0]]) +
                                    static_cast<float>(v) / 6 * (soup.points[t[2]] - soup.points[t[0]]);
                    ASSERT_GE((p - point).norm(), distance - 1e-3F);
                }
        // It lies on its triangle.
        TriangleRays one;
        one.build(soup.points, {soup.triangles[found->triangle]});
        EXPECT_LT((one.nearest(found->point, far)->point - found->point).norm(), 1e-3F);
    }
    EXPECT_FALSE(TriangleRays().nearest(Vec3f::Zero(), far));
}

TEST(TriangleRays, FindsWhatASlowSearchFinds)
{
    const Soup soup = randomSoup(200);
    TriangleRays rays;
    rays.build(soup.points, soup.triangles);
    std::mt19937 random(8);
    std::normal_distribution<float> normal;
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3f origin = 150 * Vec3f(normal(random), normal(random), normal(random));
        const Vec3f direction = (Vec3f(normal(random), normal(random), normal(random)) * 30 - origin).normalized();
        const auto fast = rays.first(origin, direction), slow = slowly(soup, origin, direction);
        ASSERT_EQ(fast.has_value(), slow.has_value());
        if (!fast)
            continue;
        ++hits;
        EXPECT_EQ(fast->triangle, slow->triangle);
        EXPECT_TRUE(rays.blocked(origin, direction, fast->distance + 0.01F));
        EXPECT_FALSE(rays.blocked(origin, direction, fast->distance - 0.01F));
    }
    EXPECT_GT(hits, 30);
}

TEST(TriangleRays, FollowsMovedPoints)
{
    Soup soup = randomSoup(50);
    TriangleRays rays;
    rays.build(soup.points, soup.triangles);
    for (Vec3f& p : soup.points)
        p = Vec3f(-p.y(), p.x() + 500, p.z());
    rays.move(soup.points);
    const Vec3f target = (soup.points[30] + soup.points[31] + soup.points[32]) / 3;
    EXPECT_TRUE(rays.first(target + Vec3f(0, 0, 1000), {0, 0, -1}));
}

TEST(TriangleRays, HitsEdgesThatLieAlongTheRay)
{
    const SurfaceMeshPtr cover = twoSquaresCover();
    std::vector<Vec3f> points;
    for (const Vec3& p : cover->positions)
        points.push_back(p.cast<float>());
    TriangleRays rays;
    rays.build(points, cover->topology->triangles);
    for (const float away : {10.F, 1e3F, 1e5F})
        for (const Vec3f& p : points) {
            const auto hit = rays.first(p + Vec3f(0, 0, away), {-0.F, 0, -1});
            ASSERT_TRUE(hit);
            EXPECT_NEAR(hit->distance, away, 1e-6F * away);
        }
}

TEST(TriangleRays, LivesWithBrokenInput)
{
    TriangleRays rays;
    EXPECT_FALSE(rays.first({0, 0, 0}, {0, 0, 1}));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    rays.build({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 2, 3}, {1, 2, 99}});
    EXPECT_TRUE(rays.first({0, 0, 5}, {0, 0, -1}));
    EXPECT_FALSE(rays.blocked({0, 0, 5}, {0, 0, -1}, 2));
}

TEST(CoverOcclusion, CoversShadeTheGroundBelow)
{
    CoverOcclusion::Input input;
    input.surface = twoSquaresCover();
    input.floor = -30;
    const auto result = CoverOcclusion::of(input, {});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->topology, 77u);
    ASSERT_EQ(result->outside.size(), input.surface->positions.size());
    EXPECT_FLOAT_EQ(result->outside[40], 1);
    const CoverOcclusion::Ground& ground = result->ground;
    const auto openAt = [&](double x, double y) {
        const Vec2 cell = (Vec2(x, y) - ground.corner) / ground.side * ground.count;
        return ground.open[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(ground.count) +
                           static_cast<std::size_t>(cell.x())];
    };
    EXPECT_LT(openAt(200, 100), 0.3);
    EXPECT_GT(openAt(-200, 100), 0.9);
}

TEST(CoverOcclusion, StopsAndLivesWithNothing)
{
    EXPECT_TRUE(CoverOcclusion::of({}, {}));
    std::stop_source stop;
    stop.request_stop();
    CoverOcclusion::Input input;
    input.surface = twoSquaresCover();
    EXPECT_FALSE(CoverOcclusion::of(input, stop.get_token()));
}

TEST(FrameShapes, AreHitWhereTheFrameStands)
{
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}; // in the file's plane y = 0
    mesh->triangles = {{0, 1, 2}};
    Scene::FrameLook look{mesh, {}};
    look.placement.scale = 100;
    look.placement.position = {0, 0, 50};
    look.placement.rotation = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()); // the file's y points up
    int calls = 0;
    FrameShapes shapes([&] { ++calls; });
    shapes.setFrames({look}, {ElementId{9}});
    EXPECT_EQ(shapes.shapes(), std::vector<FrameShapes::ShapePtr>{nullptr});
    const Camera::Ray down{{20, -20, 500}, {0, 0, -2}};
    ASSERT_TRUE(QTest::qWaitFor([&] { return shapes.first(down).has_value(); }, 20000));
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(shapes.first(down)->frame, ElementId{9});
    EXPECT_TRUE(shapes.first(down)->position.isApprox(Vec3(20, -20, 50), 1e-5));
    EXPECT_FALSE(shapes.first({{20, 20, 500}, {0, 0, -2}}));

    look.placement.position.z() = 80; // at once: the tree is the same
    shapes.setFrames({look}, {ElementId{9}});
    ASSERT_TRUE(shapes.first(down));
    EXPECT_NEAR(shapes.first(down)->position.z(), 80, 1e-3);

    EXPECT_EQ(calls, 1);
    ASSERT_TRUE(shapes.shapes().front());
    EXPECT_TRUE(shapes.shapes().front()->normals[0][0].isApprox(Eigen::Vector3f(0, -1, 0), 1e-5F)); // the file's

    shapes.setFrames({}, {});
    EXPECT_FALSE(shapes.first(down));
}

} // namespace
} // namespace bolster::test
