#include "CloudImport.h"
#include "FormImport.h"
#include "Lzf.h"
#include "TestFiles.h"

#include <algorithm>
#include <bit>
#include <cstdio>

namespace bolster {
namespace {

class CloudImportTest : public TestFiles {
protected:
    std::vector<Vec3> import(const QString& name, std::string_view bytes)
    {
        const ImportedCloud imported = importCloud(write(name, bytes));
        m_problem = imported.problem.english();
        EXPECT_EQ(imported.cloud == nullptr, !m_problem.empty());
        return imported.cloud ? imported.cloud->points : std::vector<Vec3>();
    }

    void expectRefused(const QString& name, std::string_view bytes, const std::string& why)
    {
        EXPECT_TRUE(import(name, bytes).empty()) << bytes;
        EXPECT_NE(m_problem.find(why), std::string::npos) << m_problem;
    }

    std::string m_problem;
};

const std::vector<Vec3> expected = {{1, 2, 3}, {-4, 0.5, 6}};

TEST_F(CloudImportTest, PointsWithoutAPlaceAreCounted)
{
    const ImportedCloud cloud = importCloud(write("a.xyz", "1 2 3\nnan nan nan\n-4 0.5 6\n1 inf 3\n"));
    EXPECT_EQ(cloud.warning.english(),
              "a.xyz: 2 points are left out: they have no place, as where a scanner saw nothing");
    EXPECT_EQ(importCloud(write("c.xyz", "nan nan nan\n")).problem.english(),
              "c.xyz: none of its 1 points has a place");
    EXPECT_TRUE(importCloud(write("b.xyz", "1 2 3\n-4 0.5 6\n")).warning.empty());
}

TEST_F(CloudImportTest, ADamagedMeshIsNoCloud)
{
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 nan\n";
    const ImportedForm damaged = importForm(write("damaged.obj", corners + "f 1 2 3\n"));
    EXPECT_FALSE(damaged.mesh || damaged.cloud);
    EXPECT_EQ(damaged.problem.english().find("damaged.obj:3"), 0u) << damaged.problem.english();
    const ImportedForm mesh = importForm(write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_TRUE(mesh.mesh && !mesh.cloud && mesh.problem.empty());
    for (const auto& [name, bytes] : {std::pair("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"),
                                      std::pair("points.xyz", "0 0 0\n1 0 0\n0 1 0\n")}) {
        const ImportedForm points = importForm(write(name, bytes));
        EXPECT_TRUE(points.cloud && !points.mesh) << points.problem.english();
    }
}

TEST_F(CloudImportTest, ReadsXyzWithCommentsColoursAndCounts)
{
    EXPECT_EQ(import("a.xyz", "# scanner\n1 2 3\n\n-4\t0.5 6e0 255 0 0 # red\n"), expected);
    EXPECT_EQ(import("a.XYZ", "2\r\n1 2 3\r\n-4 0.5 6\r\n"), expected);
    EXPECT_EQ(import("a.xyz", "1 2 3\nnan nan nan\n-4 0.5 6"), expected) << "what is not finite is left out";
    expectRefused("a.xyz", "1 2 3\n4 5\n", "a.xyz:2: a number is missing");
    expectRefused("a.xyz", "1 2 x\n", "a.xyz:1: \"x\" is not a number");
    expectRefused("a.xyz", "1 2 0,5\n", "a.xyz:1: \"0,5\" has a decimal comma; export with decimal points");
    expectRefused("a.xyz",
                  std::string_view("\xFF\xFE"
                                   "1\0 \0"
                                   "2\0",
                                   8),
                  "a.xyz is text in UTF-16");
    expectRefused("a.off", "", "a.off: the file does not begin with OFF");
    expectRefused("a.xyz", "# nothing\n", "no points");
    expectRefused("a.xyz", "1 2 3e8\n", "beyond 10,000,000");
    expectRefused("a.abc", "1 2 3\n", "PCD, OBJ, STL, OFF");
}

TEST_F(CloudImportTest, KeepsTheColoursOfPoints)
{
    using Colors = std::vector<std::uint32_t>;
    const auto colors = [this](const QString& name, std::string_view bytes) {
        const ImportedCloud imported = importCloud(write(name, bytes));
        return imported.cloud ? imported.cloud->colors : Colors();
    };
    const Colors both = {0xff8000, 0x0102ff};
    EXPECT_EQ(colors("a.xyz", "1 2 3 255 128 0\n4 5 6 1 2 255\n"), both);
    EXPECT_EQ(colors("a.xyz", "1 2 3 -812 255 128 0\n4 5 6 90 1 2 255\n"), both) << "behind a brightness";
    EXPECT_EQ(colors("a.xyz", "1 2 3 0 0 1\n4 5 6 0 1 0\n"), Colors()) << "normals";
    EXPECT_EQ(colors("a.xyz", "1 2 3 255 128 0\n4 5 6\n"), Colors()) << "not all have one";
    const std::string header = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                               "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    EXPECT_EQ(colors("a.ply", "ply\nformat ascii 1.0\n" + header + "1 2 3 255 128 0\n4 5 6 1 2 255\n"), both);
    std::string bytes = "ply\nformat binary_little_endian 1.0\n" + header;
    for (const std::uint32_t color : both) {
        for (int axis = 0; axis < 3; ++axis)
            append(bytes, 1.0F);
        for (const int shift : {16, 8, 0})
            append(bytes, static_cast<std::uint8_t>(color >> shift));
    }
    EXPECT_EQ(colors("a.ply", bytes), both);
}

TEST_F(CloudImportTest, KeepsTheColoursOfPcd)
{
    const auto header = [](const std::string& data, const std::string& type) {
        return "FIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F " + type +
               "\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n" + "DATA " + data + "\n";
    };
    const std::vector<std::uint32_t> both = {0xff8000, 0x0102ff};
    const auto colors = [this](std::string_view bytes) {
        const ImportedCloud imported = importCloud(write("a.pcd", bytes));
        return imported.cloud ? imported.cloud->colors : std::vector<std::uint32_t>();
    };
    EXPECT_EQ(colors(header("ascii", "U") + "1 2 3 16744448\n4 5 6 66303\n"), both);
    char text[100];
    std::snprintf(text, sizeof text, "1 2 3 %.9g\n4 5 6 %.9g\n", static_cast<double>(std::bit_cast<float>(both[0])),
                  static_cast<double>(std::bit_cast<float>(both[1])));
    EXPECT_EQ(colors(header("ascii", "F") + text), both);
    std::string rows, columns(24, '\0');
    for (const std::uint32_t color : both) {
        for (int axis = 0; axis < 3; ++axis)
            append(rows, 1.0F);
        append(rows, color | 0xff000000U);
        append(columns, color);
    }
    EXPECT_EQ(colors(header("binary", "F") + rows), both);
    std::string bytes = header("binary_compressed", "U");
    append(bytes, static_cast<std::uint32_t>(33));
    append(bytes, static_cast<std::uint32_t>(32));
    EXPECT_EQ(colors(bytes + '\x1f' + columns), both);
}

TEST_F(CloudImportTest, ReadsEveryFormOfPlyWithAndWithoutFaces)
{
    const std::string properties = "element vertex 2\nproperty float x\nproperty uchar red\nproperty float y\n"
                                   "property double z\n";
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    EXPECT_EQ(import("a.ply", "ply\nformat ascii 1.0\n" + properties + "end_header\n1 9 2 3\n-4 9 0.5 6\n"),
              expected);
    EXPECT_EQ(import("a.ply",
                     "ply\nformat ascii 1.0\n" + properties + faces + "end_header\n1 9 2 3\n-4 9 0.5 6\n3 0 1 0\n"),
              expected);
    for (const bool big : {false, true}) {
        std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" +
                            properties + "end_header\n";
        for (const Vec3& point : expected) {
            append(bytes, static_cast<float>(point.x()), big);
            append(bytes, std::uint8_t{9}, big);
            append(bytes, static_cast<float>(point.y()), big);
            append(bytes, point.z(), big);
        }
        EXPECT_EQ(import("a.ply", bytes), expected);
        expectRefused("a.ply", bytes.substr(0, bytes.size() - 1), "promises more than it holds");
    }
    expectRefused("a.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int n\nend_header\n",
                  "no points");
    expectRefused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
                  "no coordinate \"y\"");
}

std::string pcdHeader(const std::string& data)
{
    return "# .PCD v0.7\nVERSION 0.7\nFIELDS x rgb y z\nSIZE 4 4 4 8\nTYPE F U F F\nCOUNT 1 1 1 1\nWIDTH 2\n"
           "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " +
           data + "\n";
}

TEST_F(CloudImportTest, ReadsPcdAsTextAndBinary)
{
    EXPECT_EQ(import("a.pcd", pcdHeader("ascii") + "1 7 2 3\nnan 7 nan nan\n-4 7 0.5 6\n"), expected);
    std::string bytes = pcdHeader("binary");
    for (const Vec3& point : expected) {
        append(bytes, static_cast<float>(point.x()));
        append(bytes, std::uint32_t{7});
        append(bytes, static_cast<float>(point.y()));
        append(bytes, point.z());
    }
    EXPECT_EQ(import("a.pcd", bytes), expected);
    expectRefused("a.pcd", bytes.substr(0, bytes.size() - 1), "promises more than it holds");
    expectRefused("a.pcd", pcdHeader("zip"), "\"zip\" is not a PCD format");
    expectRefused("a.pcd", "FIELDS x y\nSIZE 4 4\nTYPE F F\nCOUNT 1 1\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2\n",
                  "no coordinate \"z\"");
    expectRefused("a.pcd", "FIELDS x y z\nSIZE 4 4 3\n", "\"3\" is not expected");
    expectRefused("a.pcd", "FIELDS x y z\n", "ends too early");
}

/// Literal runs only: what any packer may write.
std::string packed(const std::string& bytes)
{
    std::string result;
    for (std::size_t at = 0; at < bytes.size(); at += 32) {
        const std::string run = bytes.substr(at, 32);
        result += static_cast<char>(run.size() - 1);
        result += run;
    }
    return result;
}

TEST_F(CloudImportTest, ReadsCompressedPcdColumnByColumn)
{
    std::string columns;
    for (const Vec3& point : expected)
        append(columns, static_cast<float>(point.x()));
    for (int i = 0; i < 2; ++i)
        append(columns, std::uint32_t{7});
    for (const Vec3& point : expected)
        append(columns, static_cast<float>(point.y()));
    for (const Vec3& point : expected)
        append(columns, point.z());
    const std::string data = packed(columns);
    std::string bytes = pcdHeader("binary_compressed");
    append(bytes, static_cast<std::uint32_t>(data.size()));
    append(bytes, static_cast<std::uint32_t>(columns.size()));
    EXPECT_EQ(import("a.pcd", bytes + data), expected);
    expectRefused("a.pcd", bytes + data.substr(1), "promises more than it holds");
    std::string damaged = bytes + data;
    damaged[bytes.size()] = '\xff';
    expectRefused("a.pcd", damaged, "damaged");
}

/// Nothing when the bytes do not unpack to exactly `size` bytes.
std::optional<std::string> unpackLzf(const std::string& packed, std::uint64_t size)
{
    if (!lzfMayHold(packed.size(), size))
        return std::nullopt;
    try {
        LzfReader reader(packed, 0, packed.size());
        std::string bytes;
        while (bytes.size() < size)
            bytes += reader.read<char>();
        reader.requireEnd();
        return bytes;
    } catch (const FileRefused&) {
        return std::nullopt;
    }
}

TEST(Lzf, CopiesFromWhatWasThereBefore)
{
    // "ab", then 5 bytes from 2 back, then 9 + 1 from 1 back.
    const std::string bytes("\x01"
                            "ab"
                            "\x60\x01"
                            "\xe0\x01\x00",
                            8);
    EXPECT_EQ(unpackLzf(bytes, 17), "abababa" + std::string(10, 'a'));
    EXPECT_FALSE(unpackLzf(bytes, 16));
    EXPECT_FALSE(unpackLzf(bytes, 18));
    EXPECT_FALSE(unpackLzf(std::string("\x20\x00", 2), 3)) << "nothing is there to copy";
    EXPECT_FALSE(unpackLzf(bytes, 1'000'000'000));
    EXPECT_EQ(unpackLzf("", 0), "");
}

} // namespace
} // namespace bolster
