// Where SVG draws things, and what it hides.
#include "Drawn.h"
#include "FoundPieces.h"

#include <set>

namespace bolster {

using namespace test;

namespace {

void expectBox(const Drawing& drawing, const Vec2& min, const Vec2& max)
{
    const Box2 box = boxOf(drawing);
    EXPECT_TRUE(box.min().isApprox(min, 1e-6)) << box.min().transpose();
    EXPECT_TRUE(box.max().isApprox(max, 1e-6)) << box.max().transpose();
}

const std::string tenByTen = "<rect x=\"0\" y=\"0\" width=\"10\" height=\"10\"/>";

} // namespace

TEST(SvgPlaces, WithoutUnitsNumbersAreAsTheyStandThere)
{
    const Drawing drawing = drawnSvg(tenByTen, "");
    EXPECT_FALSE(drawing.unit);
    ASSERT_TRUE(drawing.usualUnit);
    EXPECT_NEAR(*drawing.usualUnit, 25.4 / 96, 1e-12);
    expectBox(drawing, {0, -10}, {10, 0});
    EXPECT_NEAR(guessedUnit(drawing), 25.4 / 96, 1e-12);
    const Drawing scaled = drawnSvg(tenByTen, "width=\"400\" viewBox=\"0 0 200 100\"");
    EXPECT_NEAR(*scaled.usualUnit, 2 * 25.4 / 96, 1e-12);
    expectBox(scaled, {0, -10}, {10, 0});
}

TEST(SvgPlaces, OneSideTellsTheScale)
{
    const Drawing drawing = drawnSvg(tenByTen, "width=\"400mm\" viewBox=\"0 0 200 100\"");
    EXPECT_EQ(drawing.unit, 1);
    expectBox(drawing, {0, -20}, {20, 0});
}

TEST(SvgPlaces, ViewportsInIt)
{
    const std::string inside = "viewBox=\"0 0 10 10\">" + tenByTen;
    expectBox(drawnSvg("<svg x=\"50\" y=\"20\" width=\"40\" height=\"40\" " + inside + "</svg>"), {50, -60},
              {90, -20});
    // As high as wide in a viewport that is wider: in its middle, unless it says otherwise.
    expectBox(drawnSvg("<svg width=\"40\" height=\"20\" " + inside + "</svg>"), {10, -20}, {30, 0});
    expectBox(drawnSvg("<svg width=\"40\" height=\"20\" preserveAspectRatio=\"xMinYMin\" " + inside + "</svg>"),
              {0, -20}, {20, 0});
    expectBox(drawnSvg("<svg width=\"40\" height=\"20\" preserveAspectRatio=\"none\" " + inside + "</svg>"),
              {0, -20}, {40, 0});
    expectBox(drawnSvg("<svg width=\"50%\" height=\"100%\" preserveAspectRatio=\"none\" " + inside + "</svg>"),
              {0, -100}, {100, 0});
    const std::string symbol = "<symbol id=\"s\" " + inside + "</symbol>";
    expectBox(drawnSvg(symbol + "<use href=\"#s\" x=\"5\" width=\"30\" height=\"30\"/>"), {5, -30}, {35, 0});
}

TEST(SvgPlaces, PiecesAreCalledAsTheirLinesAre)
{
    const auto rectangle = [](const std::string& attributes, int x) {
        return "<rect " + attributes + " x=\"" + std::to_string(x) + "\" width=\"100\" height=\"80\"/>";
    };
    const FoundPattern found =
        findPieces(drawnSvg(rectangle("xmlns:inkscape=\"i\" inkscape:label=\"Back left\" id=\"rect1\"", 0) +
                            rectangle("data-name=\"Seat\" id=\"Seat-2\"", 200) + rectangle("id=\"wing\"", 400) +
                            rectangle("id=\"rect12-3\"", 600) + rectangle("id=\"lost\" data-piece=\"Arm\"", 800)),
                   {1, "", 0});
    std::multiset<std::string> names;
    for (const FoundPiece& piece : found.pieces)
        names.insert(piece.name);
    EXPECT_EQ(names, (std::multiset<std::string>{"Arm", "Back left", "Piece 1", "Seat", "wing"}));
}

TEST(SvgPlaces, LengthsInPercent)
{
    expectBox(drawnSvg("<rect x=\"10%\" y=\"10%\" width=\"50%\" height=\"50%\"/>"), {20, -60}, {120, -10});
    EXPECT_EQ(drawnSvg("<rect width=\"3em\" height=\"5\"/>").unknown.at("length that cannot be read"), 1);
}

TEST(SvgPlaces, TransformsOfStyles)
{
    expectBox(drawnSvg("<g style=\"transform: translate(20px, 5px) rotate(0.25turn)\">" + tenByTen + "</g>"),
              {10, -15}, {20, -5});
    expectBox(drawnSvg("<style>.away { transform: translateX(30px) }</style><g class=\"far away\" "
                       "transform=\"scale(7)\">" +
                       tenByTen + "</g>"),
              {30, -10}, {40, 0});
    expectBox(drawnSvg("<g transform=\"scale(2)\" transform-origin=\"10 10\">" + tenByTen + "</g>"), {-10, -10},
              {10, 10});
}

TEST(SvgPlaces, WhatLiesNobodyKnowsWhereIsTold)
{
    for (const char* transform :
         {"rotate(", "turn(3)", "rotate(1 2)", "matrix(1 0 0 1 0)", "translate(3em)", "scale(1,"}) {
        const Drawing drawing = drawnSvg(std::string("<g transform=\"") + transform + "\">" + tenByTen + "</g>");
        EXPECT_TRUE(drawing.parts.empty()) << transform;
        EXPECT_EQ(drawing.unknown.at("g whose transform cannot be read"), 1) << transform;
    }
    const std::string far = "<g transform=\"scale(1e12)\">";
    const Drawing drawing = drawnSvg(far + far + tenByTen + "</g></g>");
    EXPECT_TRUE(drawing.parts.empty());
    EXPECT_EQ(drawing.unknown.at("line too far away"), 1);
}

TEST(SvgPlaces, WhatIsHiddenIsNotDrawnAndTold)
{
    for (const std::string hidden :
         {"<rect display=\"none\"", "<rect visibility=\"hidden\"", "<rect style=\"fill:red;display : none\"",
          "<style>/* a { } */ .no, text { display: none !important }</style><rect class=\"yes no\"",
          "<style>#r{visibility:collapse}</style><rect id=\"r\"",
          "<style>@import url(x.css); rect{display:none}</style><rect",
          "<style>rect.no{display:none} rect{display:inline}</style><rect class=\"no\""}) {
        Drawing drawing = drawnSvg(hidden + " width=\"10\" height=\"10\"/>");
        EXPECT_TRUE(drawing.parts.empty()) << hidden;
        EXPECT_EQ(drawing.unknown["hidden rect"], 1) << hidden;
    }
    const Drawing inner = drawnSvg("<g visibility=\"hidden\">" + tenByTen +
                                   "<rect visibility=\"visible\" width=\"5\" height=\"5\"/></g>");
    EXPECT_EQ(inner.parts.at(0).lines.size(), 1u);
    const Drawing odd = drawnSvg("<style>g rect { display: none } g rect { fill: red }</style>" + tenByTen);
    EXPECT_EQ(odd.unknown.at("rule of a style sheet"), 1) << "whoever is meant by that";
    EXPECT_EQ(odd.parts.at(0).lines.size(), 1u);
}

TEST(SvgPlaces, RadiiBelowZeroAreTold)
{
    EXPECT_EQ(drawnSvg("<circle r=\"-4\"/>").unknown.at("circle without a radius"), 1);
}

TEST(SvgPlaces, EndsOfPointsAreTold)
{
    EXPECT_EQ(drawnSvg("<polygon points=\"0,0 10,0 10,10 x\"/>").unknown.at("end of a polygon"), 1);
}

TEST(SvgPlaces, ElementsHaveFewAttributes)
{
    std::string many = "<rect";
    for (int i = 0; i < 600; ++i)
        many.append(" a").append(std::to_string(i)).append("=\"\"");
    const FileRefused refused =
        refusalOf("<svg xmlns=\"http://www.w3.org/2000/svg\"><!-- it's -->" + many + "/></svg>", readSvg);
    EXPECT_EQ(refused.args, std::vector<std::string>{"500"}) << refused.sentence;
    EXPECT_EQ(refused.place.unit, FilePlace::Unit::Byte);
}

} // namespace bolster
