// Damaged files must be read or refused, whatever the damage; run with sanitizers this shows bad accesses too.
#include "CloudReaders.h"
#include "E57Writer.h"
#include "LasWriter.h"
#include "MeshReaders.h"
#include "ReaderFuzz.h"
#include "TestFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

namespace bolster {
namespace {

const std::string objSeed = "o A\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3 4\n"
                            "g B\nf -4 -3 \\\n -2\nf 1 2 3 4 1 2 3\n";
const std::string offSeed = "COFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3 0.5\n";
const std::string textPlySeed =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty list uchar int n\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0 1 5\n1 0 0 0\n0 1 0 2 1 1\n"
    "3 0 1 2\n";
const std::string textStlSeed =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid a\n";

std::string binaryPlySeed(const std::string& order)
{
    std::string bytes = "ply\nformat binary_" + order +
                        "_endian 1.0\nelement vertex 3\nproperty double x\n"
                        "property float y\nproperty short z\nelement face 2\n"
                        "property list ushort uint vertex_index\nproperty uchar flag\nend_header\n";
    for (const int i : {0, 1, 2}) {
        append(bytes, static_cast<double>(i));
        append(bytes, static_cast<float>(i % 2));
        append(bytes, static_cast<std::int16_t>(i));
    }
    for (int face = 0; face < 2; ++face) {
        append(bytes, std::uint16_t{3});
        for (const std::uint32_t index : {0u, 1u, 2u})
            append(bytes, index);
        append(bytes, std::uint8_t{1});
    }
    return bytes;
}

std::string binaryStlSeed()
{
    std::string bytes(80, 'x');
    append(bytes, std::uint32_t{2});
    for (int i = 0; i < 2; ++i) {
        for (const float number : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
            append(bytes, number);
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string mutated(std::string bytes, std::mt19937& random)
{
    static const std::vector<std::string> words = {
        "-1", "0",    "4294967295", "1e308", "nan",   "\n", " ",         "99999999999999999999", "/", "\\\n",
        "#",  "list", "vertex",     "face",  "solid", "-0", "2147483648"};
    for (int i = static_cast<int>(random() % 4); i >= 0; --i) {
        const std::size_t at = bytes.empty() ? 0 : random() % bytes.size();
        switch (random() % 6) {
        case 0:
            if (!bytes.empty())
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            break;
        case 1:
            if (!bytes.empty())
                bytes[at] = static_cast<char>(random());
            break;
        case 2:
            bytes.erase(at, random() % 8);
            break;
        case 3:
            bytes.insert(at, words[random() % words.size()]);
            break;
        case 4:
            bytes.resize(at);
            break;
        case 5:
            bytes.insert(at, bytes.substr(at, random() % 32));
            break;
        }
    }
    return bytes;
}

std::string pcdSeed(const std::string& data)
{
    std::string bytes = "VERSION 0.7\nFIELDS x y z n\nSIZE 4 8 2 1\nTYPE F F I U\nCOUNT 1 1 1 2\nWIDTH 3\n"
                        "HEIGHT 1\nPOINTS 3\nDATA " +
                        data + "\n";
    if (data == "ascii")
        return bytes + "0 0 0 1 2\n1 nan 0 1 2\n0 1 0 1 2 # last\n";
    if (data == "binary_compressed") {
        append(bytes, std::uint32_t{5});
        append(bytes, std::uint32_t{48});
        bytes.append("\x00\x00\xe0\x26\x00", 5);
        return bytes;
    }
    for (int i = 0; i < 3; ++i) {
        append(bytes, static_cast<float>(i));
        append(bytes, static_cast<double>(i % 2));
        append(bytes, static_cast<std::int16_t>(i));
        append(bytes, std::uint16_t{7});
    }
    return bytes;
}

std::string asItIs(std::string bytes)
{
    return bytes;
}

/// `packed`: what is done with the bytes after they were damaged.
template <class Content>
void fuzz(Content (*reader)(const FileBytes&), const std::string& seed, std::string (*packed)(std::string) = asItIs)
{
    EXPECT_TRUE(test::fuzzReader(reader, packed(seed)));
    std::mt19937 random(1);
    int accepted = 0;
    for (int i = 0; i < 10000; ++i)
        accepted += test::fuzzReader(reader, packed(mutated(seed, random)));
    EXPECT_GT(accepted, 100); // or the mutations would say nothing about what is behind the first check
    EXPECT_LT(accepted, 9900);
}

TEST(MeshFuzz, Obj)
{
    fuzz(readObj, objSeed);
}

TEST(MeshFuzz, Off)
{
    fuzz(readOff, offSeed);
}

TEST(MeshFuzz, Ply)
{
    fuzz(readPly, textPlySeed);
    fuzz(readPly, binaryPlySeed("little"));
}

TEST(MeshFuzz, Stl)
{
    fuzz(readStl, textStlSeed);
    fuzz(readStl, binaryStlSeed());
}

TEST(CloudFuzz, Ply)
{
    fuzz(readPlyCloud, textPlySeed);
    fuzz(readPlyCloud, binaryPlySeed("big"));
}

TEST(CloudFuzz, Xyz)
{
    fuzz(readXyz, "3\n0 0 0\n1 0 0 # second\n0 nan 0 255 0 0\n0 1 0\n");
}

TEST(CloudFuzz, Pcd)
{
    for (const char* data : {"ascii", "binary", "binary_compressed"})
        fuzz(readPcd, pcdSeed(data));
}

TEST(CloudFuzz, E57)
{
    test::E57Writer writer;
    writer.addScan(
        {test::e57Integers("cartesianX", 0, 1000, {0, 7, 1000}), test::e57Doubles("cartesianY", {1, 2, 3}),
         test::e57Integers("cartesianZ", -5, 99, {-5, 0, 99}, "scale=\"0.001\" offset=\"1\""),
         test::e57Integers("colorRed", 0, 255, {0, 1, 2}), test::e57Integers("colorGreen", 0, 255, {0, 1, 2}),
         test::e57Integers("colorBlue", 0, 255, {0, 1, 2})},
        3, "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">1</w></rotation></pose>");
    writer.addScan({test::e57Singles("sphericalRange", {1, 2}), test::e57Singles("sphericalAzimuth", {1, 2}),
                    test::e57Singles("sphericalElevation", {1, 2}), test::e57Integers("intensity", 0, 1, {0, 1}),
                    test::e57Integers("sphericalInvalidState", 0, 2, {0, 0})});
    fuzz(readE57, writer.content(),
         test::e57Pages); // with checksums that are right: else nothing else is looked at
    EXPECT_TRUE(test::fuzzReader(readE57, writer.file()));
}

TEST(CloudFuzz, Las)
{
    test::LasWriter las;
    las.points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    for (const int format : {0, 3, 7}) {
        las.format = format;
        las.minor = format == 7 ? 4 : 2;
        fuzz(readLas, las.file());
    }
}

TEST(CloudFuzz, PtsAndPtx)
{
    fuzz(readPts, "2\n0 0 0 -12 1 2 3\n1 0 0 5 1 2 3\n1\n0 1 nan 0 1 2 3\n");
    fuzz(readPtx, "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n1 2 3 1\n0 0 0 0.5 1 2 3\n"
                  "1 2 3 0.5 1 2 3\n1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"
                  "4 5 6 0.25 7 8 9\n");
}

TEST(CloudFuzz, MeshesAsScans)
{
    const auto fewer = [](PointCloud (*reader)(const FileBytes&), const std::string& seed) {
        EXPECT_TRUE(test::fuzzReader(reader, seed));
        std::mt19937 random(1);
        for (int i = 0; i < 200; ++i) // each is filled with points
            test::fuzzReader(reader, mutated(seed, random));
    };
    fewer(readObjScan, objSeed);
    fewer(readOffScan, offSeed);
    fewer(readStlScan, textStlSeed);
    fewer(readPlyScan, textPlySeed);
}

} // namespace
} // namespace bolster
