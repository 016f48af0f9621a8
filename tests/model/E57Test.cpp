#include "CloudImport.h"
#include "CloudReaders.h"
#include "E57Pages.h"
#include "E57Writer.h"
#include "Growth.h"
#include "TestFiles.h"

#include <numbers>

namespace bolster {
namespace {

using test::e57Doubles;
using test::e57Integers;
using test::e57Pages;
using test::e57Singles;
using test::E57TestColumn;
using test::E57Writer;

using Points = std::vector<Vec3>;
using Colors = std::vector<std::uint32_t>;
using Columns = std::vector<E57TestColumn>;

const Columns plain = {e57Doubles("cartesianX", {1, -4}), e57Doubles("cartesianY", {2, 0.5}),
                       e57Doubles("cartesianZ", {3, 6})};
const Points plainPoints = {{1, 2, 3}, {-4, 0.5, 6}};

Columns with(Columns columns, const Columns& more)
{
    columns.insert(columns.end(), more.begin(), more.end());
    return columns;
}

std::string fileOf(const Columns& columns, const std::string& more = {})
{
    E57Writer writer;
    writer.addScan(columns, columns.front().records.size(), more);
    return writer.file();
}

Points pointsOf(const std::string& file)
{
    return readE57(file).points;
}

std::string changed(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
}

/// Why it is not read.
std::string refusal(const std::string& file)
{
    try {
        readE57(file);
    } catch (const FileRefused& refused) {
        return refused.sentence;
    }
    return "read";
}

void expectRefused(const std::string& file, const std::string& why)
{
    const std::string found = refusal(file);
    EXPECT_NE(found.find(why), found.npos) << found;
}

TEST(E57, ChecksumsAreThoseOfTheStandard)
{
    EXPECT_EQ(crc32c("123456789"), 0xE3069283U);
    EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8A9136AAU); // RFC 3720, B.4
    EXPECT_EQ(crc32c(std::string(32, '\xff')), 0x62A8AB43U);
}

TEST(E57, ReadsEverySortOfNumber)
{
    EXPECT_EQ(pointsOf(fileOf(plain)), plainPoints);
    EXPECT_EQ(pointsOf(fileOf({e57Singles("cartesianX", {1, -4}),
                               e57Integers("cartesianY", 1000, 4999, {4000, 1000}, "scale=\"0.0005\""),
                               e57Integers("cartesianZ", -10, 10, {3, 6})})),
              plainPoints);
    EXPECT_EQ(pointsOf(fileOf({e57Integers("cartesianX", -9223372036854775807 - 1, 9223372036854775807, {1, -4}),
                               e57Integers("cartesianY", 0, 1, {1, 0}, "scale=\"1.5\" offset=\"0.5\""),
                               e57Integers("cartesianZ", 3, 6, {3, 6})})),
              plainPoints);
    EXPECT_EQ(pointsOf(fileOf({e57Doubles("cartesianX", {1, -4}), e57Integers("cartesianY", 2, 2, {2, 2}),
                               e57Doubles("cartesianZ", {3, 6})})),
              (Points{{1, 2, 3}, {-4, 2, 6}}))
        << "what is the same everywhere takes no room";
}

TEST(E57, RecordsGoOnInTheNextPacketAndOtherColumnsAreLeftOut)
{
    std::vector<std::int64_t> counts(1000), other(1000);
    std::vector<double> halves(1000);
    Points expected;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i] = static_cast<std::int64_t>(i * i % 2000) - 1000;
        halves[i] = 0.5 * static_cast<double>(i);
        other[i] = static_cast<std::int64_t>(i % 7);
        expected.emplace_back(static_cast<double>(counts[i]), halves[i], static_cast<double>(-counts[i]));
    }
    std::vector<std::int64_t> negative(counts);
    for (std::int64_t& number : negative)
        number = -number;
    for (const std::size_t bytes : {1U, 3U, 50U, 5000U}) {
        E57Writer writer;
        writer.bytesPerPacket = bytes;
        writer.addScan({e57Integers("rowIndex", 0, 6, other),
                        e57Integers("cartesianX", -1000, 1000, counts),
                        {"<nor:name type=\"String\"/>", 8, std::vector<std::uint64_t>(1000, 2)},
                        e57Singles("cartesianY", halves),
                        e57Integers("cartesianZ", -1000, 1000, negative)});
        EXPECT_EQ(pointsOf(writer.file()), expected) << bytes;
    }
}

TEST(E57, SphericalPointsStandWhereTheyAreSeen)
{
    constexpr double pi = std::numbers::pi;
    const Points points =
        pointsOf(fileOf({e57Doubles("sphericalRange", {2, 2, 4}), e57Doubles("sphericalAzimuth", {0, pi / 2, 0}),
                         e57Doubles("sphericalElevation", {0, 0, pi / 6})}));
    ASSERT_EQ(points.size(), 3U);
    EXPECT_TRUE(points[0].isApprox(Vec3(2, 0, 0)));
    EXPECT_TRUE(points[1].isApprox(Vec3(0, 2, 0)));
    EXPECT_TRUE(points[2].isApprox(Vec3(4 * std::cos(pi / 6), 0, 2)));
}

const std::string pose =
    "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">0.70710678118654757"
    "</w><x type=\"Float\"/><y type=\"Float\"/><z type=\"Float\">0.70710678118654757</z>"
    "</rotation><translation type=\"Structure\"><x type=\"Float\">10</x><y type=\"Float\">"
    "2e1</y><z type=\"Float\"> 30\n</z></translation></pose>";

TEST(E57, ScansStandWhereTheirPosesSay)
{
    E57Writer writer;
    writer.addScan(plain, 2, pose);
    writer.addScan({e57Integers("timeStamp", 0, 3, {1})}, 1); // no points
    writer.addScan(plain);
    writer.addScan({{"<cartesianX type=\"Float\"/>", 64, {}}}, 0);
    const Points points = pointsOf(writer.file());
    ASSERT_EQ(points.size(), 4U);
    EXPECT_TRUE(points[0].isApprox(Vec3(8, 21, 33)));
    EXPECT_TRUE(points[1].isApprox(Vec3(9.5, 16, 36)));
    EXPECT_EQ(points[2], plainPoints[0]);
    EXPECT_EQ(points[3], plainPoints[1]);
}

TEST(E57, LeavesOutWhatIsInvalidOrNoNumber)
{
    EXPECT_EQ(pointsOf(fileOf(with(plain, {e57Integers("cartesianInvalidState", 0, 2, {0, 2})}))),
              Points{plainPoints[0]});
    EXPECT_EQ(pointsOf(fileOf({e57Doubles("cartesianX", {std::nan(""), -4}), plain[1], plain[2]})),
              Points{plainPoints[1]});
    expectRefused(fileOf(with(plain, {e57Integers("cartesianInvalidState", 0, 2, {1, 1})})), "no points");
}

Columns colorsOf(std::int64_t most, const std::vector<std::int64_t>& red, const std::vector<std::int64_t>& green,
                 const std::vector<std::int64_t>& blue)
{
    return {e57Integers("colorRed", 0, most, red), e57Integers("colorGreen", 0, most, green),
            e57Integers("colorBlue", 0, most, blue)};
}

TEST(E57, KeepsColoursAndTakesBrightnessForGreyWhereThereAreNone)
{
    const Columns colors = colorsOf(255, {255, 1}, {128, 2}, {0, 255});
    EXPECT_EQ(readE57(fileOf(with(plain, colors))).colors, (Colors{0xff8000, 0x0102ff}));
    EXPECT_EQ(readE57(fileOf(with(plain, colorsOf(65535, {65535, 257}, {32896, 514}, {0, 65535})))).colors,
              (Colors{0xff8000, 0x0102ff}));
    const std::string limits =
        "<colorLimits type=\"Structure\"><colorRedMinimum type=\"Integer\">0</colorRedMinimum>"
        "<colorRedMaximum type=\"Integer\">510</colorRedMaximum></colorLimits>";
    EXPECT_EQ(readE57(fileOf(with(plain, colorsOf(1023, {510, 2}, {1023, 0}, {0, 1023})), limits)).colors,
              (Colors{0xffff00, 0x0100ff}));
    EXPECT_EQ(readE57(fileOf(with(plain, with(colors, {e57Integers("isColorInvalid", 0, 1, {0, 1})})))).colors,
              (Colors{0xff8000, 0x808080}));
    EXPECT_EQ(readE57(fileOf(with(plain, {e57Doubles("intensity", {0, 1})}))).colors, (Colors{0, 0xffffff}));
    EXPECT_EQ(readE57(fileOf(with(plain, {e57Integers("intensity", -100, 155, {-100, 28})}))).colors,
              (Colors{0, 0x808080}));
    E57Writer both;
    both.addScan(plain);
    both.addScan(with(plain, colors));
    EXPECT_EQ(readE57(both.file()).colors, (Colors{0x808080, 0x808080, 0xff8000, 0x0102ff}));
}

TEST(E57, WhatWasDamagedOnTheWayIsToldByItsChecksum)
{
    E57Writer writer;
    std::vector<double> many(2000, 1.5);
    writer.addScan(
        {e57Doubles("cartesianX", many), e57Doubles("cartesianY", many), e57Doubles("cartesianZ", many)});
    const std::string file = writer.file();
    ASSERT_GT(file.size(), 40'000U);
    for (const std::size_t at : {std::size_t{60}, std::size_t{30'000}, file.size() - 1200, std::size_t{1023}}) {
        std::string damaged = file;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        try {
            readE57(damaged);
            ADD_FAILURE() << at;
        } catch (const FileRefused& refused) {
            EXPECT_NE(refused.sentence.find("a checksum is wrong"), refused.sentence.npos) << refused.sentence;
            EXPECT_EQ(refused.place.number, at / 1024 * 1024);
        }
    }
    for (const std::size_t size : {std::size_t{10}, std::size_t{48}, std::size_t{2000}, file.size() - 1})
        EXPECT_NE(refusal(file.substr(0, size)), "read") << size;
    expectRefused(file.substr(0, file.size() - 1024), "ends too early");
    expectRefused("", "not an E57 file");
    expectRefused(std::string(2048, 'x'), "not an E57 file");
}

TEST(E57, LiesAreTold)
{
    E57Writer writer;
    writer.addScan(plain);
    const std::string content = writer.content();
    const auto with = [&](const std::string& from, std::string to) {
        to.resize(from.size(), ' '); // all else stays where it is
        return e57Pages(changed(content, from, to));
    };
    const std::string codecs = "<codecs type=\"Vector\" allowHeterogeneousChildren=\"1\"></codecs>";
    EXPECT_EQ(pointsOf(with(codecs, "<codecs/>")), plainPoints);
    expectRefused(with("recordCount=\"2\"", "recordCount=\"9\""), "promises more than it holds");
    expectRefused(with("recordCount=\"2\"", "recordCount=\"x\""), "missing or no number");
    expectRefused(with("fileOffset=\"48\"", "fileOffset=\"99\""), "damaged");
    expectRefused(with("</data3D>", "</data3E>"), "not well-formed");
    expectRefused(with(codecs, "<codecs><a><zip/></a></codecs>"), "are packed by");
    expectRefused(with("<cartesianX type=\"Float\"/>", "<cartesianX type=\"Text\"/>"), "no points");
    EXPECT_THROW(E57Pages(writer.file()).logical(1022), FileRefused) << "in a checksum";
    EXPECT_THROW(E57Pages(writer.file()).logical(1'000'000), FileRefused);
    for (std::size_t at = 16; at < 200; ++at) // the header, then the table of points
        for (const unsigned char bits : {0x01, 0x80, 0xff}) {
            std::string damaged = content;
            damaged[at] = static_cast<char>(damaged[at] ^ bits);
            refusal(e57Pages(damaged)); // read or refused
        }
}

TEST(E57, RefusesWhatNoScanNeeds)
{
    const auto refuses = [](const std::string& head, const std::string& more, const std::string& why) {
        E57Writer writer;
        writer.head = head + writer.head.substr(head.empty() ? 0 : writer.head.find('\n') + 1);
        writer.addScan(plain, 2, more);
        expectRefused(writer.file(), why);
    };
    refuses("<!DOCTYPE e57Root [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]>\n", "", "document type");
    refuses("", "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">0</w></rotation></pose>",
            "pose");
    refuses(
        "",
        "<pose type=\"Structure\"><translation type=\"Structure\"><x type=\"Float\">nan</x></translation></pose>",
        "pose");
    std::string deep;
    for (int i = 0; i < 100; ++i)
        deep += "<a>";
    refuses("", deep, "more is described");
    refuses("", "&unknown;", "not well-formed");
}

TEST(E57, NoPlaceIsReadTwice)
{
    E57Writer writer;
    writer.addScan(plain);
    writer.addScan(plain);
    const std::string content = writer.content();
    const std::size_t second = content.rfind("fileOffset=\"");
    ASSERT_EQ(content.substr(second + 12, 4), "164\"");
    const std::string twice = std::string(content).replace(second + 12, 4, "48\" ");
    expectRefused(e57Pages(twice), "at one place");
    E57Writer constant;
    constant.addScan({e57Integers("cartesianX", 1, 1, {1}), e57Integers("cartesianY", 1, 1, {1}),
                      e57Integers("cartesianZ", 1, 1, {1})},
                     2'000'000'000);
    expectRefused(constant.file(), "no points");
}

TEST(E57, TakesTimeLikeItsSizeAndStops)
{
    const auto file = [](int count) {
        std::vector<double> numbers(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = static_cast<double>(i);
        E57Writer writer;
        writer.bytesPerPacket = 3000;
        writer.addScan({e57Singles("cartesianX", numbers), e57Singles("cartesianY", numbers),
                        e57Singles("cartesianZ", numbers)});
        return writer.file();
    };
    EXPECT_LT(test::growth(4000, file, [](const std::string& bytes) { readE57(bytes); }), test::nearlyLinear);
    std::stop_source stop;
    const std::string bytes = file(20'000);
    const auto read = [&](std::uint64_t at, char* to, std::size_t count) {
        if (count > 0) // an empty file has no bytes to point to
            std::memcpy(to, bytes.data() + at, count);
        return true;
    };
    double most = 0;
    const FileBytes watched(read, bytes.size(),
                            {stop.get_token(),
                             [&](double done) {
                                 most = done;
                                 if (done > 0.4)
                                     stop.request_stop();
                             }},
                            4096);
    EXPECT_THROW(readE57(watched), ImportStopped);
    EXPECT_LT(most, 0.6) << "the end of the file, where the description is, does not count";
}

/// A column that comes before the others waits, but not for ever, and moving it costs no more than once.
TEST(E57, ColumnsMayLieFarFromEachOther)
{
    std::vector<std::int64_t> small(30'000), large(30'000);
    for (std::size_t i = 0; i < small.size(); ++i) {
        small[i] = static_cast<std::int64_t>(i % 2);
        large[i] = static_cast<std::int64_t>(i);
    }
    E57Writer writer;
    writer.bytesPerPacket = 20; // all of x is there soon, of y little by little
    writer.addScan({e57Integers("cartesianX", 0, 1, small),
                    e57Integers("cartesianY", -9223372036854775807 - 1, 9223372036854775807, large),
                    e57Integers("cartesianZ", 5, 5, {})},
                   small.size());
    const Points points = pointsOf(writer.file());
    ASSERT_EQ(points.size(), small.size());
    EXPECT_EQ(points[29'999], Vec3(1, 29'999, 5));
}

class E57ImportTest : public TestFiles {};

TEST_F(E57ImportTest, SaysFilePlaceAndRemedy)
{
    E57Writer writer;
    writer.addScan(plain);
    std::string file = writer.file();
    EXPECT_EQ(importCloud(write("a.e57", file)).cloud->points, plainPoints);
    file[100] = 'x';
    EXPECT_EQ(importCloud(write("b.E57", file)).problem.english(),
              "b.E57 (byte 0): the file is damaged: a checksum is wrong; copy it again, or export the scan anew");
}

} // namespace
} // namespace bolster
