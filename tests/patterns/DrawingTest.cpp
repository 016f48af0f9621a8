// What becomes of the entities and elements of drawings.
#include "DrawingReaders.h"

#include <gtest/gtest.h>

#include <numbers>

namespace bolster {

namespace {

/// "0 LINE 8 cut 10 0": codes and values with a blank between them, values without blanks.
std::string groups(const std::string& words)
{
    std::string text;
    bool code = true;
    std::string word;
    for (const char c : words + " ") {
        if (c != ' ') {
            word += c;
            continue;
        }
        if (word.empty())
            continue;
        text += (code ? "  " : "") + word + "\r\n";
        code = !code;
        word.clear();
    }
    return text;
}

Drawing dxf(const std::string& entities, const std::string& before = "")
{
    return readDxf(
        FileBytes(std::string_view(groups(before + " 0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF"))));
}

const DrawnLine& onlyLine(const Drawing& drawing)
{
    EXPECT_EQ(drawing.parts.size(), 1u);
    EXPECT_EQ(drawing.parts.at(0).lines.size(), 1u);
    return drawing.parts.at(0).lines.at(0);
}

double farthestFromCircle(const DrawnLine& line, const Vec2& centre, double radius)
{
    double worst = 0;
    for (const DrawnPoint& point : line.points)
        worst = std::max(worst, std::abs((point.at - centre).norm() - radius));
    return worst;
}

Drawing svg(const std::string& inside,
            const std::string& size = "width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\"")
{
    const std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">" + inside + "</svg>";
    return readSvg(FileBytes(std::string_view(text)));
}

std::string refusal(const std::string& text, Drawing (*read)(const FileBytes&))
{
    try {
        read(FileBytes(std::string_view(text)));
    } catch (const FileRefused& refused) {
        return refused.sentence;
    }
    return {};
}

} // namespace

TEST(DxfDrawing, LinesArcsAndCircles)
{
    const Drawing line = dxf("0 LINE 8 cut 10 1 20 2 11 3 21 5");
    EXPECT_EQ(onlyLine(line).layer, "cut");
    EXPECT_EQ(onlyLine(line).points.back().at, Vec2(3, 5));
    const Drawing arc = dxf("0 ARC 8 a 10 10 20 0 40 5 50 350 51 10");
    EXPECT_LT(farthestFromCircle(onlyLine(arc), {10, 0}, 5), 1e-9);
    EXPECT_NEAR(onlyLine(arc).points.back().at.y(), 5 * std::sin(std::numbers::pi / 18), 1e-9);
    const Drawing circle = dxf("0 CIRCLE 8 a 10 0 20 0 40 5");
    EXPECT_TRUE(onlyLine(circle).closed);
    EXPECT_EQ(onlyLine(circle).circle, 5);
}

TEST(DxfDrawing, BulgesAreArcs)
{
    // A half circle over a chord of 10, to its right: bulge 1 runs counter-clockwise.
    const Drawing drawing = dxf("0 LWPOLYLINE 8 a 70 1 10 0 20 0 42 1 10 10 20 0");
    EXPECT_TRUE(onlyLine(drawing).closed);
    double lowest = 0;
    for (const DrawnPoint& point : onlyLine(drawing).points)
        lowest = std::min(lowest, point.at.y());
    EXPECT_NEAR(lowest, -5, 1e-3);
    const Drawing old =
        dxf("0 POLYLINE 8 a 66 1 70 0 0 VERTEX 8 a 10 0 20 0 42 -1 0 VERTEX 8 a 10 10 20 0 0 SEQEND");
    EXPECT_LT(farthestFromCircle(onlyLine(old), {5, 0}, 5), 1e-9);
    EXPECT_GT(onlyLine(old).points[5].at.y(), 0);
}

TEST(DxfDrawing, SplinesAndEllipses)
{
    // A quarter of a circle as a rational quadratic.
    const Drawing quarter =
        dxf("0 SPLINE 8 a 70 0 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.7071067811865476 41 1 "
            "10 1 20 0 10 1 20 1 10 0 20 1");
    EXPECT_LT(farthestFromCircle(onlyLine(quarter), {0, 0}, 1), 1e-9);
    EXPECT_EQ(onlyLine(quarter).points[3].bend, Bend::Smooth);
    const Drawing ellipse = dxf("0 ELLIPSE 8 a 10 0 20 0 11 4 21 0 40 0.5 41 0 42 6.283185307179586");
    EXPECT_TRUE(onlyLine(ellipse).closed);
    Box2 box;
    for (const DrawnPoint& point : onlyLine(ellipse).points)
        box.extend(point.at);
    EXPECT_NEAR(box.sizes().x(), 8, 1e-3);
    EXPECT_NEAR(box.sizes().y(), 4, 1e-3);
}

TEST(DxfDrawing, BlocksAreInsertedTurnedAndScaled)
{
    const std::string block = "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 Seat 70 64 10 1 20 1 "
                              "0 LINE 8 0 10 1 20 1 11 2 21 1 0 ENDBLK 0 ENDSEC";
    const Drawing drawing = dxf("0 INSERT 8 cut 2 Seat 10 10 20 20 41 3 42 3 50 90", block);
    EXPECT_EQ(drawing.parts.at(0).name, "Seat");
    EXPECT_EQ(onlyLine(drawing).layer, "cut") << "what lies on layer 0 lies on that of the insert";
    EXPECT_TRUE(onlyLine(drawing).points.back().at.isApprox(Vec2(10, 23), 1e-9));
    EXPECT_EQ(dxf("", block).parts.size(), 1u) << "a piece that nobody put onto the sheet";
}

TEST(DxfDrawing, BlocksInThemselvesEnd)
{
    const std::string block = "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 A 0 INSERT 8 0 2 A 0 INSERT 8 0 2 A "
                              "0 LINE 8 0 10 0 20 0 11 1 21 1 0 ENDBLK 0 ENDSEC";
    const Drawing drawing = dxf("0 INSERT 8 0 2 A", block);
    EXPECT_GT(drawing.unknown.at("INSERT in INSERT"), 0);
    const std::string bomb = groups(block + " 0 SECTION 2 ENTITIES 0 INSERT 8 0 2 A 70 100 71 100 0 ENDSEC 0 EOF");
    EXPECT_NE(refusal(bomb, readDxf), "") << "more than a pattern can have";
}

TEST(DxfDrawing, CountsWhatItDoesNotKnow)
{
    const Drawing drawing = dxf("0 HATCH 8 a 0 HATCH 8 a 0 3DFACE 8 a 0 LINE 8 a 10 0 20 0 11 1 21 1");
    EXPECT_EQ(drawing.unknown.at("HATCH"), 2);
    EXPECT_EQ(drawing.unknown.at("3DFACE"), 1);
}

TEST(DxfDrawing, TextsAreDecoded)
{
    const Drawing drawing = dxf("0 TEXT 8 1 10 0 20 0 40 5 1 R\\U+00FCcken");
    EXPECT_EQ(drawing.texts.at(0), "R\u00fccken");
}

TEST(DxfDrawing, RefusesWhatIsNone)
{
    EXPECT_NE(refusal("AutoCAD Binary DXF\r\n\x1a", readDxf), "");
    EXPECT_NE(refusal("hello\nworld\n", readDxf), "");
    EXPECT_NE(refusal("  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n 10\nnan\n", readDxf), "");
    EXPECT_NE(refusal("", readDxf), "");
}

TEST(SvgDrawing, MeasuresInMillimetresWithYUp)
{
    const Drawing drawing = svg("<path d=\"M10 10 L30 10 l0 20 z\"/>");
    ASSERT_TRUE(drawing.unit);
    EXPECT_NEAR(onlyLine(drawing).points[1].at.x(), 30, 1e-9);
    EXPECT_NEAR(onlyLine(drawing).points[2].at.y(), -30, 1e-9);
    EXPECT_TRUE(onlyLine(drawing).closed);
    EXPECT_FALSE(svg("<line x2=\"96\"/>", "").unit) << "pixels are no measure";
}

TEST(SvgDrawing, TransformsAndUse)
{
    const Drawing drawing = svg("<defs><rect id=\"r\" width=\"10\" height=\"20\"/></defs>"
                                "<g transform=\"translate(5,5) rotate(90)\"><use href=\"#r\" x=\"1\"/></g>");
    Box2 box;
    for (const DrawnPoint& point : onlyLine(drawing).points)
        box.extend(point.at);
    EXPECT_TRUE(box.min().isApprox(Vec2(-15, -16), 1e-9)) << box.min().transpose();
    EXPECT_TRUE(box.max().isApprox(Vec2(5, -6), 1e-9)) << box.max().transpose();
}

TEST(SvgDrawing, ArcsAndCurves)
{
    const Drawing arc = svg("<path d=\"M 0 0 A 5 5 0 0 1 10 0\"/>");
    EXPECT_LT(farthestFromCircle(onlyLine(arc), {5, 0}, 5), 1e-9);
    EXPECT_GT(onlyLine(arc).points[20].at.y(), 0) << "the flag for the sweep: clockwise on the screen";
    const Drawing circle = svg("<circle cx=\"5\" cy=\"5\" r=\"3\" transform=\"scale(2)\"/>");
    EXPECT_NEAR(onlyLine(circle).circle, 6, 1e-9);
    const Drawing cubic = svg("<path d=\"M0,0C0,10,10,10,10,0S20-10,20,0\"/>");
    EXPECT_TRUE(onlyLine(cubic).points.back().at.isApprox(Vec2(20, 0), 1e-9));
}

TEST(SvgDrawing, ExpandsNothingWithoutLimit)
{
    const Drawing drawing = svg("<g id=\"a\"><use href=\"#a\"/><use href=\"#a\"/><line x2=\"1\"/></g>");
    EXPECT_GT(drawing.unknown.at("use in use"), 0);
    EXPECT_NE(refusal("<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">"
                      "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;\"><!ENTITY d \"&c;&c;&c;&c;&c;&c;\">]>"
                      "<svg xmlns=\"http://www.w3.org/2000/svg\"><title>&d;&d;&d;&d;&d;</title></svg>",
                      readSvg),
              "");
    EXPECT_NE(refusal("<svg><g>", readSvg), "");
    EXPECT_NE(refusal("<html/>", readSvg), "");
}

} // namespace bolster
