// Valleys and bulges run along seams by what the pattern measures, whatever the triangles are.
#include "SeamRelief.h"
#include "CoverBuilder.h"
#include "CoverRefiner.h"
#include "Design.h"
#include "Shading.h"

#include <gtest/gtest.h>

#include <random>

namespace bolster {
namespace {

using test::CoverBuilder;
using Side = CoverBuilder::Side;

/// A square of 80 mm whose left side and lower side are sewn to strips of 40 mm; the right and the upper one are
/// free.
SurfaceMeshPtr sewnSquare(int cells, Continuity continuity = Continuity::C0)
{
    CoverBuilder builder;
    const auto flat = [](double x, double y) {
        return [x, y](const Vec2& p) { return Vec3(p.x() + x, p.y() + y, 0); };
    };
    const std::size_t square = builder.grid({80, 80}, cells, cells, flat(0, 0), 0.2);
    const std::size_t left = builder.grid({40, 80}, cells, cells, flat(-40, 0));
    const std::size_t below = builder.grid({80, 40}, cells, cells, flat(0, -40));
    builder.sew(builder.side(square, Side::Left), builder.side(left, Side::Right), Continuity::C0);
    builder.sew(builder.side(square, Side::Bottom), builder.side(below, Side::Top), continuity);
    return builder.cover();
}

Design withTrims(const SeamTrim& left, const SeamTrim& below)
{
    Edit edit;
    for (const auto& [id, trim] : {std::pair(100, left), {101, below}}) {
        Seam seam;
        seam.trim = trim;
        edit.changes.push_back({ElementId{id}, nullptr, makeElement(seam)});
    }
    return Design().with(edit);
}

/// Places in the square's triangles, and what is interpolated there.
template <class Look>
void everywhere(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t count, const Look& look)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(0, 1);
    for (std::size_t t = 0; t < count; ++t)
        for (int k = 0; k < 4; ++k) {
            float u = share(random), v = share(random);
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            look(triangles[t], Eigen::Vector3f(1 - u - v, u, v));
        }
}

template <class T, class U>
auto mean(const std::vector<U>& values, const std::array<std::uint32_t, 3>& at, const Eigen::Vector3f& shares)
{
    return T(shares[0] * values[at[0]] + shares[1] * values[at[1]] + shares[2] * values[at[2]]);
}

TEST(SeamRelief, DistancesAreThoseInThePatternWhateverTheTriangles)
{
    for (const int cells : {2, 7}) { // of the coarse one a triangle in the corner has all vertices on seams
        const SurfaceMeshPtr surface = sewnSquare(cells);
        const SeamReliefPtr relief = seamRelief(Design(), *surface->topology);
        ASSERT_TRUE(relief->fits(surface->topology->serial, surface->topology->vertexCount()));
        everywhere(surface->topology->triangles, surface->topology->patches[0].triangleCount,
                   [&](const auto& triangle, const auto& shares) {
                       Vec2 p = Vec2::Zero();
                       for (int k = 0; k < 3; ++k)
                           p += shares[k] * surface->topology->pattern[triangle[static_cast<std::size_t>(k)]];
                       const double expected = std::min(p.x(), p.y());
                       const float found = mean<Eigen::Vector3f>(relief->distances, triangle, shares).minCoeff();
                       if (expected < 10) {
                           EXPECT_NEAR(found, expected, 1e-3) << p.transpose();
                       } else {
                           EXPECT_GT(found, 9.9);
                       }
                   });
    }
}

TEST(SeamRelief, TheRefinedCoverAgreesWithTheSolversMesh)
{
    const SurfaceMeshPtr surface = sewnSquare(5);
    const CoverMeshPtr cover = CoverRefiner().refine(surface, 2);
    const SeamReliefPtr fine = seamRelief(Design(), *cover->topology);
    const SeamReliefPtr coarse = seamRelief(Design(), *surface->topology);
    ASSERT_TRUE(fine->fits(surface->topology->serial, cover->topology->vertexCount()));
    for (std::uint32_t v = 0; v < surface->topology->vertexCount(); ++v)
        EXPECT_NEAR(fine->distances[v].minCoeff(), coarse->distances[v].minCoeff(), 0.2);
    everywhere(cover->topology->triangles, 16 * surface->topology->patches[0].triangleCount,
               [&](const auto& triangle, const auto& shares) {
                   const auto p = mean<Eigen::Vector2f>(cover->topology->pattern, triangle, shares);
                   if (p.minCoeff() < 8) {
                       EXPECT_NEAR(mean<Eigen::Vector3f>(fine->distances, triangle, shares).minCoeff(),
                                   p.minCoeff(), 0.02);
                   }
               });
}

TEST(SeamRelief, SeamsHaveTheAllowancesOfTheirTrims)
{
    SeamTrim wide, none;
    wide.allowance = 12;
    none.allowance = 0;
    none.valley = false;
    const SurfaceMeshPtr surface = sewnSquare(8, Continuity::G1);
    const SeamReliefPtr relief = seamRelief(withTrims(wide, none), *surface->topology);
    for (std::uint32_t v = 0; v < surface->topology->patches[0].vertexCount; ++v) {
        const Vec2& p = surface->topology->pattern[v];
        if (p.x() < 0.5 && p.y() > 10) {
            EXPECT_EQ(relief->shapes[v], Eigen::Vector2f(12, 1));
        }
        if (p.y() < 0.5 && p.x() > 10) {
            EXPECT_EQ(relief->shapes[v], Eigen::Vector2f(0, 0));
        }
        if (p.x() > 79.5 && p.y() > 40) {
            EXPECT_GT(relief->distances[v].minCoeff(), 12) << "a free border is no seam";
        }
    }
}

TEST(SeamProfile, LeansAsItRises)
{
    const Eigen::Vector3f sharp = Eigen::Vector3f::Zero();
    const auto at = [&](float a, float b) { return SeamProfile::at({a, b, 50}, {8, 1}, sharp); };
    for (const float a : {0.2F, 0.7F, 1.2F, 2.F, 5.F, 9.F})
        for (const float b : {30.F, 11.F, 6.F}) {
            constexpr float step = 1e-2F;
            const float rise = (at(a + step, b).height - at(a - step, b).height) / (2 * step);
            EXPECT_NEAR(at(a, b).slope[0], rise, 5e-3) << a << ' ' << b;
        }
    EXPECT_NEAR(at(0, 50).height, shading::bulgeHeight - shading::valleyDepth, 1e-5);
    EXPECT_EQ(at(0, 50).dark, 1);
    EXPECT_EQ(at(shading::valleyReach, 50).dark, 0);
    EXPECT_NEAR(at(8, 50).height, 0, 0.06) << "the allowance ends";
    EXPECT_EQ(at(20, 50).height, 0);
    EXPECT_LT(std::abs(at(shading::bulgeReach * 8 - 0.1F, 50).slope[0]), 1e-3) << "softly";
}

TEST(SeamProfile, WithoutAllowanceAndValleyThereIsNothing)
{
    const SeamProfile plain = SeamProfile::at({0.5F, 40, 40}, {0, 0}, Eigen::Vector3f::Zero());
    EXPECT_EQ(plain.height, 0);
    EXPECT_EQ(plain.dark, 0);
    EXPECT_TRUE(plain.slope.isZero());
    EXPECT_EQ(SeamProfile::at({4, 40, 40}, {0, 1}, Eigen::Vector3f::Zero()).height, 0) << "beside the valley";
}

TEST(SeamProfile, FarAwayTheLineGetsWiderAndFainter)
{
    const auto darkness = [](float pixel) { // across the seam
        float sum = 0;
        for (float d = 0; d < 40; d += 0.05F)
            sum += 0.05F * SeamProfile::at({d, 90, 90}, {8, 1}, Eigen::Vector3f::Constant(pixel)).dark;
        return sum;
    };
    EXPECT_NEAR(darkness(6), darkness(0), 0.1 * darkness(0));
    EXPECT_LT(SeamProfile::at({0, 90, 90}, {8, 1}, Eigen::Vector3f::Constant(6)).dark, 0.3);
}

} // namespace
} // namespace bolster
