// Stitches and piping lie on the cover where the pattern has them.
#include "SeamTrims.h"
#include "CoverBuilder.h"
#include "CoverRefiner.h"

#include <gtest/gtest.h>

namespace bolster {
namespace {

constexpr ElementId leather{1}, blue{2}, piece{10}, border{20};
constexpr float tubeRadius = 150;

/// A piece of 300 x 200 mm whose lower edge has a trim.
Design trimmedPiece(const SeamTrim& trim)
{
    Patch patch;
    patch.fabric = leather;
    patch.outline = BSpline2(1, true, {{0, 0}, {300, 0}, {300, 200}, {0, 200}});
    Fabric other;
    other.color = "#2030a0";
    Edit edit;
    edit.changes = {{leather, nullptr, makeElement(Fabric())},
                    {blue, nullptr, makeElement(other)},
                    {piece, nullptr, makeElement(patch)},
                    {border, nullptr, makeElement(OutlineTrim{{piece, 0, 1}, trim})}};
    return Design().with(edit);
}

/// The piece bent round an axis along y.
CoverMeshPtr bentPiece()
{
    test::CoverBuilder builder;
    builder.grid({300, 200}, 15, 10, [](const Vec2& p) {
        const double angle = p.x() / tubeRadius;
        return Vec3(tubeRadius * std::sin(angle), p.y(), tubeRadius * std::cos(angle));
    });
    SurfaceMesh surface = *builder.cover();
    auto topology = std::make_shared<SurfaceTopology>(*surface.topology);
    topology->patches.front().patch = piece;
    surface.topology = topology;
    return CoverRefiner().refine(std::make_shared<const SurfaceMesh>(surface), 2);
}

float fromAxis(const Eigen::Vector3f& p)
{
    return std::hypot(p.x(), p.z());
}

TEST(SeamTrims, StitchesLieOnTheCoverInTheirRow)
{
    SeamTrim trim;
    trim.stitch = SeamTrim::Stitch::Twin;
    trim.stitchLength = 6;
    trim.stitchDistance = 5;
    const CoverMeshPtr cover = bentPiece();
    SeamTrims trims;
    const TrimMeshPtr mesh = trims.make(trimmedPiece(trim), *cover);
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->parts.size(), 2U) << "two rows";
    EXPECT_EQ(mesh->parts[0].color, trim.thread);
    for (std::size_t row = 0; row < 2; ++row) {
        const TrimMesh::Part& part = mesh->parts[row];
        float highest = 0, lowest = 1e9F;
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            for (const std::uint32_t v : mesh->triangles[t]) {
                EXPECT_NEAR(mesh->points[v].y(), 5.0 * (static_cast<double>(row) + 1),
                            0.5 * trim.threadWidth + 0.05);
                highest = std::max(highest, fromAxis(mesh->points[v]) - tubeRadius);
                lowest = std::min(lowest, fromAxis(mesh->points[v]) - tubeRadius);
            }
        EXPECT_GT(highest, 0.6 * trim.threadWidth) << "the thread lies on top";
        EXPECT_LT(highest, 1.2 * trim.threadWidth);
        EXPECT_LT(lowest, 0) << "its ends go through the cover";
    }
}

TEST(SeamTrims, APlaceFarOutsideIsFoundWithoutASearch)
{
    const CoverMeshPtr cover = bentPiece();
    RefinedPlaces places(cover->topology);
    const ElementId patch = cover->surface->topology->patches.front().patch;
    const PatternPlace near = places.locate(patch, {-1, 50}), far = places.locate(patch, {-1e9, 50});
    EXPECT_EQ(near.corners, far.corners);
    EXPECT_TRUE(near.weights.isApprox(far.weights, 1e-9));
}

TEST(SeamTrims, TrianglesFaceOutwards)
{
    SeamTrim trim;
    trim.stitch = SeamTrim::Stitch::Single;
    trim.pipingRadius = 4;
    const TrimMeshPtr mesh = SeamTrims().make(trimmedPiece(trim), *bentPiece());
    ASSERT_TRUE(mesh);
    std::size_t wrong = 0;
    for (const auto& [a, b, c] : mesh->triangles) {
        const Eigen::Vector3f normal = (mesh->points[b] - mesh->points[a]).cross(mesh->points[c] - mesh->points[a]);
        wrong += normal.norm() > 1e-4F && normal.dot(mesh->normals[a] + mesh->normals[b] + mesh->normals[c]) < 0;
    }
    EXPECT_EQ(wrong, 0U);
}

TEST(SeamTrims, PipingHasItsRadiusAndItsFabric)
{
    SeamTrim trim;
    trim.pipingRadius = 4;
    trim.pipingFabric = blue;
    const TrimMeshPtr mesh = SeamTrims().make(trimmedPiece(trim), *bentPiece());
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->parts.size(), 1U);
    EXPECT_EQ(mesh->parts[0].fabric, blue);
    EXPECT_EQ(mesh->parts[0].color, "#2030a0");
    float highest = 0, lowest = 1e9F;
    for (const Eigen::Vector3f& p : mesh->points) {
        EXPECT_LE(std::abs(p.y()), 4.2F);
        highest = std::max(highest, fromAxis(p));
        lowest = std::min(lowest, fromAxis(p));
    }
    EXPECT_NEAR(highest - lowest, 8, 0.5) << "twice the radius";
    EXPECT_GT(lowest, tubeRadius - 4);
}

TEST(SeamTrims, FollowTheCoverAndTheDesign)
{
    SeamTrim trim;
    EXPECT_FALSE(SeamTrims().make(trimmedPiece(trim), *bentPiece())) << "a plain seam has none";
    trim.stitch = SeamTrim::Stitch::Single;
    const CoverMeshPtr cover = bentPiece();
    SeamTrims trims;
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_FALSE(trims.make(trimmedPiece(trim), *cover, stopped.get_token())) << "and what it began is not kept";
    const TrimMeshPtr first = trims.make(trimmedPiece(trim), *cover);
    ASSERT_TRUE(first);
    CoverMesh moved = *cover;
    for (Eigen::Vector3f& p : moved.points)
        p += Eigen::Vector3f(0, 0, 100);
    const TrimMeshPtr second = trims.make(trimmedPiece(trim), moved);
    ASSERT_EQ(first->points.size(), second->points.size());
    EXPECT_LT((second->points[7] - first->points[7] - Eigen::Vector3f(0, 0, 100)).norm(), 1e-3F);
    trim.stitchLength = 12;
    EXPECT_LT(trims.make(trimmedPiece(trim), *cover)->points.size(), first->points.size());
}

} // namespace
} // namespace bolster
