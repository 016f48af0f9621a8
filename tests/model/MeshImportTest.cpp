#include "MeshImport.h"
#include "PolygonSplit.h"
#include "TestFiles.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace bolster {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class MeshImportTest : public TestFiles {
protected:
    /// Writes and reads a file; null with m_problem when refused.
    std::shared_ptr<const TriangleMesh> import(const QString& name, std::string_view bytes)
    {
        const ImportedMesh imported = importMesh(write(name, bytes));
        m_problem = imported.problem.english();
        EXPECT_EQ(imported.mesh == nullptr, !m_problem.empty());
        return imported.mesh;
    }

    void expectRefused(const QString& name, std::string_view bytes, const std::string& why)
    {
        EXPECT_EQ(import(name, bytes), nullptr) << bytes;
        EXPECT_NE(m_problem.find(why), std::string::npos) << m_problem;
    }

    std::string m_problem;
};

double area(const TriangleMesh& mesh)
{
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm() / 2;
    return sum;
}

/// Which faces hide each other must be seen by their triangles.
TEST_F(MeshImportTest, TheTwoSidesOfAFaceBecomeTheSameTriangles)
{
    const std::string points = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 3 0\nv 0 1 0\n";
    for (const char* second : {"f 5 4 3 2 1\n", "f 2 1 5 4 3\n", "f 3 4 5 1 2\n", "f -1 -2 -3 -4 -5\n",
                               "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 3 0\nv 0 1 -0\nf 8 7 6 10 9\n"}) {
        const auto mesh = import("double.obj", points + "f 1 2 3 4 5\n" + second);
        ASSERT_TRUE(mesh) << m_problem;
        ASSERT_EQ(mesh->triangles.size(), 6u);
        const auto places = [&](std::size_t t) {
            std::vector<std::pair<double, double>> corners;
            for (const std::uint32_t corner : mesh->triangles[t])
                corners.emplace_back(mesh->points[corner].x(), mesh->points[corner].y());
            std::ranges::sort(corners);
            return corners;
        };
        const auto normal = [&](std::size_t t) {
            const auto& [a, b, c] = mesh->triangles[t];
            return (mesh->points[b] - mesh->points[a]).cross(mesh->points[c] - mesh->points[a]).z();
        };
        const bool sameSide = std::string_view(second).starts_with("f 3 4 5");
        for (std::size_t t = 0; t < 3; ++t) {
            EXPECT_EQ(places(t), places(t + 3)) << second;
            EXPECT_EQ(normal(t), (sameSide ? 1 : -1) * normal(t + 3)) << "each side keeps its own";
        }
    }
}

TEST_F(MeshImportTest, ReadsObjWithGroupsPolygonsAndEveryKindOfCorner)
{
    const auto mesh = import("a.obj", "# comment\r\n"
                                      "o Left arm \r\n"
                                      "v 0 0 0\r\nv +1 0 0 1.0\r\nv 1 1 0 # corner\r\nv 0 1e0 0\r\n"
                                      "vt 0 0\r\nvn 0 0 1\r\n"
                                      "f 1/1/1 2/1/1 \\\r\n 3/1/1 4/1/1\r\n"
                                      "usemtl x\r\ns off\r\n"
                                      "g Back\r\n"
                                      "v 5 5 5\r\n"
                                      "f -5//1 -4//1 -1\r\n"
                                      "g Left arm\r\n"
                                      "f 1 3 5");
    ASSERT_TRUE(mesh) << m_problem;
    EXPECT_EQ(mesh->points.size(), 5u);
    EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 2, 4}, {0, 1, 4}}));
    ASSERT_EQ(mesh->parts.size(), 2u);
    EXPECT_EQ(mesh->parts[0].name, "Left arm");
    EXPECT_EQ(mesh->parts[0].triangleCount, 3u);
    EXPECT_EQ(mesh->parts[1].name, "Back");
    EXPECT_EQ(mesh->parts[1].firstTriangle, 3u);
}

TEST_F(MeshImportTest, LeavesOutStrayPointsAndDegenerateFaces)
{
    const auto mesh = import("a.obj", "v 900 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\nf 2 2 3\nf 2 3\nf 2 3 4 2\n");
    ASSERT_TRUE(mesh) << m_problem;
    EXPECT_EQ(mesh->points.size(), 3u);
    EXPECT_EQ(mesh->triangles.size(), 2u);
    EXPECT_EQ(mesh->boundingBox().max().x(), 1);
}

TEST_F(MeshImportTest, ReadsNamesInOldEncodings)
{
    const auto mesh = import("a.obj", "g Fu\xdf\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->parts[0].name, "Fu\xc3\x9f");
}

TEST_F(MeshImportTest, SkipsAByteOrderMark)
{
    const ImportedMesh imported = importMesh(write("bom.obj", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    ASSERT_TRUE(imported.mesh);
    EXPECT_EQ(imported.mesh->points.size(), 3U);
}

TEST_F(MeshImportTest, RefusesBrokenObjWithTheLine)
{
    expectRefused("a.obj", "v 0 0\n", "a.obj:1: a number is missing");
    expectRefused("a.obj", "v 0 0 0\n\nv 0 x 0\n", "a.obj:3: \"x\" is not a number");
    expectRefused("a.obj", "v 0 0 0,5\n", "\"0,5\" has a decimal comma");
    expectRefused("a.obj", "v nan 0 0\n", "a.obj:1: the point is not finite");
    expectRefused("a.obj", "v 0 inf 0\n", "not finite");
    expectRefused("a.obj", "v 0 0 1e999\n", "a.obj:1");
    expectRefused("a.obj", "v 0 0 -10000001\n", "beyond 10,000,000");
    expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj:4: a face refers to point 4");
    expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "a.obj:4");
    expectRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "counted from 1");
    expectRefused("a.obj", "v 0 0 0\nf 1 2.5 1\n", "whole number");
    expectRefused("a.obj", "v 0 0 0\nf 1 99999999999999999999 1\n", "whole number");
    expectRefused("a.obj", "v 0 0 0\n", "points only");
    expectRefused("a.obj", "", "holds no mesh");
    expectRefused("a.xyz", "0 0 0", "is not a frame that can be read");
    EXPECT_NE(importMesh(path("none.obj")).problem.english().find("there is no file"), std::string::npos);
}

TEST_F(MeshImportTest, ReadsPlyInAllThreeForms)
{
    const std::string properties =
        "comment by hand\n"
        "element vertex 4\n"
        "property uchar red\nproperty double z\nproperty float x\nproperty float y\n"
        "element extra 1\nproperty list uchar short values\nproperty int id\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty float quality\n"
        "end_header\n";
    const auto expectSquare = [&](const QString& name, const std::string& bytes) {
        const auto mesh = import(name, bytes);
        ASSERT_TRUE(mesh) << m_problem;
        EXPECT_EQ(mesh->points, (std::vector<Vec3>{Vec3(0, 0, 7), Vec3(2, 0, 7), Vec3(2, 2, 7), Vec3(0, 2, 7)}));
        EXPECT_EQ(mesh->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    };
    expectSquare("text.ply", "ply\nformat ascii 1.0\n" + properties +
                                 "9 7 0 0\n9 7 2 0\n9 7 2 2\n9 7 0 2\n3 1 2 3 42\n4 0 1 2 3 0.5\n");
    for (const bool big : {false, true}) {
        std::string bytes =
            std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + properties;
        for (const auto& [x, y] : {std::pair{0.f, 0.f}, {2.f, 0.f}, {2.f, 2.f}, {0.f, 2.f}}) {
            append(bytes, std::uint8_t{9});
            append(bytes, 7.0, big);
            append(bytes, x, big);
            append(bytes, y, big);
        }
        append(bytes, std::uint8_t{2});
        append(bytes, std::int16_t{1}, big);
        append(bytes, std::int16_t{2}, big);
        append(bytes, std::int32_t{42}, big);
        append(bytes, std::uint8_t{4});
        for (const std::int32_t index : {0, 1, 2, 3})
            append(bytes, index, big);
        append(bytes, 0.5f, big);
        expectSquare(big ? "big.ply" : "little.ply", bytes);
        expectRefused("short.ply", bytes.substr(0, bytes.size() - 1), "the file promises more than it holds");
    }
}

TEST_F(MeshImportTest, RefusesBrokenPly)
{
    const std::string head = "ply\nformat binary_little_endian 1.0\n";
    const std::string vertex = "property float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    expectRefused("a.ply", head + "element vertex 3\n" + vertex + "end_header\n" + std::string(36, 0),
                  "points only");
    expectRefused("a.ply", head + "element vertex 4000000000\n" + vertex + face + std::string(36, 0),
                  "promises more than it holds");
    expectRefused("a.ply", head + "element vertex 9223372036854775807\n" + vertex + face, "promises more");
    expectRefused("a.ply", head + "element vertex -1\n" + vertex + face, "negative");
    expectRefused("a.ply", head + "element vertex 99999999999999999999\n" + vertex + face, "whole number");
    expectRefused("a.ply", head + "element vertex 1\nproperty float x\n" + face + std::string(36, 0),
                  "no coordinate \"y\"");
    expectRefused("a.ply", head + "element vertex 1\nproperty quad x\n" + face,
                  "\"quad\" is not a PLY number type");
    expectRefused("a.ply", "ply\nformat binary_pdp_endian 1.0\n" + face, "not a PLY format");
    expectRefused("a.ply", head + "element vertex 0\n" + vertex, "ends too early");
    expectRefused("a.ply", "plop", "does not begin with");
    std::string infinite = head + "element vertex 3\n" + vertex + face;
    for (int i = 0; i < 9; ++i)
        append(infinite, std::numeric_limits<float>::infinity());
    expectRefused("a.ply", infinite + std::string(13, 0), "(byte ");
    std::string outside = head + "element vertex 3\n" + vertex + face + std::string(36, 0);
    append(outside, std::uint8_t{3});
    for (const std::int32_t index : {0, 1, 3})
        append(outside, index);
    expectRefused("a.ply", outside, "a face refers to point 4, but there are 3 points");
}

std::string binaryStl(const std::vector<std::array<Vec3, 3>>& triangles, std::uint32_t promised)
{
    std::string bytes = "solid, in spite of its beginning, binary";
    bytes.resize(80);
    append(bytes, promised);
    for (const auto& triangle : triangles) {
        bytes.append(12, '\0');
        for (const Vec3& corner : triangle)
            for (const double coordinate : corner)
                append(bytes, static_cast<float>(coordinate));
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

TEST_F(MeshImportTest, ReadsStlAndWeldsItsCorners)
{
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(-0.0, 1, 0);
    const auto binary = import("a.STL", binaryStl({{a, b, c}, {Vec3(0, -0.0, 0), c, d}}, 2));
    ASSERT_TRUE(binary) << m_problem;
    EXPECT_EQ(binary->points.size(), 4u);
    EXPECT_EQ(binary->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));

    const auto text = import("b.stl", "solid seat\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n"
                                      "   vertex 1 0 0\n   vertex 1 1 0\n  endloop\n endfacet\n"
                                      " FACET NORMAL 0 0 1\n  OUTER LOOP\n   VERTEX 0 0 0\n   VERTEX 1 1 0\n"
                                      "   VERTEX 0 1 0\n  ENDLOOP\n ENDFACET\nendsolid seat\n");
    ASSERT_TRUE(text) << m_problem;
    EXPECT_EQ(text->points, binary->points);
    EXPECT_EQ(text->triangles, binary->triangles);
    EXPECT_EQ(text->parts[0].name, "seat");
}

TEST_F(MeshImportTest, RefusesBrokenStl)
{
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0);
    std::string other = binaryStl({{a, b, c}}, 4'000'000'000u);
    other.replace(0, 5, "SOLAR");
    expectRefused("a.stl", other, "promises more than it holds");
    expectRefused("a.stl", binaryStl({{a, b, Vec3(1e30, 0, 0)}}, 1), "a.stl (byte 120)");
    expectRefused("a.stl", binaryStl({}, 0), "holds no mesh");
    expectRefused("a.stl", "solid x\nfacet\nvertex 0 0 0\nvertex 1 0 0\n", "ends too early");
    expectRefused("a.stl", "", "holds no mesh");
}

TEST_F(MeshImportTest, ReadsOff)
{
    const auto mesh = import("a.off", "COFF # a square\n\n4 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0\n0 1 0\n"
                                      "4 0 1 2 3 0.5 0.5 0.5\n");
    ASSERT_TRUE(mesh) << m_problem;
    EXPECT_EQ(mesh->triangles.size(), 2u);
    EXPECT_DOUBLE_EQ(area(*mesh), 1);
    EXPECT_TRUE(import("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"));

    expectRefused("a.off", "4OFF\n1 1 0\n", "does not begin with OFF");
    expectRefused("a.off", "OFF BINARY\n", "binary OFF");
    expectRefused("a.off", "OFF\n-3 1 0\n", "negative");
    expectRefused("a.off", "OFF\n3000000000 1 0\n0 0 0\n", "promises more than it holds");
    expectRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6: a face refers to point 4");
    expectRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 3\n", "promises more than it holds");
    expectRefused("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "points only");
}

TEST(PolygonSplit, KeepsTheAreaOfConcavePolygons)
{
    // An L whose fan from the first corner would cover the notch.
    const std::vector<Vec3> corners = {{0, 2, 1}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}};
    for (std::size_t shift = 0; shift < corners.size(); ++shift) {
        TriangleMesh mesh;
        for (std::size_t i = 0; i < corners.size(); ++i)
            mesh.points.push_back(corners[(i + shift) % corners.size()]);
        std::int64_t effort = 1000;
        splitPolygon(mesh.points, mesh.triangles, effort);
        EXPECT_EQ(mesh.triangles.size(), 4u);
        EXPECT_NEAR(area(mesh), 3, 1e-12) << shift;
        for (const auto& [a, b, c] : mesh.triangles)
            EXPECT_GE((mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).z(), 0);
    }
}

TEST(PolygonSplit, SurvivesPolygonsThatAreNone)
{
    const std::vector<std::vector<Vec3>> polygons = {
        {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()},           // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                       // a line
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                       // crosses itself
        {{0, 0, 0}, {1, 0, 5}, {1, 1, -5}, {0, 1, 5}, {-1, 0.5, -5}},       // far from flat
        std::vector<Vec3>(1000, Vec3(1, 2, 3)),                             // many points in one
        {{1e7, 1e7, 1e7}, {-1e7, 1e7, 0}, {1e-300, 0, 0}, {0, 1e7, -1e7}}}; // extremes
    for (const auto& polygon : polygons) {
        for (std::int64_t allowed : {0, 10, 1'000'000}) {
            std::vector<Triangle> triangles;
            splitPolygon(polygon, triangles, allowed);
            EXPECT_EQ(triangles.size(), polygon.size() - 2);
        }
    }
}

TEST_F(MeshImportTest, PlyRowsThatHoldMoreThanTheHeaderSaysAreReadWithAWarning)
{
    const std::string head = "ply\nformat ascii 1.0\ncomment VCGLIB generated\nelement vertex 4\n"
                             "property float x\nproperty float y\nproperty float z\nelement face 2\n"
                             "property list uchar int vertex_indices\nend_header\n";
    const std::string faces = "3 0 1 2 255 0 0\n3 0 2 3 255 0 0\n";
    const ImportedMesh more =
        importMesh(write("more.ply", head + "0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n0 1 0 9 9 9\n" + faces));
    ASSERT_TRUE(more.mesh) << more.problem.english();
    EXPECT_EQ(more.mesh->points.size(), 4u);
    EXPECT_NEAR(area(*more.mesh), 1, 1e-12);
    EXPECT_NE(more.warning.english().find("more.ply: the rows hold more"), std::string::npos)
        << more.warning.english();

    const ImportedMesh exact =
        importMesh(write("exact.ply", head + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"));
    EXPECT_TRUE(exact.mesh);
    EXPECT_EQ(exact.warning.english(), "");
    const ImportedMesh together =
        importMesh(write("together.ply", head + "0 0 0 1 0 0\n1 1 0 0 1 0 3 0 1 2\n3 0 2 3"));
    ASSERT_TRUE(together.mesh) << "a file that is not written line by line: " << together.problem.english();
    EXPECT_NEAR(area(*together.mesh), 1, 1e-12);
    EXPECT_EQ(together.warning.english(), "");
}

} // namespace
} // namespace bolster
