// Bodies for CAD, as OpenCASCADE reads them.
#include "StepBody.h"
#include "../../model/TestFiles.h"
#include "CoverSolid.h"
#include "MeshImport.h"
#include "Shells.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

/// A cube around `middle`, its faces outwards or inwards.
void addCube(TriangleMesh& mesh, const Vec3& middle, double half, bool outwards)
{
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const double z : {-half, half})
        for (const double y : {-half, half})
            for (const double x : {-half, half})
                mesh.points.push_back(middle + Vec3(x, y, z));
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : faces)
        for (std::array<std::uint32_t, 3> corners :
             {std::array<std::uint32_t, 3>{a, b, c}, std::array<std::uint32_t, 3>{a, c, d}}) {
            if (!outwards)
                std::swap(corners[1], corners[2]);
            mesh.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
        }
}

using StepBody = TestFiles;

TEST_F(StepBody, HasVoidsAndSeveralBodies)
{
    TriangleMesh solid;
    addCube(solid, Vec3::Zero(), 50, true);
    addCube(solid, Vec3(10, 0, 0), 20, false);
    addCube(solid, Vec3(200, 0, 0), 10, true);
    ASSERT_NEAR(enclosedVolume(solid), 1e6 - 64'000 + 8000, 1e-6);
    const ImportedMesh read = importMesh(write(QStringLiteral("body.step"), stepBody("two \u00e4 bodies", solid)));
    ASSERT_TRUE(read.mesh) << read.problem.english();
    EXPECT_NEAR(enclosedVolume(*read.mesh), enclosedVolume(solid), 1e-3);
    EXPECT_EQ(read.said.millimetresPerUnit, 1);
    EXPECT_EQ(read.mesh->triangles.size(), 36u);
    EXPECT_TRUE(read.mesh->boundingBox().isApprox(solid.boundingBox(), 1e-9));
}

TEST(Shells, CrumbsGo)
{
    TriangleMesh solid;
    addCube(solid, Vec3(500, 0, 0), 4, true);
    addCube(solid, Vec3::Zero(), 50, true);
    addCube(solid, Vec3(10, 0, 0), 4, false);
    addCube(solid, Vec3(-20, 0, 0), 6, false);
    solid.parts = {{"foam", 0, static_cast<std::uint32_t>(solid.triangles.size())}};
    EXPECT_EQ(shellsOf(solid).size(), 4u);
    EXPECT_EQ(dropSmallShells(solid, 1000), 1u) << "a void is no piece";
    EXPECT_NEAR(enclosedVolume(solid), 1e6 - 1728, 1e-6);
    EXPECT_EQ(solid.points.size(), 16u);
    EXPECT_EQ(solid.parts[0].triangleCount, 24u);
    EXPECT_EQ(dropSmallShells(solid, 1e7), 1u);
    EXPECT_TRUE(solid.triangles.empty() && solid.points.empty());
}

} // namespace
} // namespace bolster
