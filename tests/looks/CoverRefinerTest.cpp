#include "CoverRefiner.h"

#include "CoverBuilder.h"
#include "CoverCreases.h"

#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <cmath>
#include <map>
#include <numbers>

namespace bolster::test {
namespace {

using Vec3f = Eigen::Vector3f;
using Side = CoverBuilder::Side;

constexpr double radius = 100;

Vec3 flat(const Vec2& p)
{
    return {p.x(), p.y(), 0};
}

/// Around the z axis; the pattern's x runs around it.
Vec3 around(const Vec2& p)
{
    return {radius * std::cos(p.x() / radius), radius * std::sin(p.x() / radius), p.y()};
}

/// A sheet that is bent in both directions.
Vec3 saddle(const Vec2& p)
{
    return {p.x(), p.y(), 12 * std::sin(p.x() / 40) * std::cos(p.y() / 50)};
}

SurfaceMeshPtr tube(Continuity continuity)
{
    CoverBuilder builder;
    const std::size_t patch = builder.grid({2 * std::numbers::pi * radius, 120}, 24, 6, around);
    builder.sew(builder.side(patch, Side::Right), builder.side(patch, Side::Left), continuity);
    return builder.cover();
}

/// Two walls of 100 mm at a right angle, sewn.
SurfaceMeshPtr edge(Continuity continuity)
{
    CoverBuilder builder;
    const std::size_t floor = builder.grid({100, 100}, 8, 8, flat);
    const std::size_t wall = builder.grid({100, 100}, 8, 8, [](const Vec2& p) { return Vec3(100, p.y(), p.x()); });
    builder.sew(builder.side(floor, Side::Right), builder.side(wall, Side::Left), continuity);
    return builder.cover();
}

double largestDistance(const std::vector<Vec3f>& points, const std::vector<Vec3>& wanted,
                       const std::vector<std::uint32_t>& vertices)
{
    double largest = 0;
    for (const std::uint32_t v : vertices)
        largest = std::max(largest, (points[v].cast<double>() - wanted[v]).norm());
    return largest;
}

struct Value {
    Vec3 at = Vec3::Zero();
    void Clear() { at.setZero(); }
    void AddWithWeight(const Value& other, float weight) { at += static_cast<double>(weight) * other.at; }
};

/// The same by OpenSubdiv's step by step evaluation.
std::vector<Value> refinedByOpenSubdiv(const LoopMesh& mesh, const LoopStencils::Points& control, int levels)
{
    namespace Far = OpenSubdiv::Far;
    namespace Sdc = OpenSubdiv::Sdc;
    std::vector<int> sizes(mesh.triangles.size(), 3), indices, creases, corners;
    for (const auto& t : mesh.triangles)
        indices.insert(indices.end(), t.begin(), t.end());
    for (const auto& e : mesh.creases)
        creases.insert(creases.end(), e.begin(), e.end());
    corners.assign(mesh.corners.begin(), mesh.corners.end());
    const std::vector<float> sharp(std::max(mesh.creases.size(), mesh.corners.size()), 10);
    Far::TopologyDescriptor of;
    of.numVertices = static_cast<int>(mesh.vertexCount);
    of.numFaces = static_cast<int>(sizes.size());
    of.numVertsPerFace = sizes.data();
    of.vertIndicesPerFace = indices.data();
    of.numCreases = static_cast<int>(mesh.creases.size());
    of.creaseVertexIndexPairs = creases.data();
    of.creaseWeights = sharp.data();
    of.numCorners = static_cast<int>(corners.size());
    of.cornerVertexIndices = corners.data();
    of.cornerWeights = sharp.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(of, Factory::Options(Sdc::SCHEME_LOOP, rules)));
    refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(levels));
    std::vector<Value> values(control.size());
    for (std::size_t v = 0; v < control.size(); ++v)
        values[v].at = control[v].head<3>().cast<double>();
    for (int level = 1; level <= levels; ++level) {
        std::vector<Value> next(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
        Value* to = next.data();
        Far::PrimvarRefiner(*refiner).Interpolate(level, values.data(), to);
        values = std::move(next);
    }
    return values;
}

TEST(CoverRefiner, PositionsAreWhatOpenSubdivEvaluates)
{
    for (const SurfaceMeshPtr& surface : {tube(Continuity::G1), edge(Continuity::C0)}) {
        CoverRefiner refiner;
        const CoverMeshPtr cover = refiner.refine(surface, 2);
        const LoopStencils::Points control = refiner.controlPoints(*surface, Vec3::Zero());
        const std::vector<Value> values =
            refinedByOpenSubdiv(CoverCreases::of(*surface->topology).merged, control, 2);
        ASSERT_EQ(cover->points.size(), cover->topology->vertexCount());
        EXPECT_EQ(cover->topology->triangles.size(), 16 * surface->topology->triangles.size());
        for (std::size_t v = 0; v < cover->points.size(); ++v)
            ASSERT_LT((cover->points[v].cast<double>() - values[cover->topology->merged[v]].at).norm(), 1e-3);
    }
}

TEST(CoverRefiner, BordersAndLinesStayWhereTheSolverPutsThem)
{
    CoverBuilder builder;
    const std::size_t patch = builder.grid({200, 160}, 14, 11, saddle, 0.25);
    builder.line(patch, 6, false);
    const SurfaceMeshPtr surface = builder.cover();
    const CoverMeshPtr cover = CoverRefiner().refine(surface, 2);
    for (const Side side : {Side::Left, Side::Right, Side::Bottom, Side::Top})
        EXPECT_LT(largestDistance(cover->points, surface->positions, builder.side(patch, side)), 0.01);
    EXPECT_LT(largestDistance(cover->points, surface->positions, surface->topology->lines[0].vertices), 0.02);
    const auto off = [](const Vec3& p) { return std::abs(p.z() - saddle(p.head<2>()).z()); };
    double coarse = 0, fine = 0;
    for (const auto& [a, b, c] : surface->topology->triangles)
        coarse = std::max(coarse, off((surface->positions[a] + surface->positions[b] + surface->positions[c]) / 3));
    for (const auto& [a, b, c] : cover->topology->triangles)
        fine = std::max(fine, off((cover->points[a] + cover->points[b] + cover->points[c]).cast<double>() / 3));
    EXPECT_LT(fine, 0.7 * coarse) << "nothing shrinks";
}

TEST(CoverRefiner, AFlatPatchStaysFlatAndKeepsItsPattern)
{
    CoverBuilder builder;
    const auto beside = [](const Vec2& p) { return Vec3(120 + p.x(), p.y(), 0); };
    const std::size_t left = builder.grid({120, 100}, 7, 6, flat, 0.3);
    const std::size_t right = builder.grid({90, 100}, 5, 6, beside, 0.3);
    builder.sew(builder.side(left, Side::Right), builder.side(right, Side::Left), Continuity::C0);
    const CoverMeshPtr cover = CoverRefiner().refine(builder.cover(), 2);
    const CoverTopology& topology = *cover->topology;
    const std::uint32_t ofLeft = topology.coarse->patches[0].triangleCount * topology.trianglesPerCoarse();
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (const std::uint32_t v : topology.triangles[t]) {
            const Vec3f place(topology.pattern[v].x() + (t < ofLeft ? 0.F : 120.F), topology.pattern[v].y(), 0.F);
            ASSERT_LT((cover->points[v] - place).norm(), 1e-3F);
            ASSERT_GT(cover->normals[v].z(), 0.9999F);
        }
    const auto corner = builder.side(right, Side::Right).back();
    EXPECT_LT((cover->points[corner] - Vec3f(210, 100, 0)).norm(), 1e-4F) << "corners stay sharp";
}

/// How far the triangles of a tube are from its radius, at most, between its rims.
double outOfRound(const std::vector<Vec3f>& points, const std::vector<CoverTopology::Triangle>& triangles)
{
    double most = 0;
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3f middle = 0.5F * (points[t[k]] + points[t[(k + 1) % 3]]);
            most = std::max(most, std::abs(static_cast<double>(middle.head<2>().norm()) - radius));
        }
    return most;
}

TEST(CoverRefiner, ATubeGetsRounder)
{
    const SurfaceMeshPtr surface = tube(Continuity::G1);
    std::vector<Vec3f> coarse;
    for (const Vec3& p : surface->positions)
        coarse.push_back(p.cast<float>());
    const double before = outOfRound(coarse, surface->topology->triangles);
    CoverRefiner refiner;
    double last = before;
    for (const int levels : {1, 2}) {
        const CoverMeshPtr cover = refiner.refine(surface, levels);
        const double after = outOfRound(cover->points, cover->topology->triangles);
        EXPECT_LT(after, last / 3);
        last = after;
    }
    EXPECT_LT(last, before / 12) << "flat triangles of that size can do a sixteenth";
}

TEST(CoverRefiner, LeavesNoCracks)
{
    for (const Continuity continuity : {Continuity::C0, Continuity::G1}) {
        const SurfaceMeshPtr surface = tube(continuity);
        const CoverMeshPtr cover = CoverRefiner().refine(surface, 2);
        const CoverTopology& topology = *cover->topology;
        const SurfaceTopology::Chain& seam = surface->topology->seams[0];
        const auto a = topology.along(seam.a), b = topology.along(seam.b);
        ASSERT_EQ(a.size(), 4 * (seam.a.size() - 1) + 1);
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(cover->points[a[k]], cover->points[b[k]]);
            EXPECT_NE(a[k], b[k]) << "each patch has its own pattern coordinates";
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto& t : topology.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[std::minmax(topology.merged[t[k]], topology.merged[t[(k + 1) % 3]])];
        const auto open = std::ranges::count_if(edges, [](const auto& edge) { return edge.second == 1; });
        EXPECT_EQ(open, 2 * 4 * 24) << "the rims";
    }
}

TEST(CoverRefiner, SeamsAreSharpOrSmoothAsTheyAreSewn)
{
    const auto normalsAtSeam = [](const CoverMesh& cover) {
        const SurfaceTopology::Chain& seam = cover.surface->topology->seams[0];
        const auto a = cover.topology->along(seam.a), b = cover.topology->along(seam.b);
        const std::size_t middle = a.size() / 2 + 1;
        return std::pair(cover.normals[a[middle]], cover.normals[b[middle]]);
    };
    const CoverMeshPtr sharp = CoverRefiner().refine(edge(Continuity::C0), 2);
    const auto [floor, wall] = normalsAtSeam(*sharp);
    EXPECT_LT(std::abs(floor.dot(wall)), 0.02F) << "still a right angle";
    const CoverMeshPtr smooth = CoverRefiner().refine(edge(Continuity::G1), 2);
    const auto [one, other] = normalsAtSeam(*smooth);
    EXPECT_GT(one.dot(other), 0.999F);

    CoverRefiner kept;
    const SurfaceMeshPtr first = edge(Continuity::C0);
    kept.refine(first, 2);
    auto changed = std::make_shared<SurfaceTopology>(*first->topology);
    changed->seams[0].continuity = Continuity::C1;
    auto second = std::make_shared<SurfaceMesh>(*first);
    second->topology = changed;
    const auto [left, right] = normalsAtSeam(*kept.refine(second, 2));
    EXPECT_GT(left.dot(right), 0.999F) << "the same triangles sewn in another way";
}

TEST(CoverRefiner, FoldedLinesStayFolded)
{
    const auto roof = [](const Vec2& p) { return Vec3(p.x(), p.y(), 50 - 0.8 * std::abs(p.x() - 50)); };
    double height[2];
    for (const bool crease : {false, true}) {
        CoverBuilder builder;
        const std::size_t patch = builder.grid({100, 100}, 8, 8, roof);
        builder.line(patch, 4, crease);
        const CoverMeshPtr cover = CoverRefiner().refine(builder.cover(), 2);
        height[crease] = 0;
        for (std::uint32_t v = 0; v < cover->topology->vertexCount(); ++v)
            height[crease] =
                std::max(height[crease], std::abs(static_cast<double>(cover->points[v].z()) -
                                                  roof(cover->points[v].head<2>().cast<double>()).z()));
    }
    EXPECT_LT(height[true], 0.05) << "two planes";
    EXPECT_GT(height[false], 0.3);
}

TEST(CoverRefiner, CarriesMapsOverLinearly)
{
    CoverBuilder builder;
    builder.grid({120, 100}, 7, 6, flat, 0.3);
    const SurfaceMeshPtr surface = builder.cover();
    const CoverMeshPtr cover = CoverRefiner().refine(surface, 2);
    std::vector<float> one(surface->positions.size(), 0);
    one[one.size() / 2] = 1;
    const std::vector<float> carried = cover->topology->carriedOver(one);
    ASSERT_EQ(carried.size(), cover->points.size());
    EXPECT_EQ(carried[one.size() / 2], 1);
    EXPECT_EQ(std::ranges::max(carried), 1);
    EXPECT_EQ(std::ranges::count(carried, 0.75F), 6) << "a quarter of the way along its edges";
    for (const CoverTopology::Parents& parents : cover->topology->parents)
        ASSERT_FLOAT_EQ(parents.share[0] + parents.share[1] + parents.share[2], 1);
}

TEST(CoverRefiner, DividesEachTriangleOfALargeCoverIntoSixteen)
{
    CoverBuilder builder;
    builder.grid({1000, 1000}, 104, 104, saddle, 0.2);
    const SurfaceMeshPtr surface = builder.cover();
    CoverRefiner refiner;
    refiner.prepare(surface->topology, 2);
    const CoverMeshPtr cover = refiner.refine(surface, 2);
    EXPECT_EQ(cover->topology->triangles.size(), 16 * surface->topology->triangles.size());
}

} // namespace
} // namespace bolster::test
