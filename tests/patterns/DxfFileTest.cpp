// Files of DXF that are cut off, binary, in code pages, with what is hidden.
#include "Drawn.h"

#include <cstring>

namespace bolster {

using namespace test;

namespace {

const std::string square = "0 POLYLINE 8 1 66 1 70 1 0 VERTEX 8 1 10 0 20 0 0 VERTEX 8 1 10 9 20 0 "
                           "0 VERTEX 8 1 10 9 20 9 0 SEQEND 8 other";

std::string inEntities(const std::string& entities)
{
    return dxfGroupsOf("0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

/// A binary file, with codes of one or two bytes.
class BinaryDxf {
public:
    explicit BinaryDxf(bool shortCodes)
        : m_short(shortCodes)
    {}

    BinaryDxf& words(int code, const std::string& text)
    {
        add(code);
        m_bytes.append(text).push_back('\0');
        return *this;
    }
    BinaryDxf& real(int code, double value)
    {
        add(code);
        raw(value);
        return *this;
    }
    BinaryDxf& integer(int code, std::int16_t value)
    {
        add(code);
        raw(value);
        return *this;
    }
    const std::string& bytes() const { return m_bytes; }

private:
    template <class T>
    void raw(T value)
    {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        m_bytes.append(bytes, sizeof(T));
    }
    void add(int code)
    {
        if (!m_short)
            raw(static_cast<std::int16_t>(code));
        else if (code < 255)
            m_bytes.push_back(static_cast<char>(code));
        else
            m_bytes.push_back('\xFF'), raw(static_cast<std::int16_t>(code));
    }

    bool m_short;
    std::string m_bytes = std::string("AutoCAD Binary DXF\r\n\x1a\0", 22);
};

std::string binaryLine(bool shortCodes, int comment)
{
    BinaryDxf file(shortCodes);
    if (comment > 0)
        file.words(comment, "by hand");
    file.words(0, "SECTION").words(2, "ENTITIES").words(0, "LINE").words(8, "cut").integer(62, -3);
    file.real(10, 1).real(20, 2).real(11, 30.5).real(21, -4).words(1000, "more").integer(1070, 7);
    file.words(0, "ENDSEC").words(0, "EOF");
    return file.bytes();
}

} // namespace

TEST(DxfFile, ThatIsCutOffIsRefused)
{
    const std::string whole = "0 SECTION 2 ENTITIES " + square + " " + square;
    const FileRefused refused = refusalOf(dxfGroupsOf(whole));
    EXPECT_NE(refused.sentence.find("not whole"), std::string::npos) << refused.sentence;
    EXPECT_EQ(refused.args, std::vector<std::string>{"ENTITIES"});
    EXPECT_EQ(refused.place.unit, FilePlace::Unit::Line);
    EXPECT_GT(refused.place.number, 40u) << "where it ends";
    const std::string block = "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 Seat " + square;
    EXPECT_NE(refusalOf(dxfGroupsOf(block)).sentence, "");
    EXPECT_NE(refusalOf(dxfGroupsOf("0 SECTION 2 ENTITIES 0 POLYLINE 8 1 66 1 0 VERTEX 10 1 20 1")).sentence, "")
        << "without SEQEND";
}

TEST(DxfFile, WithoutItsEndMarkIsReadAndTold)
{
    const Drawing drawing = drawn(dxfGroupsOf("0 SECTION 2 ENTITIES " + square + " 0 ENDSEC"));
    EXPECT_EQ(drawing.parts.at(0).lines.size(), 1u);
    EXPECT_EQ(drawing.notes.size(), 1u);
    EXPECT_TRUE(drawn(inEntities(square)).notes.empty());
    EXPECT_TRUE(drawn(inEntities(square) + "whatever\nfollows\n").notes.empty()) << "nobody reads on";
}

TEST(DxfFile, WhatFollowsALineIsNotPartOfIt)
{
    EXPECT_EQ(drawn(inEntities(square)).parts.at(0).lines.at(0).layer, "1");
}

TEST(DxfFile, MayBeginWithAByteOrderMark)
{
    EXPECT_EQ(drawn(std::string("\xEF\xBB\xBF").append(inEntities(square))).parts.size(), 1u);
}

TEST(DxfFile, MayBeBinary)
{
    for (const bool shortCodes : {true, false})
        for (const int comment : {0, 999}) {
            const Drawing drawing = drawn(binaryLine(shortCodes, comment));
            ASSERT_EQ(drawing.parts.size(), 1u) << shortCodes << comment;
            const DrawnLine& line = drawing.parts[0].lines.at(0);
            EXPECT_EQ(line.layer, "cut");
            EXPECT_EQ(line.points.at(0).at, Vec2(1, 2));
            EXPECT_EQ(line.points.at(1).at, Vec2(30.5, -4));
        }
    const std::string whole = binaryLine(false, 0);
    const FileRefused cut = refusalOf(whole.substr(0, whole.size() - 30));
    EXPECT_NE(cut.sentence, "");
    EXPECT_EQ(cut.place.unit, FilePlace::Unit::Byte);
}

TEST(DxfFile, NamesAreInItsCodePage)
{
    const auto layer = [](const std::string& page, const std::string& bytes) {
        const std::string head = page.empty() ? "" : "0 SECTION 2 HEADER 9 $DWGCODEPAGE 3 " + page + " 0 ENDSEC ";
        return drawn(dxfGroupsOf(head + "0 SECTION 2 ENTITIES 0 LINE 8 " + bytes +
                                 " 10 0 20 0 11 1 21 1 0 ENDSEC 0 EOF"))
            .parts.at(0)
            .lines.at(0)
            .layer;
    };
    EXPECT_EQ(layer("ANSI_1251", "\xE2\xFB\xEA\xF0\xEE\xE9\xEA\xE0"), "выкройка");
    EXPECT_EQ(layer("ANSI_1250", "\xB9\xEA"), "ąę");
    EXPECT_EQ(layer("ANSI_932", "\x8C\x5E"), "型");
    EXPECT_EQ(layer("ANSI_1251", "Rücken"), "Rücken") << "UTF-8 whatever it says";
    EXPECT_EQ(layer("", "R\xFC"
                        "cken\x80"),
              "Rücken€")
        << "Western European";
    EXPECT_EQ(layer("nonsense", "R\xFC"
                                "cken"),
              "Rücken");
}

TEST(DxfFile, BlocksInOthersAreDrawnOnce)
{
    const std::string blocks = "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 Pocket 0 LINE 8 0 10 0 20 0 11 1 21 1 0 ENDBLK "
                               "0 BLOCK 8 0 2 Seat 0 INSERT 8 0 2 Pocket 0 LINE 8 0 10 5 20 5 11 6 21 6 0 ENDBLK "
                               "0 ENDSEC 0 SECTION 2 ENTITIES 0 ENDSEC 0 EOF";
    const Drawing drawing = drawn(dxfGroupsOf(blocks));
    ASSERT_EQ(drawing.parts.size(), 1u);
    EXPECT_EQ(drawing.parts[0].name, "Seat");
    EXPECT_EQ(drawing.parts[0].lines.size(), 2u);
}

TEST(DxfFile, HiddenEntitiesAreNotDrawnAndTold)
{
    const Drawing drawing =
        drawn(inEntities("0 LINE 8 a 60 1 10 0 20 0 11 1 21 1 0 LINE 8 a 60 0 10 0 20 0 11 1 21 1"));
    EXPECT_EQ(drawing.parts.at(0).lines.size(), 1u);
    EXPECT_EQ(drawing.unknown.at("hidden LINE"), 1);
}

TEST(DxfFile, RadiiBelowZeroAreTold)
{
    const Drawing drawing = drawn(inEntities("0 CIRCLE 8 13 10 0 20 0 40 -5 0 ARC 8 13 10 0 20 0 40 0 50 0 51 90"));
    EXPECT_TRUE(drawing.parts.empty());
    EXPECT_EQ(drawing.unknown.at("CIRCLE without a radius"), 1);
    EXPECT_EQ(drawing.unknown.at("ARC without a radius"), 1);
}

TEST(DxfFile, MessagesSayLimitAndPlace)
{
    const FileRefused large = refusalOf(inEntities("0 LINE 8 a 10 1e300"));
    EXPECT_EQ(large.place.number, 10u);
    EXPECT_EQ(large.args.size(), 2u) << large.sentence;
    const FileRefused often =
        refusalOf(dxfGroupsOf("0 SECTION 2 BLOCKS 0 BLOCK 2 A 0 LINE 10 0 20 0 11 1 21 1 0 ENDBLK "
                              "0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 2 A 70 900 71 900 0 ENDSEC "
                              "0 EOF"));
    EXPECT_EQ(often.args, (std::vector<std::string>{"A", "10000"}));
}

} // namespace bolster
