// What is drawn while something moves.
#include "FewerTriangles.h"

#include "DesignFile.h"
#include "PreparedSheet.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace bolster::test {
namespace {

std::shared_ptr<const SurfaceTopology> manyTriangles()
{
    const QString path = QString::fromStdString(samplesFolder() + "/box-cushion/box-cushion.json");
    const OpenedDesign opened = openDesign(path);
    TriangulationCache cache;
    return prepareSheet(withEdgeLength({opened.design, opened.files}, 2.5), cache)->mesh.topology;
}

double signedArea(const SurfaceTopology& topology, const std::array<std::uint32_t, 3>& corners)
{
    const auto& [a, b, c] = corners;
    const Vec2 u = topology.pattern[b] - topology.pattern[a], v = topology.pattern[c] - topology.pattern[a];
    return (u.x() * v.y() - u.y() * v.x()) / 2;
}

TEST(FewerTriangles, CoverTheSamePatchesUpToTheirOutlines)
{
    const auto topology = manyTriangles();
    constexpr std::size_t most = 30'000;
    ASSERT_GT(topology->triangles.size(), 4 * most);
    const FewerTriangles fewer = fewerTriangles(*topology, most);
    EXPECT_LT(fewer.triangles.size(), 1.5 * most);
    EXPECT_GT(fewer.triangles.size(), 0.5 * most);
    ASSERT_EQ(fewer.firstOf.size(), topology->patches.size() + 1);
    for (std::size_t p = 0; p < topology->patches.size(); ++p) {
        const SurfaceTopology::PatchRange& patch = topology->patches[p];
        double before = 0, after = 0, turnedOver = 0;
        for (std::uint32_t t = patch.firstTriangle; t < patch.firstTriangle + patch.triangleCount; ++t)
            before += signedArea(*topology, topology->triangles[t]);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::size_t t = fewer.firstOf[p]; t < fewer.firstOf[p + 1]; ++t) {
            const auto& corners = fewer.triangles[t];
            const double area = signedArea(*topology, corners);
            after += area;
            turnedOver += std::max(0.0, -area);
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[{corners[k], corners[(k + 1) % 3]}];
        }
        EXPECT_NEAR(after, before, 1e-6 * before);
        EXPECT_LT(turnedOver, 0.02 * before);
        for (std::uint32_t k = 0; k < patch.outlineCount; ++k) {
            const std::uint32_t a = patch.firstVertex + k, b = patch.firstVertex + (k + 1) % patch.outlineCount;
            EXPECT_EQ((edges[{a, b}]), 1) << "else there were gaps at the seams";
        }
    }
}

TEST(FewerTriangles, OfAFrameKeepItsShape)
{
    constexpr int around = 800, up = 400;
    constexpr float radius = 250;
    const auto at = [&](int i, int j) {
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / around;
        const float b = std::numbers::pi_v<float> * static_cast<float>(j) / up;
        const Eigen::Vector3f out(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
        return FrameSkin::Corner{radius * out, out, radius * out};
    };
    std::vector<FrameSkin::Corner> ball;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < up; ++j)
            for (const auto& [u, v] :
                 {std::pair(i, j), {i, j + 1}, {i + 1, j + 1}, {i, j}, {i + 1, j + 1}, {i + 1, j}})
                ball.push_back(at(u, v));
    constexpr std::size_t most = 50'000;
    const std::vector<FrameSkin::Corner> fewer = fewerCorners(ball, most);
    EXPECT_LT(fewer.size() / 3, 1.5 * most);
    EXPECT_GT(fewer.size() / 3, 0.5 * most);
    double area = 0;
    for (std::size_t i = 0; i < fewer.size(); i += 3) {
        const Eigen::Vector3f normal =
            (fewer[i + 1].position - fewer[i].position).cross(fewer[i + 2].position - fewer[i].position);
        area += normal.norm() / 2;
        for (std::size_t k = i; k < i + 3; ++k) {
            EXPECT_NEAR(fewer[k].position.norm(), radius, 1);
            EXPECT_GT(fewer[k].normal.dot(fewer[k].position) / radius, 0.99);
        }
    }
    EXPECT_NEAR(area / (4 * std::numbers::pi * radius * radius), 1, 0.05);
}

TEST(FewerTriangles, OfNothingAreNone)
{
    EXPECT_TRUE(fewerCorners({}, 100).empty());
    EXPECT_TRUE(fewerTriangles(SurfaceTopology(), 100).triangles.empty());
}

} // namespace
} // namespace bolster::test
