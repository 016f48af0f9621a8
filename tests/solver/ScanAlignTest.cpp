#include "ScanAlign.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <numbers>
#include <random>

namespace bolster::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct Body {
    std::vector<Vec3> points;
    Triangles triangles;

    void addBox(const Vec3& from, const Vec3& to)
    {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (int k = 0; k < 8; ++k)
            points.emplace_back(k & 1 ? to.x() : from.x(), k & 2 ? to.y() : from.y(), k & 4 ? to.z() : from.z());
        constexpr std::array<std::array<std::uint32_t, 4>, 6> sides = {
            {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
        for (const auto& [a, b, c, d] : sides) {
            triangles.push_back({first + a, first + b, first + c});
            triangles.push_back({first + a, first + c, first + d});
        }
    }
};

/// An armchair of boards, 800 mm wide, none like another.
Body chair()
{
    Body body;
    body.addBox({0, 0, 200}, {800, 700, 380});
    body.addBox({0, 600, 380}, {800, 760, 900});
    body.addBox({0, 0, 380}, {110, 600, 600});
    body.addBox({690, 0, 380}, {800, 600, 570});
    for (const Vec2& at : {Vec2(30, 30), Vec2(710, 40), Vec2(40, 640), Vec2(700, 650)})
        body.addBox({at.x(), at.y(), 0}, {at.x() + 50, at.y() + 50, 200});
    return body;
}

struct Scanner {
    double noise = 0;    // mm
    double outliers = 0; // share of all points: anywhere around
    std::function<bool(const Vec3&)> sees = [](const Vec3&) { return true; };
    std::size_t count = 60'000;

    /// Points of the body as they are in the scan's file.
    PointCloud scan(const Body& body, const Placement& truth) const
    {
        std::mt19937 random(7);
        std::normal_distribution<double> off(0, std::max(noise, 1e-12));
        std::uniform_real_distribution<double> share(0, 1);
        std::vector<double> areas;
        for (const auto& [a, b, c] : body.triangles)
            areas.push_back((body.points[b] - body.points[a]).cross(body.points[c] - body.points[a]).norm());
        std::discrete_distribution<std::size_t> which(areas.begin(), areas.end());
        PointCloud cloud;
        while (cloud.points.size() < count) {
            if (share(random) < outliers) {
                cloud.points.push_back(truth.filePoint(
                    Vec3(-300 + 1400 * share(random), -300 + 1400 * share(random), 1200 * share(random))));
                continue;
            }
            const auto& [a, b, c] = body.triangles[which(random)];
            double u = share(random), v = share(random);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            const Vec3 at =
                body.points[a] + u * (body.points[b] - body.points[a]) + v * (body.points[c] - body.points[a]);
            if (sees(at))
                cloud.points.push_back(truth.filePoint(at + Vec3(off(random), off(random), off(random))));
        }
        return cloud;
    }
};

/// In metres, standing anywhere.
const Placement truth{1000, Vec3(1200, -700, 340), Quat(Eigen::AngleAxisd(2.3, Vec3(0.3, -0.8, 1).normalized()))};

AlignTarget targetOf(const Body& body)
{
    AlignTarget target;
    target.add(body.points, body.triangles);
    target.build();
    return target;
}

/// As somebody clicks them: centimetres off.
std::vector<ScanPair> clicked(double off,
                              const std::vector<Vec3>& places = {{0, 0, 380}, {800, 0, 380}, {800, 760, 900}})
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> miss(-off, off);
    std::vector<ScanPair> pairs;
    for (const Vec3& place : places)
        pairs.push_back({truth.filePoint(place + Vec3(miss(random), miss(random), miss(random))), place});
    return pairs;
}

double degreesBetween(const Quat& a, const Quat& b)
{
    return a.angularDistance(b) * 180 / std::numbers::pi;
}

/// How far the farthest place of the chair is from where it should be, mm.
double misplaced(const Placement& found)
{
    double farthest = 0;
    for (const Vec3& place : chair().points)
        farthest = std::max(farthest, (found.placed(truth.filePoint(place)) - place).norm());
    return farthest;
}

void expectFound(const Scanner& scanner, const std::vector<ScanPair>& pairs)
{
    const Body body = chair();
    const ScanIndex index(scanner.scan(body, truth), {});
    const auto start = placementByPairs(pairs, Placement{1000, {}, Quat::Identity()});
    ASSERT_TRUE(start);
    const auto found = alignScan(targetOf(body), index, *start);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->placement.scale, 1000);
    EXPECT_LT(misplaced(found->placement), 1) << "from " << misplaced(*start) << " mm";
    EXPECT_LT(degreesBetween(found->placement.rotation, truth.rotation), 0.2);
    EXPECT_NEAR(found->rms, scanner.noise, 0.35 * scanner.noise + 0.1);
}

TEST(ScanAlign, PairsGiveTheirPlacementExactly)
{
    const auto found = placementByPairs(clicked(0), Placement{1000, Vec3(5, 5, 5), Quat::Identity()});
    ASSERT_TRUE(found);
    EXPECT_LT(misplaced(*found), 1e-9);
    EXPECT_LT(pairResidual(clicked(0), *found), 1e-9);
    EXPECT_GT(pairResidual(clicked(20), *found), 3);
    EXPECT_FALSE(placementByPairs(clicked(0, {{0, 0, 0}, {100, 0, 0}}), {})) << "two";
    EXPECT_FALSE(placementByPairs(clicked(0, {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}}), {})) << "a line";
    EXPECT_FALSE(placementByPairs(clicked(0, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), {})) << "a point";
}

TEST(ScanAlign, FindsBackFromClicksThatAreCentimetresOff)
{
    expectFound({}, clicked(25));
}

TEST(ScanAlign, NoiseAndOutliersDoNotMoveIt)
{
    Scanner depthCamera{3, 0.3};
    depthCamera.count = 200'000;
    expectFound(depthCamera, clicked(25));
}

TEST(ScanAlign, APartIsEnough)
{
    Scanner fromTheFront{1.5, 0.1};
    fromTheFront.sees = [](const Vec3& at) {
        return at.x() + 0.5 * at.y() < 700 && (at - Vec3(300, 300, 380)).norm() > 120;
    };
    expectFound(fromTheFront, clicked(20));
}

TEST(ScanAlign, TheRoomAroundItDoesNotCount)
{
    Body room = chair();
    room.addBox({-1500, -1500, -20}, {2500, 2500, 0});
    room.addBox({-1500, 900, 0}, {2500, 920, 2400});
    const ScanIndex index(Scanner{2, 0, [](const Vec3&) { return true; }, 300'000}.scan(room, truth), {});
    const auto start = placementByPairs(clicked(25), Placement{1000, {}, Quat::Identity()});
    const auto found = alignScan(targetOf(chair()), index, *start);
    ASSERT_TRUE(found);
    EXPECT_LT(misplaced(found->placement), 1);
    EXPECT_LT(found->matched, 0.3);
    EXPECT_GT(found->matched, 0.02);
}

TEST(ScanAlign, ALargeTurnIsFoundToo)
{
    Placement start = truth;
    const Quat turn(Eigen::AngleAxisd(0.3, Vec3(1, 0.2, 0.4).normalized()));
    const Vec3 middle(400, 380, 400);
    start.rotation = turn * truth.rotation;
    start.position = turn * (truth.position - middle) + middle + Vec3(20, -15, 10);
    const ScanIndex index(Scanner{1, 0.1}.scan(chair(), truth), {});
    const auto found = alignScan(targetOf(chair()), index, start);
    ASSERT_TRUE(found);
    EXPECT_LT(misplaced(found->placement), 1);
}

TEST(ScanAlign, IsTheSameEveryTimeAndEndsWhenStopped)
{
    const ScanIndex index(Scanner{1, 0.1}.scan(chair(), truth), {});
    const AlignTarget target = targetOf(chair());
    const auto start = placementByPairs(clicked(25), Placement{1000, {}, Quat::Identity()});
    const auto once = alignScan(target, index, *start), again = alignScan(target, index, *start);
    ASSERT_TRUE(once && again);
    EXPECT_TRUE(once->placement == again->placement);
    std::stop_source stop;
    int seen = 0;
    EXPECT_FALSE(alignScan(target, index, *start, stop.get_token(), [&](int) {
        if (++seen == 5)
            stop.request_stop();
    }));
    EXPECT_EQ(seen, 5);
}

TEST(ScanAlign, SaysWhenThereIsNothingToMatch)
{
    const ScanIndex index(Scanner{}.scan(chair(), truth), {});
    Placement far = truth;
    far.position += Vec3(20'000, 0, 0);
    EXPECT_FALSE(alignScan(targetOf(chair()), index, far));
    EXPECT_FALSE(alignScan(AlignTarget(), index, truth));
    EXPECT_FALSE(alignScan(targetOf(chair()), ScanIndex({}, {}), truth));
    PointCloud few;
    few.points.assign(5, truth.filePoint(Vec3(0, 0, 380)));
    EXPECT_FALSE(alignScan(targetOf(chair()), ScanIndex(few, {}), truth));
}

/// What is flat may slide on itself, and stays where the clicks have put it.
TEST(ScanAlign, APlateStaysInItsPlane)
{
    Body plate;
    plate.points = {{0, 0, 0}, {600, 0, 0}, {600, 400, 0}, {0, 400, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    const ScanIndex index(Scanner{0.5, 0}.scan(plate, truth), {});
    Placement start = truth;
    start.position += Vec3(0, 0, 12);
    const auto found = alignScan(targetOf(plate), index, start);
    ASSERT_TRUE(found);
    EXPECT_LT((found->placement.position - truth.position).norm(), 3);
    EXPECT_LT(std::abs((found->placement.placed(truth.filePoint(Vec3(300, 200, 0)))).z()), 0.1);
}

} // namespace
} // namespace bolster::test
