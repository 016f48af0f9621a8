#include "SurfaceEdges.h"
#include "CoverSetup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace bolster::test {
namespace {

SurfaceEdge sorted(std::uint32_t a, std::uint32_t b)
{
    return a < b ? SurfaceEdge{a, b} : SurfaceEdge{b, a};
}

TEST(SurfaceEdges, HaveEachEdgeOnce)
{
    const SurfaceMeshPtr mesh = twoSquaresCover();
    const SurfaceTopology& topology = *mesh->topology;
    for (const SurfaceTopology::PatchRange& patch : topology.patches) {
        std::set<SurfaceEdge> expected;
        for (std::uint32_t t = patch.firstTriangle; t < patch.firstTriangle + patch.triangleCount; ++t)
            for (std::size_t i = 0; i < 3; ++i)
                expected.insert(sorted(topology.triangles[t][i], topology.triangles[t][(i + 1) % 3]));
        std::set<SurfaceEdge> found;
        for (const auto& [a, b] : edgesOf(topology, patch))
            EXPECT_TRUE(found.insert(sorted(a, b)).second) << a << " " << b;
        EXPECT_EQ(found, expected);
    }
}

TEST(SurfaceEdges, OutlinesGoRound)
{
    const SurfaceMeshPtr mesh = twoSquaresCover();
    const SurfaceRun outline = outlineOf(mesh->topology->patches.back());
    ASSERT_EQ(outline.size(), 33U);
    EXPECT_EQ(outline.front(), outline.back());
    double length = 0;
    for (std::size_t i = 1; i < outline.size(); ++i)
        length += (mesh->positions[outline[i]] - mesh->positions[outline[i - 1]]).norm();
    EXPECT_NEAR(length, 800, 1e-9);
}

TEST(SurfaceEdges, LeaveOutWhatIsSewn)
{
    const SurfaceMeshPtr mesh = twoSquaresCover();
    const std::vector<SurfaceRun> runs = unsewnOutlines(*mesh->topology);
    ASSERT_EQ(runs.size(), 2U); // three sides of each square, the right one's passing its first vertex
    for (const SurfaceRun& run : runs) {
        ASSERT_EQ(run.size(), 25U);
        EXPECT_DOUBLE_EQ(mesh->positions[run.front()].x(), 200);
        EXPECT_DOUBLE_EQ(mesh->positions[run.back()].x(), 200);
    }
    SurfaceTopology apart = *mesh->topology;
    apart.seams.clear();
    ASSERT_EQ(unsewnOutlines(apart).size(), 2U);
    EXPECT_EQ(unsewnOutlines(apart)[0], outlineOf(apart.patches[0]));
}

} // namespace
} // namespace bolster::test
