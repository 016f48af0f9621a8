// LAS, PTS, PTX, and meshes that are taken for scans.
#include "CloudImport.h"
#include "Growth.h"
#include "LasWriter.h"
#include "TestFiles.h"

#include <cmath>

namespace bolster {
namespace {

using test::LasWriter;

class ScanReadersTest : public TestFiles {
protected:
    PointCloud import(const QString& name, std::string_view bytes)
    {
        const ImportedCloud imported = importCloud(write(name, bytes));
        m_problem = imported.problem.english();
        EXPECT_EQ(imported.cloud == nullptr, !m_problem.empty());
        return imported.cloud ? *imported.cloud : PointCloud();
    }

    void expectRefused(const QString& name, std::string_view bytes, const std::string& why)
    {
        EXPECT_TRUE(import(name, bytes).points.empty());
        EXPECT_NE(m_problem.find(why), std::string::npos) << m_problem;
    }

    std::string m_problem;
};

using Points = std::vector<Vec3>;
using Colors = std::vector<std::uint32_t>;

TEST_F(ScanReadersTest, LasOfEveryVersionAndFormat)
{
    for (const int minor : {0, 1, 2, 3, 4})
        for (int format = 0; format <= (minor == 4 ? 10 : 3); ++format)
            for (const int surplus : {0, 5}) {
                LasWriter las;
                las.minor = minor;
                las.format = format;
                las.surplus = surplus;
                las.points = {{100, 200, -300}, {-4000, 1000, 0}};
                const PointCloud cloud = import("a.las", las.file());
                ASSERT_EQ(cloud.points.size(), 2U) << minor << " " << format << " " << m_problem;
                EXPECT_TRUE(cloud.points[0].isApprox(Vec3(501, 2.2, 9.7), 1e-12)) << minor << " " << format;
                EXPECT_TRUE(cloud.points[1].isApprox(Vec3(460, 3, 10), 1e-12));
            }
}

TEST_F(ScanReadersTest, LasColoursHave16Bits8BitsOrAreNone)
{
    LasWriter las;
    las.points = {{1, 1, 1}, {2, 2, 2}};
    for (const int format : {2, 3, 5, 7, 8, 10}) {
        las.format = format;
        las.minor = 4;
        las.colors = {{{0xff00, 0x8012, 0}}, {{0x0100, 0x0200, 0xff00}}};
        EXPECT_EQ(import("a.las", las.file()).colors, (Colors{0xff8000, 0x0102ff})) << format;
        las.colors = {{{0xff, 0x80, 0}}, {{1, 2, 0xff}}};
        EXPECT_EQ(import("a.las", las.file()).colors, (Colors{0xff8000, 0x0102ff})) << format;
        las.colors = {{{0x12, 0x34, 0}}, {{0x0100, 0x0200, 0xff00}}};
        EXPECT_EQ(import("a.las", las.file()).colors, (Colors{0, 0x0102ff})) << "a dark one before a bright one";
        las.colors = {{{0, 0, 0}}, {{0, 0, 0}}};
        EXPECT_EQ(import("a.las", las.file()).colors, Colors());
    }
}

TEST_F(ScanReadersTest, LasLeavesOutNoiseAndWhatIsWithheld)
{
    for (const int format : {0, 6}) {
        LasWriter las;
        las.minor = 4;
        las.format = format;
        las.points = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
        las.classes = {2, 7, 1, 0};
        las.withheld = 2;
        const PointCloud cloud = import("a.las", las.file());
        ASSERT_EQ(cloud.points.size(), 2U);
        EXPECT_NEAR(cloud.points[1].x(), 500.04, 1e-9);
    }
}

TEST_F(ScanReadersTest, LasSaysWhatIsWrongAndLazWhatHelps)
{
    LasWriter las;
    las.points = {{1, 1, 1}};
    const std::string file = las.file();
    expectRefused("a.las", file.substr(0, file.size() - 1), "promises more than it holds");
    expectRefused("a.las", file.substr(0, 200), "is not a LAS file");
    expectRefused("a.las", "LASF", "is not a LAS file");
    las.format = 0x80 | 1;
    expectRefused("a.laz", las.file(), "save it as LAS, for example with laszip or CloudCompare, or as E57");
    las.format = 42;
    expectRefused("a.las", las.file(), "points of format 42");
    las.format = 0;
    las.scale.y() = 0;
    expectRefused("a.las", las.file(), "make no points");
    las.scale.y() = std::nan("");
    expectRefused("a.las", las.file(), "make no points");
    las.scale.y() = 1e300;
    expectRefused("a.las", las.file(), "beyond 10,000,000");
    las = {};
    las.points = {{1, 1, 1}};
    las.count = 2'000'000'000;
    expectRefused("a.las", las.file(), "promises more than it holds");
    las.count = 0;
    expectRefused("a.las", las.file(), "no points");
    las.count = {};
    las.dataOffset = 100;
    expectRefused("a.las", las.file(), "begin within the header");
    las.dataOffset = 0xfffffff0;
    expectRefused("a.las", las.file(), "promises more than it holds");
}

TEST_F(ScanReadersTest, PtsCountsItsPointsInEachOfItsScans)
{
    const PointCloud cloud = import("a.pts", "2\n1 2 3 -812 255 128 0\n4 5 6 90 1 2 255\n1\r\n7 8 9 0 0 0 9\n");
    EXPECT_EQ(cloud.points, (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
    EXPECT_EQ(cloud.colors, (Colors{0xff8000, 0x0102ff, 9}));
    EXPECT_EQ(import("a.pts", "1 2 3\n4 5 6\n").points.size(), 2U);
    expectRefused("a.pts", "3\n1 2 3\n4 5 6\n", "promises more than it holds");
    expectRefused("a.pts", "2\n1 2 3\n-1\n4 5 6\n", "a.pts:3: a count is negative");
    expectRefused("a.pts", "18446744073709551615\n1 2 3\n", "not a whole number");
    expectRefused("a.pts", "2\n1 2 x\n", "a.pts:2: \"x\" is not a number");
}

std::string ptxScan(const std::string& size, const std::string& matrix, const std::string& points)
{
    return size + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + matrix + points;
}

TEST_F(ScanReadersTest, PtxScansStandWhereTheirMatricesSay)
{
    const std::string turned = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n";
    const std::string straight = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    const PointCloud cloud =
        import("a.ptx",
               ptxScan("2\n2", turned, "1 2 3 0.5 255 128 0\n0 0 0 0.5 0 0 0\n4 5 6 0.5 1 2 255\n0 0 0 0 0 0 0\n") +
                   ptxScan("1\n1", straight, "7 8 9 0.5 9 9 9\n"));
    EXPECT_EQ(cloud.points, (Points{{8, 21, 33}, {5, 24, 36}, {7, 8, 9}}));
    EXPECT_EQ(cloud.colors, (Colors{0xff8000, 0x0102ff, 0x090909}));
    EXPECT_EQ(import("a.ptx", ptxScan("1\n2", straight, "1 2 3 0\n4 5 6 1\n")).colors, (Colors{0, 0xffffff}))
        << "brightness alone";
    expectRefused("a.ptx", ptxScan("2\n2", straight, "1 2 3 0.5\n1 2 3 0.5\n1 2 3 0.5\n"), "ends too early");
    expectRefused("a.ptx", ptxScan("2000000000\n2000000000", straight, "1 2 3 0.5\n"),
                  "promises more than it holds");
    expectRefused("a.ptx", ptxScan("-1\n2", straight, "1 2 3 0.5\n"), "a count is negative");
    expectRefused("a.ptx", ptxScan("1\n1", "1 0 0 0\n0 1 0 0\n1 1 0 0\n0 0 0 1\n", "1 2 3 0.5\n"), "no rotation");
    expectRefused("a.ptx", ptxScan("1\n1", "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "1 2 3 0.5\n"), "no rotation");
    expectRefused("a.ptx", ptxScan("1\n1", straight, "0 0 0 0.5\n"), "no points");
    expectRefused("a.ptx", "1\n1\n0 0 0\n", "promises more than it holds");
}

/// A box of 2 x 1 x 1 of twelve triangles.
const std::string objBox = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 0 1 1\n"
                           "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// How far a point of the box's surface may be from the nearest point of the scan.
double largestHole(const Points& points)
{
    double largest = 0;
    for (double u = 0.05; u < 1; u += 0.1)
        for (double v = 0.05; v < 1; v += 0.1)
            for (const Vec3& at : {Vec3(2 * u, v, 0), Vec3(2 * u, v, 1), Vec3(2 * u, 0, v), Vec3(2, u, v)}) {
                double nearest = 1e9;
                for (const Vec3& point : points)
                    nearest = std::min(nearest, (point - at).norm());
                largest = std::max(largest, nearest);
            }
    return largest;
}

TEST_F(ScanReadersTest, LargeTrianglesOfMeshesAreFilledWithPoints)
{
    const PointCloud box = import("a.obj", objBox);
    EXPECT_GT(box.points.size(), 100'000U);
    EXPECT_LT(largestHole(box.points), 0.02);
    for (const Vec3& point : box.points) {
        const Vec3 inside = point.cwiseMin(Vec3(2, 1, 1) - point);
        ASSERT_NEAR(inside.minCoeff(), 0, 1e-9) << "on the surface";
    }
    EXPECT_EQ(import("b.obj", objBox).points, box.points) << "the same every time";
    std::string stl = "solid a\n";
    for (const char* triangle : {"vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"})
        stl += std::string("facet normal 0 0 1\nouter loop\n") + triangle + "endloop\nendfacet\n";
    EXPECT_GT(import("a.stl", stl).points.size(), 1000U);
    EXPECT_GT(import("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").points.size(), 1000U);
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n1 0 0\n0 1 0\n3 0 1 ";
    EXPECT_GT(import("a.ply", ply + "2\n").points.size(), 1000U);
    EXPECT_EQ(import("a.ply", ply + "7\n").points.size(), 3U) << "the points are a scan without their faces";
}

TEST_F(ScanReadersTest, MeshesThatAreFineEnoughStayAsTheyAre)
{
    std::string grid;
    constexpr int side = 300;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            grid += "v " + std::to_string(i) + " " + std::to_string(k) + " 0\n";
    for (int i = 0; i + 1 < side; ++i)
        for (int k = 1; k < side; ++k) {
            const int at = i * side + k;
            grid +=
                "f " + std::to_string(at) + " " + std::to_string(at + 1) + " " + std::to_string(at + side) + "\n";
        }
    EXPECT_EQ(import("a.obj", grid).points.size(), std::size_t{side * side});
}

TEST_F(ScanReadersTest, ObjPointsMayHaveColoursAndNoFaces)
{
    EXPECT_EQ(import("a.obj", "v 1 2 3 1 0.5 0\nv 4 5 6 0 0 1\n").colors, (Colors{0xff8000, 0x0000ff}));
    EXPECT_EQ(import("a.obj", "v 1 2 3 255 128 0\nv 4 5 6 2 3 4\n").colors, (Colors{0xff8000, 0x020304}));
    EXPECT_EQ(import("a.obj", "v 1 2 3 1\nv 4 5 6 1\n").colors, Colors()) << "a weight";
    EXPECT_EQ(import("a.obj", "v 1 2 3\n").points, Points{Vec3(1, 2, 3)});
    expectRefused("a.obj", "f 1 2 3\n", "no points");
}

/// Slivers and overlapping sheets: no mesh may ask for points without end.
TEST_F(ScanReadersTest, NoMeshAsksForTooManyPoints)
{
    std::string sheets;
    for (int i = 0; i < 2000; ++i)
        sheets += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    const std::size_t count = import("a.obj", sheets).points.size();
    EXPECT_LE(count, 506'001U);
    EXPECT_GE(count, 400'000U);
    std::string sliver = "v 0 0 0\nv 10000000 0 0\nv 10000000 0.0001 0\nf 1 2 3\n";
    EXPECT_LT(import("a.obj", sliver).points.size(), 10U);
    EXPECT_EQ(import("a.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n").points.size(), 3U);
}

} // namespace
} // namespace bolster
