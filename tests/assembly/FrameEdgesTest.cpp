// Edges of frames become fixation curves that lie on them.
#include "../model/TestFiles.h"

#include "AssemblyImport.h"
#include "CadFiles.h"
#include "FrameEdges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {
namespace {

class FrameEdgesTest : public TestFiles {};

constexpr double halfTurn = std::numbers::pi;

/// On a circle about the origin.
FrameEdge edgeArc(double radius, double from, double to, int pieces)
{
    FrameEdge edge;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from + (to - from) * i / pieces;
        edge.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    edge.exact = true;
    return edge;
}

FrameEdge edgeLine(const Vec3& from, const Vec3& to)
{
    return {{from, to}, {}, true};
}

void expectOn(const BSpline3& curve, const std::function<double(const Vec3&)>& off, double most)
{
    for (int i = 0; i <= 500; ++i)
        ASSERT_LE(off(curve.at(curve.domainStart() + curve.period() * i / 500)), most) << i;
}

TEST_F(FrameEdgesTest, CurvesRunWithinATwentiethOfAMillimetreOfStepEdges)
{
    test::writeStepChair(path("chair.step").toStdString());
    const ImportedEdges imported = importFrameEdges(path("chair.step"));
    EXPECT_TRUE(imported.problem.empty()) << imported.problem.english();
    int circles = 0, lines = 0;
    for (const FrameEdge& edge : distinctEdges(imported.edges)) {
        const std::optional<BSpline3> curve = curveOnEdge(edge);
        ASSERT_TRUE(curve);
        if (edge.part == "Seat") {
            ++lines;
            EXPECT_EQ(curve->degree(), 1);
            EXPECT_EQ(curve->pointCount(), 2);
        }
        if (edge.part != "Leg" || !edge.closed())
            continue;
        ++circles;
        EXPECT_TRUE(curve->closed());
        EXPECT_LE(curve->pointCount(), 40);
        const double height = edge.points.front().z();
        expectOn(
            *curve, [&](const Vec3& p) { return std::hypot(std::hypot(p.x() - 50, p.y()) - 20, p.z() - height); },
            0.05);
    }
    EXPECT_EQ(circles, 2);
    EXPECT_EQ(lines, 12);
}

TEST_F(FrameEdgesTest, WhatGoesOnSmoothlyIsOneCurve)
{
    // Three sides of a seat with two rounded corners of 60 mm, as faces have them: in any order and direction.
    std::vector<FrameEdge> edges = {edgeArc(60, 0, halfTurn / 2, 16), edgeLine({60, -500, 0}, {60, 0, 0}),
                                    edgeLine({-400, 60, 0}, {0, 60, 0}),
                                    edgeLine({60, 0, 0}, {60, 0, 40})}; // across
    std::ranges::reverse(edges[2].points);
    const std::vector<FrameEdge> joined = joinedSmoothly(edges);
    ASSERT_EQ(joined.size(), 2u);
    const auto row = std::ranges::max_element(joined, {}, [](const FrameEdge& edge) { return edge.points.size(); });
    EXPECT_EQ(row->points.size(), 19u);
    const std::optional<BSpline3> curve = curveOnEdge(*row);
    ASSERT_TRUE(curve);
    EXPECT_TRUE(curve->corners().empty());
    expectOn(
        *curve,
        [](const Vec3& p) {
            if (p.x() <= 0)
                return std::hypot(p.y() - 60, p.z());
            return p.y() <= 0 ? std::hypot(p.x() - 60, p.z()) : std::abs(p.norm() - 60);
        },
        0.05);
}

TEST_F(FrameEdgesTest, ARoundRowIsClosed)
{
    const std::vector<FrameEdge> joined =
        joinedSmoothly({edgeArc(100, 0, halfTurn, 40), edgeArc(100, 2 * halfTurn, halfTurn, 40)});
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_TRUE(joined[0].closed());
    const std::optional<BSpline3> curve = curveOnEdge(joined[0]);
    ASSERT_TRUE(curve && curve->closed());
    expectOn(
        *curve, [](const Vec3& p) { return std::abs(p.norm() - 100); }, 0.05);
}

TEST_F(FrameEdgesTest, WhereThereAreSeveralWaysARowEnds)
{
    std::vector<FrameEdge> edges = {edgeLine({0, 0, 0}, {100, 0, 0}), edgeLine({100, 0, 0}, {200, 0, 0}),
                                    edgeLine({100, 0, 0}, {200, 4, 0})};
    EXPECT_EQ(joinedSmoothly(edges).size(), 3u);
    edges.pop_back();
    EXPECT_EQ(joinedSmoothly(edges).size(), 1u);
    edges[1].part = "Another";
    EXPECT_EQ(joinedSmoothly(edges).size(), 2u);
}

TEST_F(FrameEdgesTest, EdgesOfTwoFacesAreOne)
{
    FrameEdge finer = edgeArc(50, 1, 0, 77);
    EXPECT_EQ(distinctEdges({edgeArc(50, 0, 1, 40), finer, edgeArc(50, 1, 2, 40)}).size(), 2u);
    EXPECT_EQ(distinctEdges({edgeLine({0, 0, 0}, {1, 0, 0}), edgeArc(0.5, 0, halfTurn, 9)}).size(), 2u);
}

/// A cylinder of 24 sides: its two rims, and none of the lines between its sides.
TEST_F(FrameEdgesTest, MeshesHaveEdgesWhereTheyBend)
{
    TriangleMesh mesh;
    constexpr std::uint32_t sides = 24;
    mesh.points = {{0, 0, 0}, {0, 0, 80}};
    for (std::uint32_t i = 0; i < sides; ++i)
        for (const double z : {0.0, 80.0})
            mesh.points.emplace_back(30 * std::cos(2 * halfTurn * i / sides),
                                     30 * std::sin(2 * halfTurn * i / sides), z);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % sides);
        mesh.triangles.insert(mesh.triangles.end(),
                              {{0, b, a}, {1, a + 1, b + 1}, {a, b, b + 1}, {a, b + 1, a + 1}});
    }
    mesh.parts = {{"Leg", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    const std::vector<FrameEdge> edges = bentEdges(mesh);
    ASSERT_EQ(edges.size(), 2u);
    for (const FrameEdge& edge : edges) {
        EXPECT_EQ(edge.points.size(), sides + 1);
        EXPECT_TRUE(edge.closed());
        EXPECT_EQ(edge.part, "Leg");
        EXPECT_FALSE(edge.exact);
        const std::optional<BSpline3> curve = curveOnEdge(edge);
        ASSERT_TRUE(curve && curve->closed());
        expectOn(
            *curve, [](const Vec3& p) { return std::abs(std::hypot(p.x(), p.y()) - 30); }, 0.5);
    }
    mesh.triangles.resize(8); // a wedge of it: borders are edges, too
    mesh.parts[0].triangleCount = 8;
    EXPECT_GT(bentEdges(mesh).size(), 2u);
    EXPECT_TRUE(bentEdges({}).empty());
}

TEST_F(FrameEdgesTest, WhatHasNoLengthIsNoCurve)
{
    EXPECT_FALSE(curveOnEdge(edgeLine({1, 2, 3}, {1, 2, 3})));
    EXPECT_FALSE(curveOnEdge({{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}, true}));
}

} // namespace
} // namespace bolster
