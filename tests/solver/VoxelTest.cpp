// Frames as voxels, and the field of forces around them.
#include "BodyTree.h"
#include "DistanceTransform.h"
#include "DrawField.h"
#include "ForceField.h"
#include "FrameBodies.h"
#include "Voxelise.h"

#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bolster::test {
namespace {

Voxels voxelsOf(const TriangleMesh& mesh, double edge, int margin = 1, int threads = 2)
{
    WorkerPool pool(threads);
    Voxels voxels{VoxelGrid::around(mesh.boundingBox(), edge, margin), {}};
    voxels.inside.assign(voxels.grid.voxelCount(), 0);
    for (const auto& bodies : frameParts(mesh, {}))
        for (const FrameBody& body : bodies)
            fillInside(body, voxels, pool);
    return voxels;
}

/// Expects a voxel to be set exactly if its centre lies in one of the boxes, and is not within `doubt` of the plane
/// x = 0.
void expectBoxes(const Voxels& voxels, const std::vector<Box3>& boxes, double doubt = 0)
{
    const VoxelGrid& grid = voxels.grid;
    int wrong = 0;
    for (int z = 0; z < grid.size[2]; ++z)
        for (int y = 0; y < grid.size[1]; ++y)
            for (int x = 0; x < grid.size[0]; ++x) {
                const Vec3 centre = grid.centre(x, y, z);
                const bool inside =
                    std::any_of(boxes.begin(), boxes.end(), [&](const Box3& box) { return box.contains(centre); });
                if (std::abs(centre.x()) > doubt)
                    wrong += inside != bool(voxels.inside[grid.index(x, y, z)]);
            }
    EXPECT_EQ(wrong, 0);
}

const Box3 box(Vec3(0, 0, 0), Vec3(103, 61, 47));

TEST(Voxelise, FillsABox)
{
    expectBoxes(voxelsOf(boxMesh(box), 4), {box});
}

TEST(Voxelise, FillsABoxThatIsInsideOut)
{
    TriangleMesh mesh = boxMesh(box);
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[1]);
    expectBoxes(voxelsOf(mesh, 4), {box});
}

TEST(Voxelise, FillsABoxWithTrianglesTurnedAtRandom)
{
    TriangleMesh mesh = boxMesh(box);
    for (const int t : {1, 4, 5, 9})
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    expectBoxes(voxelsOf(mesh, 4), {box});
}

TEST(Voxelise, FillsABoxWithAMissingFaceUpToItsPlane)
{
    TriangleMesh mesh = boxMesh(box);
    removeFace(mesh, 0, box.min().x());
    expectBoxes(voxelsOf(mesh, 4), {box}, 2.5);
}

TEST(Voxelise, FillsABoxOfSeparateWalls)
{
    TriangleMesh mesh = boxMesh(box);
    // Every triangle by itself, with points of its own that lie where the others' do; some turned.
    TriangleMesh soup;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto first = static_cast<std::uint32_t>(soup.points.size());
        for (const std::uint32_t corner : mesh.triangles[t])
            soup.points.push_back(mesh.points[corner]);
        soup.triangles.push_back({first, first + 1 + t % 2, first + 2 - t % 2});
    }
    soup.parts = {{"Soup", 0, static_cast<std::uint32_t>(soup.triangles.size())}};
    expectBoxes(voxelsOf(soup, 4), {box});

    // And with gaps of half a millimetre between the walls.
    for (auto& triangle : soup.triangles)
        for (const std::uint32_t corner : triangle)
            soup.points[corner] += 0.01 * (triangleMiddle(soup, triangle) - soup.points[corner]);
    const Voxels voxels = voxelsOf(soup, 4);
    const auto count = std::count(voxels.inside.begin(), voxels.inside.end(), 1);
    EXPECT_NEAR(static_cast<double>(count) * 64, box.volume(), 0.03 * box.volume());
}

TEST(Voxelise, OverlappingBoxesAreOne)
{
    const Box3 other(Vec3(61, 21, 11), Vec3(151, 101, 91));
    for (const bool turned : {false, true}) {
        for (const bool onePart : {false, true}) {
            TriangleMesh second = boxMesh(other);
            if (turned)
                for (auto& triangle : second.triangles)
                    std::swap(triangle[0], triangle[1]);
            TriangleMesh both = together(boxMesh(box), second);
            if (onePart)
                both.parts = {{"Both", 0, 24}};
            expectBoxes(voxelsOf(both, 4), {box, other});
        }
    }
}

TEST(Voxelise, NestedBoxesHaveNoHole)
{
    const Box3 inner(Vec3(20, 20, 10), Vec3(80, 40, 30));
    expectBoxes(voxelsOf(together(boxMesh(box), boxMesh(inner)), 4), {box});
}

/// Every face a second time, the other way round; with points of its own if these are not shared.
TriangleMesh doubleSided(const TriangleMesh& mesh, bool sharedPoints)
{
    TriangleMesh both = mesh;
    const auto count = static_cast<std::uint32_t>(mesh.points.size());
    if (!sharedPoints)
        both.points.insert(both.points.end(), mesh.points.begin(), mesh.points.end());
    const std::uint32_t first = sharedPoints ? 0 : count;
    for (const auto& [a, b, c] : mesh.triangles)
        both.triangles.push_back({first + b, first + a, first + c});
    both.parts = {{"Box", 0, static_cast<std::uint32_t>(both.triangles.size())}};
    return both;
}

TEST(Voxelise, FillsABoxThatHasEveryFaceTwice)
{
    for (const bool sharedPoints : {true, false})
        expectBoxes(voxelsOf(doubleSided(boxMesh(box), sharedPoints), 4), {box});
    TriangleMesh twice = boxMesh(box);
    twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
    twice.parts[0].triangleCount *= 2;
    expectBoxes(voxelsOf(twice, 4), {box});
}

TEST(Voxelise, FillsAnOpenBoxThatHasEveryFaceTwiceUpToItsPlane)
{
    TriangleMesh mesh = boxMesh(box);
    removeFace(mesh, 0, box.min().x());
    expectBoxes(voxelsOf(doubleSided(mesh, true), 4), {box}, 2.5);
}

TEST(Voxelise, AWallThatTwoBoxesShareIsInsideOfThem)
{
    const Box3 above(Vec3(0, 0, 47), Vec3(103, 61, 97));
    TriangleMesh both = together(boxMesh(box), boxMesh(above));
    both.parts = {{"Both", 0, 24}};
    expectBoxes(voxelsOf(both, 4), {box, above});
}

/// Rows through corners, along edges and within faces: none of them may leak.
TEST(Voxelise, RowsThatMeetCornersAndEdgesEndWhereTheBodyDoes)
{
    // The middles of voxels lie at 2, 6, 10 ...
    const Vec3 middle(50, 50, 50);
    TriangleMesh octahedron;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-40.0, 40.0})
            octahedron.points.push_back(middle + side * Vec3::Unit(axis));
    for (const std::uint32_t x : {0U, 1U})
        for (const std::uint32_t y : {2U, 3U})
            for (const std::uint32_t z : {4U, 5U}) {
                std::array<std::uint32_t, 3> corners{x, y, z};
                if ((x + y + z) % 2 == 1)
                    std::swap(corners[0], corners[1]);
                octahedron.triangles.push_back(corners);
            }
    octahedron.parts = {{"Octahedron", 0, 8}};
    for (const TriangleMesh& mesh : {octahedron, boxMesh(Box3(Vec3(2, 2, 2), Vec3(42, 30, 18)))}) {
        const Voxels voxels = voxelsOf(mesh, 4);
        const FrameParts parts = frameParts(mesh, {});
        ASSERT_TRUE(parts[0][0].closed);
        const TriangleTree& tree = parts[0][0].tree;
        int inside = 0, wrong = 0;
        for (int z = 0; z < voxels.grid.size[2]; ++z)
            for (int y = 0; y < voxels.grid.size[1]; ++y)
                for (int x = 0; x < voxels.grid.size[0]; ++x) {
                    const Vec3 centre = voxels.grid.centre(x, y, z);
                    const bool filled = voxels.inside[voxels.grid.index(x, y, z)] != 0;
                    inside += filled ? 1 : 0;
                    if (tree.distance(centre, 1) > 0.01) // else either is right
                        wrong += filled != (tree.windingNumber(centre) > 0.5) ? 1 : 0;
                }
        EXPECT_EQ(wrong, 0);
        EXPECT_GT(inside, 100);
    }
}

TEST(Voxelise, SaysWhenThereIsNothingInside)
{
    WorkerPool pool(1);
    const auto inside = [&](const TriangleMesh& mesh) {
        const auto bodies = frameParts(mesh, {});
        Voxels voxels{VoxelGrid::around(mesh.boundingBox(), 5, 1), {}};
        voxels.inside.assign(voxels.grid.voxelCount(), 0);
        bool any = false;
        for (const FrameBody& body : bodies[0]) {
            const bool filled = fillInside(body, voxels, pool);
            int looks = 1'000'000;
            EXPECT_EQ(hasInside(body, 5, looks), filled);
            any = any || filled;
        }
        EXPECT_EQ(any, std::ranges::count(voxels.inside, 1) > 0);
        return any;
    };
    EXPECT_TRUE(inside(boxMesh(box)));
    EXPECT_FALSE(inside(boxMesh(Box3(Vec3(1, 1, 0.5), Vec3(301, 301, 2))))) << "no centre of a voxel lies in it";
    TriangleMesh sheet = boxMesh(box);
    std::erase_if(sheet.triangles, [&](const auto& t) { return triangleMiddle(sheet, t).z() > 0.1; });
    sheet.parts[0].triangleCount = 2;
    EXPECT_FALSE(inside(doubleSided(sheet, true))) << "a seat of one face";
}

TEST(FrameBody, KnowsHowThickItIs)
{
    const auto thickness = [](const TriangleMesh& mesh) { return frameParts(mesh, {})[0][0].thickness; };
    EXPECT_NEAR(thickness(boxMesh(Box3(Vec3(0, 0, 0), Vec3(500, 500, 4)))).value(), 4, 0.1);
    EXPECT_NEAR(thickness(boxMesh(Box3(Vec3(0, 0, 0), Vec3(500, 10, 10)))).value(), 5, 0.1);
    TriangleMesh open = boxMesh(box);
    removeFace(open, 0, box.min().x());
    EXPECT_FALSE(thickness(open));
}

TEST(Voxelise, ASphereHasItsVolume)
{
    const TriangleMesh sphere = sphereMesh(100, 40);
    const Voxels voxels = voxelsOf(sphere, 5);
    const auto count = static_cast<double>(std::count(voxels.inside.begin(), voxels.inside.end(), 1));
    EXPECT_NEAR(count * 125 / (4.0 / 3 * M_PI * 1e6), 1, 0.01);
}

TEST(Voxelise, IsTheSameOnAnyNumberOfThreads)
{
    TriangleMesh sphere = sphereMesh(100, 24);
    removeFace(sphere, 2, sphere.boundingBox().max().z());
    const Voxels one = voxelsOf(sphere, 4, 1, 1);
    for (const int threads : {2, 3})
        EXPECT_EQ(voxelsOf(sphere, 4, 1, threads).inside, one.inside);
}

TEST(TriangleTree, FindsWindingNumbersAndDistancesOfASphere)
{
    const auto bodies = frameParts(sphereMesh(100, 48), {});
    const TriangleTree& tree = bodies[0][0].tree;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-180, 180);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p(place(random), place(random), place(random));
        if (std::abs(p.norm() - 100) < 0.5)
            continue;
        EXPECT_NEAR(tree.windingNumber(p), p.norm() < 100 ? 1 : 0, 0.1) << p.transpose();
        EXPECT_NEAR(tree.distance(p, 1e3), std::abs(p.norm() - 100), 0.5);
    }
    EXPECT_EQ(tree.distance(Vec3(500, 0, 0), 3), 3) << "not farther than asked";
}

class DistanceTransforms : public testing::TestWithParam<VoxelMetric> {};

TEST_P(DistanceTransforms, AgreeWithBruteForce)
{
    std::mt19937 random(11);
    for (const double share : {0.002, 0.05, 0.5, 0.97}) {
        Voxels voxels{{5, {-3, 2, 7}, {13, 9, 17}}, {}};
        voxels.inside.resize(voxels.grid.voxelCount());
        for (auto& inside : voxels.inside)
            inside = std::bernoulli_distribution(share)(random);
        WorkerPool pool(2);
        const std::vector<float> found = distancesTo(1, voxels, GetParam(), pool);
        const VoxelGrid& g = voxels.grid;
        std::vector<Vec3> goals;
        for (int z = 0; z < g.size[2]; ++z)
            for (int y = 0; y < g.size[1]; ++y)
                for (int x = 0; x < g.size[0]; ++x)
                    if (voxels.inside[g.index(x, y, z)])
                        goals.emplace_back(x, y, z);
        for (int z = 0; z < g.size[2]; ++z)
            for (int y = 0; y < g.size[1]; ++y)
                for (int x = 0; x < g.size[0]; ++x) {
                    double nearest = std::numeric_limits<double>::max();
                    for (const Vec3& goal : goals) {
                        const Vec3 way = goal - Vec3(x, y, z);
                        nearest =
                            std::min(nearest, GetParam() == VoxelMetric::CityBlock ? way.lpNorm<1>() : way.norm());
                    }
                    if (goals.empty())
                        EXPECT_GE(found[g.index(x, y, z)], 1e6F);
                    else
                        ASSERT_FLOAT_EQ(found[g.index(x, y, z)], static_cast<float>(nearest));
                }
    }
}

INSTANTIATE_TEST_SUITE_P(Both, DistanceTransforms, testing::Values(VoxelMetric::CityBlock, VoxelMetric::Euclidean),
                         [](const auto& chosen) {
                             return chosen.param == VoxelMetric::CityBlock ? "CityBlock" : "Euclidean";
                         });

std::shared_ptr<const ForceField> fieldOf(std::vector<CushionBody> bodies,
                                          VoxelMetric metric = VoxelMetric::CityBlock)
{
    WorkerPool pool(2);
    return cushionField(bodies, metric, pool, {});
}

std::shared_ptr<const Voxels> shared(Voxels voxels)
{
    return std::make_shared<const Voxels>(std::move(voxels));
}

const std::vector<double> one = {1, 1, 1};

TEST(ForceField, PointsTheWayOutWhateverTheVoxels)
{
    const Box3 block(Vec3(0, 0, 0), Vec3(200, 200, 100));
    for (const VoxelMetric metric : {VoxelMetric::CityBlock, VoxelMetric::Euclidean})
        for (const double edge : {2.5, 5.0, 10.0}) {
            const auto field = fieldOf({{shared(voxelsOf(boxMesh(block), edge)), 20, false}}, metric);
            for (const double depth : {3.0, 12.0, 20.0, 41.0}) {
                const Vec3 below(97, 103, 120 - depth);
                EXPECT_LT((field->at(below, one).force - Vec3(0, 0, depth)).norm(), 1e-4) << edge << " " << depth;
                EXPECT_NEAR(field->at(below, one).depth, depth, 1.3) << edge;
                EXPECT_LT((field->at({-20 + depth, 90, 40}, one).force - Vec3(-depth, 0, 0)).norm(), 1e-4);
            }
            EXPECT_LT(field->at({100, 100, 120}, one).force.norm(), 1e-4) << "nothing at the surface";
            EXPECT_LE(field->at({100, 100, 121}, one).force.z(), 0) << "nothing outwards outside";
            EXPECT_EQ(field->at({100, 100, 160}, one).force, Vec3::Zero().eval());
            EXPECT_EQ(field->at({1e9, -1e9, std::numeric_limits<double>::quiet_NaN()}, one).force,
                      Vec3::Zero().eval());
        }
}

TEST(ForceField, IsSmootherWhenEuclidean)
{
    // Across a slope of 45 degrees the city-block field is twice the way, as in the paper; the Euclidean one is
    // right.
    TriangleMesh wedge = boxMesh(Box3(Vec3(-100, -100, -100), Vec3(100, 100, 100)));
    for (Vec3& p : wedge.points)
        p = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()) * p;
    const Vec3 outwards(0, std::sqrt(0.5), std::sqrt(0.5));
    const auto lengthAt = [&](VoxelMetric metric) {
        return fieldOf({{shared(voxelsOf(wedge, 5)), 0, false}}, metric)
            ->at(60 * outwards, one)
            .force.dot(outwards);
    };
    EXPECT_NEAR(lengthAt(VoxelMetric::CityBlock), 80, 8);
    EXPECT_NEAR(lengthAt(VoxelMetric::Euclidean), 40, 4);
}

TEST(ForceField, FoamIsAddedWithItsOwnStrengthAndCutAway)
{
    const auto frame = shared(voxelsOf(boxMesh(Box3(Vec3(0, 0, 0), Vec3(100, 100, 50))), 5));
    const auto lump = shared(voxelsOf(boxMesh(Box3(Vec3(30, 30, 40), Vec3(70, 70, 90))), 5));
    const auto slot = shared(voxelsOf(boxMesh(Box3(Vec3(40, -10, 0), Vec3(60, 110, 200))), 5));
    const auto added = fieldOf({{frame, 0, false}, {lump, 10, false}});
    EXPECT_NEAR(added->at({50, 50, 95}, std::vector<double>{1, 1}).force.z(), 5, 0.1) << "10 mm of padding";
    EXPECT_NEAR(added->at({50, 50, 95}, std::vector<double>{1, 0.5}).force.z(), 2.5, 0.1);
    EXPECT_NEAR(added->at({20, 85, 45}, std::vector<double>{1, 0.5}).force.z(), 5, 0.1)
        << "the frame keeps its own";
    const auto cut = fieldOf({{frame, 0, false}, {lump, 10, false}, {slot, 0, true}});
    EXPECT_EQ(cut->at({50, 50, 50}, one).depth, 0);
    EXPECT_GT(cut->at({35, 50, 60}, one).force.x(), 0) << "it has walls now";
    EXPECT_LT(cut->insideCount(), added->insideCount());
}

TEST(DrawField, ShowsTheSurfaceAndTheWayOut)
{
    const Box3 block(Vec3(0, 0, 0), Vec3(200, 200, 100));
    const auto field = fieldOf({{shared(voxelsOf(boxMesh(block), 5)), 20, false}}, VoxelMetric::Euclidean);
    const FieldPicture picture = drawField(*field);
    ASSERT_FALSE(picture.contours.empty());
    for (const auto& segment : picture.contours)
        for (const Eigen::Vector3f& p : segment)
            EXPECT_NEAR(block.exteriorDistance(p.cast<double>()), 20, 5) << p.transpose();
    ASSERT_FALSE(picture.arrows.empty());
    for (const auto& [from, to] : picture.arrows)
        EXPECT_GE(block.exteriorDistance(to.cast<double>()), block.exteriorDistance(from.cast<double>()));
}

TEST(ForceField, StopsWhenAsked)
{
    std::stop_source stop;
    stop.request_stop();
    WorkerPool pool(2);
    const std::vector<CushionBody> bodies = {{shared(voxelsOf(boxMesh(box), 5)), 20, false}};
    EXPECT_EQ(cushionField(bodies, VoxelMetric::CityBlock, pool, stop.get_token()), nullptr);
}

TEST(BodyTree, FindsWhatAskingEachBodyFinds)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-200, 200);
    std::vector<FrameBody> bodies;
    for (int k = 0; k < 40; ++k) {
        const Vec3 low(place(random), place(random), place(random));
        for (const auto& part : frameParts(boxMesh(Box3(low, low + Vec3(30, 20, 40))), {}))
            bodies.insert(bodies.end(), part.begin(), part.end());
    }
    std::vector<const FrameBody*> all;
    for (const FrameBody& body : bodies)
        all.push_back(&body);
    const BodyTree tree(all);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 point(place(random), place(random), place(random));
        double nearest = 60;
        bool contained = false;
        for (const FrameBody& body : bodies) {
            nearest = body.tree.distance(point, nearest);
            contained = contained || body.tree.windingNumber(point) > 0.5;
        }
        EXPECT_NEAR(tree.distance(point, 60), nearest, 1e-9);
        EXPECT_EQ(tree.contains(point), contained);
        inside += contained ? 1 : 0;
    }
    EXPECT_GT(inside, 10);
    EXPECT_EQ(BodyTree({}).distance(Vec3::Zero(), 7), 7);
}

} // namespace
} // namespace bolster::test
