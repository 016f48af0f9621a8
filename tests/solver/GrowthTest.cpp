// Work that must not grow with the square of what there is to do.
#include "BodyTree.h"
#include "FrameFields.h"
#include "OutlineSampling.h"
#include "PatchLines.h"
#include "PreparedSheet.h"
#include "StartPlacement.h"
#include "Voxelise.h"

#include "Growth.h"
#include "TestDesigns.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <pthread.h>
#include <thread>

namespace bolster::test {
namespace {

/// A patch with n teeth, each higher than an edge is long.
Design comb(int teeth)
{
    std::vector<Vec2> points = {{0, -10}, {20.0 * teeth, -10}};
    for (int k = teeth - 1; k >= 0; --k) {
        const double x = 20.0 * k;
        points.insert(points.end(), {{x + 20, 0}, {x + 15, 60}, {x + 5, 60}, {x, 0}});
    }
    DesignBuilder b(12);
    b.patch(points, b.fabric(0.3, 0));
    return b.design();
}

/// A patch as high as its n fancy seams need.
Design seamed(int seams)
{
    DesignBuilder b(12);
    const ElementId patch = b.patch(rectangle(400, 40.0 * (seams + 1)), b.fabric(0.3, 0));
    for (int k = 1; k <= seams; ++k) {
        FancySeam seam;
        seam.patch = patch;
        seam.width = 8;
        seam.depth = 2;
        seam.curve = BSpline2(1, false, {{30, 40.0 * k}, {200, 40.0 * k + 10}, {370, 40.0 * k}});
        b.add(seam);
    }
    return b.design();
}

Design patches(int count)
{
    DesignBuilder b(60);
    const ElementId fabric = b.fabric(0.3, 0);
    Edit edit;
    int id = 100;
    for (int k = 0; k < count; ++k) {
        Patch patch;
        patch.fabric = fabric;
        patch.outline = BSpline2(1, true, rectangle(100, 100));
        edit.changes.push_back({ElementId{id++}, nullptr, makeElement(std::move(patch))});
    }
    return b.design().with(edit);
}

TEST(Growth, OutlinesWithManyPointsAreSampled)
{
    EXPECT_LT(growth(250, comb, [](const Design& design) { EXPECT_TRUE(sampleOutlines(design).problems.empty()); }),
              nearlyLinear);
}

TEST(Growth, FancySeamsAreDrawn)
{
    EXPECT_LT(
        growth(25, seamed, [](const Design& design) { EXPECT_TRUE(drawPatchLines(design).problems.empty()); }),
        nearlyLinear);
}

void prepare(const Design& design)
{
    TriangulationCache cache;
    const auto sheet = prepareSheet(design, cache);
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(sheet->leftOut.empty());
    EXPECT_FALSE(sheet->mesh.parts.empty());
}

TEST(Growth, PatchesWithTeethArePrepared)
{
    EXPECT_LT(growth(100, comb, prepare), nearlyLinear);
}

TEST(Growth, FancySeamsArePrepared)
{
    EXPECT_LT(growth(10, seamed, prepare), nearlyLinear);
}

TEST(Growth, PatchesArePrepared)
{
    EXPECT_LT(growth(500, patches, prepare), nearlyLinear);
}

/// What nothing holds lies side by side.
TEST(Growth, FreePatchesFindTheirPlaces)
{
    const auto make = [](int count) {
        TriangulationCache cache;
        return std::make_shared<const PreparedSheet>(prepareSheet(patches(count), cache).value());
    };
    const auto place = [](const std::shared_ptr<const PreparedSheet>& sheet) {
        EXPECT_EQ(startPlacement(sheet->mesh).positions.cols(), sheet->mesh.unknownCount());
    };
    EXPECT_LT(growth(1000, make, place), nearlyLinear);
}

/// Many small bodies in a large frame: what one costs must not depend on the frame.
TEST(Growth, ASmallBodyIsFilledInALargeGridAsFastAsInASmallOne)
{
    const auto bodies = frameParts(boxMesh(Box3(Vec3(0, 0, 0), Vec3(50, 50, 50))), {});
    WorkerPool pool(1);
    const auto grid = [](int thousands) {
        Voxels voxels{VoxelGrid{5, {-1, -1, -1}, {100, 100, thousands}}, {}};
        voxels.inside.assign(voxels.grid.voxelCount(), 0);
        return std::make_shared<Voxels>(std::move(voxels));
    };
    const auto fill = [&](const std::shared_ptr<Voxels>& voxels) {
        for (int round = 0; round < 20; ++round)
            EXPECT_TRUE(fillInside(bodies[0][0], *voxels, pool));
    };
    EXPECT_LT(growth(50, grid, fill, 3), 3);
}

/// A layer of n small boxes that touch nothing.
std::shared_ptr<const TriangleMesh> boxLayer(int count)
{
    auto mesh = std::make_shared<TriangleMesh>();
    const int side = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int k = 0; k < count; ++k) {
        const Vec3 low(10 * (k % side), 10 * (k / side), 0);
        const TriangleMesh box = boxMesh(Box3(low, low + Vec3(6, 6, 6)));
        const auto first = static_cast<std::uint32_t>(mesh->points.size());
        mesh->points.insert(mesh->points.end(), box.points.begin(), box.points.end());
        for (const auto& [a, b, c] : box.triangles)
            mesh->triangles.push_back({first + a, first + b, first + c});
    }
    mesh->parts = {{"Boxes", 0, static_cast<std::uint32_t>(mesh->triangles.size())}};
    return mesh;
}

/// Each voxel of a frame's contact asks for it.
TEST(Growth, TheNearestOfManyBodiesIsFoundAsFastAsOfAFew)
{
    struct Layer {
        explicit Layer(int count)
            : parts(frameParts(*boxLayer(count), {}))
        {
            std::vector<const FrameBody*> bodies;
            for (const FrameBody& body : parts[0])
                bodies.push_back(&body);
            tree.emplace(bodies);
        }
        FrameParts parts;
        std::optional<BodyTree> tree;
    };
    const auto make = [](int count) { return std::make_shared<const Layer>(count); };
    const auto ask = [](const std::shared_ptr<const Layer>& layer) {
        for (int k = 0; k < 2000; ++k) {
            const Vec3 point(0.2 * (k % 50), 5 * (k / 50), 8);
            EXPECT_LT(layer->tree->distance(point, 100), 50);
            EXPECT_FALSE(layer->tree->contains(point));
        }
    };
    EXPECT_LT(growth(500, make, ask, 4), 4);
}

using Stoppable = std::function<void(const std::stop_token&)>;

/// Seconds that this thread still works when it is asked to stop after so many.
double workedAfterStop(double seconds, const Stoppable& work)
{
    clockid_t clock{};
    pthread_getcpuclockid(pthread_self(), &clock);
    const auto worked = [clock] {
        timespec time{};
        clock_gettime(clock, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    std::stop_source stop;
    std::atomic<bool> over = false;
    double asked = 0;
    std::thread asker([&, until = worked() + seconds] {
        while (worked() < until && !over)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        asked = worked();
        stop.request_stop();
    });
    work(stop.get_token());
    const double end = worked();
    over = true;
    asker.join();
    return std::max(0.0, end - asked);
}

/// Whenever that is.
void expectStopsSoon(const Stoppable& work)
{
    const double before = workedSeconds();
    work({});
    const double whole = workedSeconds() - before;
    constexpr double soon = 0.2; // of the whole
    for (const double share : {0.02, 0.2, 0.4, 0.6, 0.8})
        EXPECT_LT(workedAfterStop(share * whole, work), soon * whole) << "at " << share << " of " << whole << " s";
}

/// Whoever closes the window or changes the design must not wait for the bodies of a frame of millions of
/// triangles.
TEST(Stopping, TheBodiesOfAFrameAreGivenUpSoon)
{
    const TriangleMesh sphere = sphereMesh(100, 150);
    expectStopsSoon([&](const std::stop_token& stop) { frameParts(sphere, {}, stop); });
    std::stop_source stop;
    stop.request_stop();
    const auto parts = frameParts(sphere, {}, stop.get_token());
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_TRUE(parts[0].empty());
}

TEST(Stopping, TheFieldsOfAFrameAreGivenUpSoon)
{
    const auto sphere = std::make_shared<const TriangleMesh>(sphereMesh(100, 60));
    FrameFields::ContactKey contact;
    contact.shape.mesh = sphere;
    contact.parts = {0};
    FrameFields::CushionKey cushion;
    cushion.frame.shape.mesh = sphere;
    cushion.frame.parts = {0};
    cushion.frame.edge = 2;
    cushion.dilation = 10;
    WorkerPool pool(1);
    expectStopsSoon([&](const std::stop_token& stop) {
        FrameFields fields; // made anew each time
        const auto field = fields.contact(contact, pool, stop);
        EXPECT_TRUE(field || stop.stop_requested());
    });
    expectStopsSoon([&](const std::stop_token& stop) {
        FrameFields fields;
        const auto field = fields.cushion(cushion, pool, stop);
        EXPECT_TRUE(field || stop.stop_requested());
    });
}

} // namespace
} // namespace bolster::test
