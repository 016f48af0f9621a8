// Covers over frames: cushioning, foam and contact.
#include "FrameWarnings.h"
#include "MakeGhosts.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "SolvePlan.h"

#include "TestDesigns.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster::test {
namespace {

/// A design that grows element by element, with its files.
struct Bench {
    explicit Bench(const Design& design)
        : input(design)
    {}

    template <class T>
    ElementId add(T element)
    {
        const ElementId id = input.design.nextId();
        input.design = input.design.with({{}, {{id, nullptr, makeElement(std::move(element))}}});
        return id;
    }
    ElementId frame(TriangleMesh mesh, Frame frame = {})
    {
        frame.name = "Frame";
        frame.file = "frame.obj";
        const ElementId id = add(frame);
        input.files.meshes[id] = std::make_shared<const TriangleMesh>(std::move(mesh));
        return id;
    }
    template <class T>
    void change(ElementId id, const std::function<void(T&)>& set)
    {
        T value = *input.design.find<T>(id);
        set(value);
        input.design = input.design.with({{}, {{id, nullptr, makeElement(std::move(value))}}});
    }
    SolveResult solve(int threads = 2, double tolerance = 1e-6) const
    {
        SolveOptions options;
        options.threads = threads;
        options.tolerance = tolerance;
        SolveResult result = solveResting(input, options);
        EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
        return result;
    }

    SolveInput input;
};

Cushion cushionOf(ElementId frame, double dilation)
{
    Cushion cushion;
    cushion.name = "Cushion";
    cushion.frame = frame;
    cushion.dilation = dilation;
    return cushion;
}

const Box3 block(Vec3(30, 30, -50), Vec3(270, 270, 70));

/// A sheet over a block, fixed all round at the height of its top: without slack its shape is unique.
Design sheetOver(double slack = 1)
{
    DesignBuilder b(10);
    const double size = 300;
    const ElementId patch = b.patch(rectangle(slack * size, slack * size), b.fabric(0.3, 6));
    const Vec3 corners[] = {{0, 0, 70}, {size, 0, 70}, {size, size, 70}, {0, size, 70}};
    for (int k = 0; k < 4; ++k)
        b.fix({patch, double(k), double(k + 1)}, polyline({corners[k], corners[(k + 1) % 4]}));
    return b.design();
}

double heightOver(const SurfaceMesh& surface, const Vec2& place)
{
    double best = 1e9, height = 0;
    for (const Vec3& p : surface.positions)
        if ((p.head<2>() - place).norm() < best) {
            best = (p.head<2>() - place).norm();
            height = p.z();
        }
    return height;
}

/// Over the top of the block. In the middle a taut sheet that is bent over the edges need not touch it.
double lowestOverBlock(const SurfaceMesh& surface)
{
    double lowest = 1e9;
    for (const Vec3& p : surface.positions)
        if ((p - block.min()).head<2>().minCoeff() > 0 && (block.max() - p).head<2>().minCoeff() > 0)
            lowest = std::min(lowest, p.z());
    return lowest;
}

/// Of the surface of a box; negative inside.
double distanceTo(const Box3& box, const Vec3& p)
{
    const double outside = box.exteriorDistance(p);
    return outside > 0 ? outside : -std::min((p - box.min()).minCoeff(), (box.max() - p).minCoeff());
}

class Distances : public testing::TestWithParam<Cushion::Distance> {};

TEST_P(Distances, ACoverCutForThePaddedBoxLiesOnIt)
{
    // The box is padded by 6 voxels of 5 mm; the cover is a lid of just that size, 150 mm high.
    const double padding = 30, size = 300, height = 150;
    Bench bench(box(size, height, 10, 4, 0));
    const ElementId frame = bench.frame(
        boxMesh(Box3(Vec3(padding, padding, -50), Vec3(size - padding, size - padding, height - padding))));
    Cushion cushion = cushionOf(frame, padding);
    cushion.distance = GetParam();
    bench.add(cushion);
    const SolveResult result = bench.solve();
    ASSERT_TRUE(result.surface);
    const Box3 padded(Vec3(0, 0, -80), Vec3(size, size, height));
    for (const Vec3& p : result.surface->positions)
        ASSERT_LT(std::abs(distanceTo(padded, p)), cushion.voxel) << p.transpose();
}

TEST_P(Distances, AHighFrameIsCoveredWithItsPadding)
{
    Bench bench(sheetOver());
    Cushion cushion = cushionOf(bench.frame(boxMesh(block)), 20);
    cushion.distance = GetParam();
    bench.add(cushion);
    const SolveResult result = bench.solve();
    ASSERT_TRUE(result.surface);
    EXPECT_GT(lowestOverBlock(*result.surface), 75);
    EXPECT_LT(lowestOverBlock(*result.surface), 91);
    ASSERT_EQ(result.report.cushions.size(), 1u);
    EXPECT_GT(result.report.cushions[0].vertices, 10);
    EXPECT_GT(result.report.cushions[0].voxels, 240 * 240 * 120 / 125);
    EXPECT_GT(result.report.constraints.ghost, 0);
}

INSTANTIATE_TEST_SUITE_P(Both, Distances,
                         testing::Values(Cushion::Distance::CityBlock, Cushion::Distance::Euclidean),
                         [](const auto& chosen) {
                             return chosen.param == Cushion::Distance::CityBlock ? "CityBlock" : "Euclidean";
                         });

/// Those of one element, in English.
std::vector<std::string> warningsOf(const Problems& problems, ElementId id)
{
    std::vector<std::string> found;
    for (const Problem& problem : problems)
        if (problem.element == id && problem.severity == Severity::Warning)
            found.push_back(problem.english());
    return found;
}

TEST(Cushion, AFrameWithEveryFaceTwiceIsCushionedAsOneThatHasThemOnce)
{
    std::vector<SurfaceMeshPtr> surfaces;
    for (const bool twice : {false, true}) {
        Bench bench(sheetOver());
        TriangleMesh mesh = boxMesh(block);
        if (twice) { // as SketchUp writes them
            for (std::size_t t = 0; t < 12; ++t) {
                const auto [a, b, c] = mesh.triangles[t];
                mesh.triangles.push_back({a, c, b});
            }
            mesh.parts[0].triangleCount = 24;
        }
        const ElementId id = bench.add(cushionOf(bench.frame(mesh), 20));
        const SolveResult result = bench.solve();
        EXPECT_GT(result.report.cushions.at(0).voxels, 1000);
        EXPECT_TRUE(warningsOf(result.warnings, id).empty());
        surfaces.push_back(result.surface);
    }
    EXPECT_EQ(surfaces[0]->positions, surfaces[1]->positions);
}

TEST(Cushion, SaysWhenItHasNoVoxelsOrAPartIsTooThinForThem)
{
    const auto warnings = [](const TriangleMesh& mesh, bool contact, bool checked) {
        Bench bench(sheetOver());
        Frame frame;
        frame.contact = contact;
        const ElementId id = bench.frame(mesh, frame);
        const ElementId cushion = contact ? id : bench.add(cushionOf(id, 20));
        return warningsOf(checked ? checkFrames(bench.input) : bench.solve().warnings, cushion);
    };
    TriangleMesh sheet = boxMesh(block);
    std::erase_if(sheet.triangles,
                  [&](const auto& t) { return triangleMiddle(sheet, t).z() < block.max().z() - 0.1; });
    sheet.parts[0].triangleCount = static_cast<std::uint32_t>(sheet.triangles.size());
    const TriangleMesh plate = boxMesh(Box3(Vec3(30, 30, 66.1), Vec3(270, 270, 67.1)));
    TriangleMesh both = together(boxMesh(block), boxMesh(Box3(Vec3(30, 30, -90), Vec3(270, 270, -89.1))));
    both.parts[1].name = "Thin plate";
    for (const bool contact : {false, true})
        for (const bool checked : {false, true}) {
            const auto one = [&](const TriangleMesh& mesh) {
                const std::vector<std::string> found = warnings(mesh, contact, checked);
                EXPECT_EQ(found.size(), 1u) << contact << checked;
                return found.empty() ? std::string() : found.front();
            };
            EXPECT_TRUE(warnings(boxMesh(block), contact, checked).empty()) << contact << checked;
            EXPECT_NE(one(sheet).find("no inside"), std::string::npos);
            EXPECT_FALSE(one(plate).empty());
            EXPECT_NE(one(both).find("\"Thin plate\""), std::string::npos);
        }
}

TEST(Cushion, WhatAFrameHidesIsNotThere)
{
    const TriangleMesh lump = boxMesh(Box3(Vec3(100, 100, 90), Vec3(200, 200, 140)));
    const SurfaceMeshPtr alone = [] {
        Bench bench(sheetOver());
        bench.add(cushionOf(bench.frame(boxMesh(block)), 10));
        return bench.solve().surface;
    }();
    TriangleMesh both = together(boxMesh(block), lump);
    both.parts[1].name = "Lump";
    TriangleMesh onePart = both;
    onePart.parts = {{"All", 0, 24}};
    for (const auto& [mesh, hidden] : {std::pair(both, "Lump"), std::pair(onePart, "All#2")}) {
        Bench bench(sheetOver());
        Frame frame;
        frame.hiddenParts = {hidden};
        const ElementId id = bench.frame(mesh, frame);
        bench.add(cushionOf(id, 10));
        const SolveResult result = bench.solve();
        EXPECT_EQ(result.surface->positions, alone->positions) << hidden;
        EXPECT_TRUE(warningsOf(result.warnings, id).empty());
        const SolveInput before = bench.input;
        bench.change<Frame>(id, [](Frame& f) { f.hiddenParts.clear(); });
        EXPECT_EQ(planSolve(before, bench.input), SolvePlan::Retarget);
        EXPECT_NE(bench.solve().surface->positions, alone->positions);
        bench.change<Frame>(id, [](Frame& f) { f.hiddenParts = {"Leg"}; });
        ASSERT_EQ(warningsOf(bench.solve().warnings, id).size(), 1u);
        EXPECT_NE(warningsOf(checkFrames(bench.input), id).at(0).find("no part \"Leg\""), std::string::npos);
    }
}

TEST(Cushion, DoesNotDependOnTheSizeOfVoxelsOrTheFramesAxes)
{
    std::vector<double> heights;
    for (const double voxel : {2.5, 5.0, 10.0}) {
        Bench bench(sheetOver());
        Frame turned; // the file lies on its side, in inches
        turned.scale = 25.4;
        turned.rotation = Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
        turned.position = Vec3(0, 0, voxel);
        TriangleMesh mesh = boxMesh(block);
        for (Vec3& p : mesh.points)
            p = turned.filePoint(p + Vec3(0, 0, voxel));
        Cushion cushion = cushionOf(bench.frame(mesh, turned), 20);
        cushion.voxel = voxel;
        bench.add(cushion);
        heights.push_back(heightOver(*bench.solve().surface, {150, 150}) - voxel);
    }
    EXPECT_NEAR(heights[0], heights[1], 2.5);
    EXPECT_NEAR(heights[1], heights[2], 2.5);
}

TEST(Cushion, ThatDoesNothingChangesNoBit)
{
    const SurfaceMeshPtr basic = Bench(sheetOver()).solve().surface;
    Bench bench(sheetOver());
    const ElementId frame = bench.frame(boxMesh(block));
    EXPECT_EQ(bench.solve().surface->positions, basic->positions) << "a frame alone";
    const ElementId id = bench.add(cushionOf(frame, 20));
    EXPECT_NE(bench.solve().surface->positions, basic->positions);
    bench.change<Cushion>(id, [](Cushion& c) { c.enabled = false; });
    EXPECT_EQ(bench.solve().surface->positions, basic->positions) << "switched off";
    bench.change<Cushion>(id, [](Cushion& c) {
        c.enabled = true;
        c.strength = 0;
    });
    EXPECT_EQ(bench.solve().surface->positions, basic->positions) << "without strength";
    bench.change<Cushion>(id, [](Cushion& c) { c.strength = 1; });
    bench.input.files = {};
    EXPECT_EQ(bench.solve().surface->positions, basic->positions) << "the file is not there";
}

TEST(Cushion, PushesMoreWithMoreStrength)
{
    double last = 0;
    for (const double strength : {0.0, 0.1, 0.4, 1.0}) {
        Bench bench(sheetOver());
        Cushion cushion = cushionOf(bench.frame(boxMesh(block)), 20);
        cushion.strength = strength;
        bench.add(cushion);
        const double height = lowestOverBlock(*bench.solve().surface);
        EXPECT_GT(height, last + 0.5) << strength;
        last = height;
    }
    EXPECT_LT(last, 91);
}

TEST(Cushion, StaysCalmWithAnyStrength)
{
    for (const double strength : {3.0, 10.0}) {
        Bench bench(sheetOver());
        Cushion cushion = cushionOf(bench.frame(boxMesh(block)), 20);
        cushion.strength = strength;
        bench.add(cushion);
        const double height = lowestOverBlock(*bench.solve().surface);
        EXPECT_GT(height, 75);
        EXPECT_LT(height, 91);
    }
}

TEST(Cushion, IsTheSameBitForBit)
{
    Bench bench(sheetOver());
    const ElementId cushion = bench.add(cushionOf(bench.frame(sphereMesh(120, 20)), 20));
    Foam foam;
    foam.cushion = cushion;
    foam.position = Vec3(150, 150, 70);
    bench.add(foam);
    const SurfaceMeshPtr first = bench.solve(1).surface;
    for (const int threads : {2, 3})
        EXPECT_EQ(bench.solve(threads).surface->positions, first->positions);
}

TEST(Foam, LiftsTheCoverWhereItLies)
{
    Bench bench(sheetOver());
    const ElementId cushion = bench.add(cushionOf(bench.frame(boxMesh(block)), 5));
    Foam foam;
    foam.cushion = cushion;
    foam.shape = Foam::Shape::Cylinder;
    foam.size = Vec3(100, 100, 60);
    foam.position = Vec3(100, 150, 75);
    const ElementId lump = bench.add(foam);
    const SurfaceMeshPtr lifted = bench.solve().surface;
    EXPECT_NEAR(heightOver(*lifted, {100, 150}), 105, 6);
    bench.change<Foam>(lump, [](Foam& f) { f.position.x() = 200; });
    const SurfaceMeshPtr moved = bench.solve().surface;
    EXPECT_NEAR(heightOver(*moved, {200, 150}), 105, 6);
    EXPECT_LT(heightOver(*moved, {60, 150}), heightOver(*lifted, {60, 150}) - 3);
    bench.change<Foam>(lump, [](Foam& f) { f.cut = true; });
    EXPECT_LT(heightOver(*bench.solve().surface, {200, 150}), 90);
}

TEST(Foam, MayBeAMesh)
{
    Bench bench(sheetOver());
    const ElementId cushion = bench.add(cushionOf(bench.frame(boxMesh(block)), 5));
    Foam foam;
    foam.cushion = cushion;
    foam.shape = Foam::Shape::Mesh;
    foam.file = "ball.obj";
    foam.scale = 50;
    foam.position = Vec3(150, 150, 65);
    const ElementId ball = bench.add(foam);
    const double without = heightOver(*bench.solve().surface, {150, 150});
    bench.input.files.meshes[ball] = std::make_shared<const TriangleMesh>(sphereMesh(1, 10));
    EXPECT_NEAR(heightOver(*bench.solve().surface, {150, 150}), 115, 15);
    EXPECT_LT(without, 85);
}

TEST(FrameContact, KeepsASheetOut)
{
    for (const double gap : {0.0, 8.0}) {
        Bench bench(sheetOver());
        const ElementId frame = bench.frame(sphereMesh(120, 24), [] {
            Frame placed;
            placed.position = Vec3(150, 150, 20);
            return placed;
        }());
        bench.change<Frame>(frame, [&](Frame& f) { f.contactGap = gap; });
        const auto deepest = [](const SurfaceMesh& surface) {
            double least = 1e9;
            for (const Vec3& p : surface.positions)
                least = std::min(least, (p - Vec3(150, 150, 20)).norm() - 120);
            return least;
        };
        EXPECT_LT(deepest(*bench.solve().surface), -10) << "through the ball without contact";
        bench.change<Frame>(frame, [](Frame& f) { f.contact = true; });
        EXPECT_GT(deepest(*bench.solve().surface), gap - 1.5);
    }
}

TEST(CushionParts, AreGuessedByWhatTheCoverIsFixedTo)
{
    // Two sheets side by side, each over a block of its own, and a third block that no sheet is near.
    DesignBuilder b(20);
    const ElementId fabric = b.fabric(0.3, 10);
    for (const double x : {0.0, 400.0}) {
        const ElementId patch = b.patch(rectangle(300, 300), fabric);
        const Vec3 corners[] = {{x, 0, 70}, {x + 300, 0, 70}, {x + 300, 300, 70}, {x, 300, 70}};
        for (int k = 0; k < 4; ++k)
            b.fix({patch, double(k), double(k + 1)}, polyline({corners[k], corners[(k + 1) % 4]}));
    }
    TriangleMesh low = boxMesh(block), high = boxMesh(Box3(Vec3(430, 30, -50), Vec3(670, 270, 90)));
    low.parts[0].name = "Low";
    high.parts[0].name = "High";
    Bench bench(b.design());
    const ElementId id = bench.add(cushionOf(bench.frame(together(low, high)), 10));
    const SurfaceMeshPtr guessed = bench.solve().surface;
    EXPECT_NEAR(heightOver(*guessed, {150, 150}), 82, 6);
    EXPECT_NEAR(heightOver(*guessed, {550, 150}), 102, 6);

    bench.change<Cushion>(id, [](Cushion& c) { c.patches = {ElementId{2}}; });
    const SurfaceMeshPtr first = bench.solve().surface;
    EXPECT_NEAR(heightOver(*first, {150, 150}), 82, 6);
    EXPECT_LT(heightOver(*first, {550, 150}), 71) << "only the first sheet";

    bench.change<Cushion>(id, [](Cushion& c) {
        c.patches = {};
        c.parts = {"Low", "Middle"};
    });
    const SolveResult named = bench.solve();
    EXPECT_LT(heightOver(*named.surface, {550, 150}), 71);
    ASSERT_EQ(named.warnings.size(), 1u);
    EXPECT_EQ(named.warnings[0].field, "parts");
    EXPECT_NE(named.warnings[0].message.english().find("\"High\""), std::string::npos);
}

TEST(Cushion, RefusesTooManyVoxelsWithARemedy)
{
    Bench bench(sheetOver());
    const ElementId frame = bench.frame(boxMesh(Box3(Vec3(-2000, -2000, -4000), Vec3(2000, 2000, 70))));
    bench.add(cushionOf(frame, 20));
    const SolveResult result = bench.solve();
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_EQ(result.warnings[0].field, "voxel_mm");
    EXPECT_NE(result.warnings[0].message.english().find("take at least 14"), std::string::npos)
        << result.warnings[0].message.english();
    EXPECT_EQ(result.surface->positions, Bench(sheetOver()).solve().surface->positions);
}

TEST(Cushion, SurvivesFramesThatEncloseNothing)
{
    TriangleMesh flat = boxMesh(block);
    flat.triangles.resize(2);
    flat.parts[0].triangleCount = 2;
    TriangleMesh point = boxMesh(Box3(Vec3(1, 1, 1), Vec3(1, 1, 1)));
    for (const TriangleMesh& mesh : {flat, point, TriangleMesh{{}, {}, {}}}) {
        Bench bench(sheetOver());
        Frame frame;
        frame.contact = true;
        bench.add(cushionOf(bench.frame(mesh, frame), 0));
        EXPECT_TRUE(bench.solve().surface);
    }
}

/// Ghosts as a solve makes them, from a cache that lives longer.
class CushionCache : public testing::Test {
protected:
    CushionCache()
    {
        cushion = bench.add(cushionOf(bench.frame(sphereMesh(150, 60)), 20));
        TriangulationCache triangles;
        sheet = *prepareSheet(bench.input, triangles);
    }
    Ghosts make(const std::stop_token& stop = {})
    {
        return makeGhosts(bench.input, sheet.mesh, cache, problems, pool, stop);
    }

    Bench bench{sheetOver()};
    ElementId cushion{};
    PreparedSheet sheet;
    GhostCache cache;
    Problems problems;
    WorkerPool pool{2};
};

TEST_F(CushionCache, IsStoppedAndTriesAgain)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(make(stop.get_token()).empty());
    const Ghosts ghosts = make();
    ASSERT_EQ(ghosts.size(), 1u);
    EXPECT_GT(ghosts[0]->gamma(sheet.mesh.parts[0]), 0);
}

TEST_F(CushionCache, KeepsFieldsUnlessTheirShapeChanges)
{
    const FrameFields::Shape shape{bench.input.files.meshes.begin()->second, 1};
    const FrameFields::CushionKey key{{shape, {0}, 5}, 20, Cushion::Distance::CityBlock, {}};
    make();
    const auto kept = cache.frames.cushion(key, pool, {});
    bench.change<Cushion>(cushion, [](Cushion& c) { c.strength = 0.5; });
    bench.change<Frame>(bench.input.design.find<Cushion>(cushion)->frame, [](Frame& f) {
        f.position = Vec3(1, 2, 3);
        f.rotation = Quat(0, 1, 0, 0);
    });
    make();
    EXPECT_EQ(cache.frames.cushion(key, pool, {}), kept) << "strength and place are no reason";
    bench.change<Cushion>(cushion, [](Cushion& c) { c.enabled = false; });
    make();
    EXPECT_EQ(cache.frames.cushion(key, pool, {}), kept) << "it may be switched on again";
    make();
    bench.change<Cushion>(cushion, [](Cushion& c) {
        c.enabled = true;
        c.dilation = 40;
    });
    make();
    make();
    EXPECT_NE(cache.frames.cushion(key, pool, {}), kept) << "another padding";
}

TEST(SolvePlan, KnowsWhatCushionsAskFor)
{
    Bench bench(sheetOver());
    const ElementId frame = bench.frame(boxMesh(block));
    const auto planAfter = [](const Bench& before, const std::function<void(Bench&)>& edit) {
        Bench after = before;
        edit(after);
        return planSolve(before.input, after.input);
    };
    const auto moveFrame = [&](Bench& b) { b.change<Frame>(frame, [](Frame& f) { f.position.x() += 1; }); };
    const auto otherMesh = [&](Bench& b) {
        b.input.files.meshes[frame] = std::make_shared<const TriangleMesh>(boxMesh(block));
    };
    EXPECT_EQ(planAfter(bench, moveFrame), SolvePlan::Nothing);
    EXPECT_EQ(planAfter(bench, otherMesh), SolvePlan::Nothing);
    EXPECT_EQ(planAfter(bench, [&](Bench& b) { b.change<Frame>(frame, [](Frame& f) { f.contact = true; }); }),
              SolvePlan::Retarget);
    EXPECT_EQ(planAfter(bench, [&](Bench& b) { b.add(cushionOf(frame, 20)); }), SolvePlan::Retarget);
    const ElementId cushion = bench.add(cushionOf(frame, 20));
    EXPECT_EQ(planAfter(bench, moveFrame), SolvePlan::Retarget);
    EXPECT_EQ(planAfter(bench, otherMesh), SolvePlan::Retarget);
    EXPECT_EQ(planAfter(bench, [&](Bench& b) { b.input.files = {}; }), SolvePlan::Retarget);
    const auto changed = [&](const std::function<void(Cushion&)>& set) {
        return planAfter(bench, [&](Bench& b) { b.change<Cushion>(cushion, set); });
    };
    EXPECT_EQ(changed([](Cushion& c) { c.name = "Another"; }), SolvePlan::Nothing);
    EXPECT_EQ(changed([](Cushion& c) { c.strength = 2; }), SolvePlan::Retarget);
    EXPECT_EQ(changed([](Cushion& c) { c.enabled = false; }), SolvePlan::Retarget);
}

} // namespace
} // namespace bolster::test
