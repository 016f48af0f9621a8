// How reading patterns grows with what is in them.
#include "Growth.h"

#include "Drawn.h"
#include "PatternDesign.h"
#include "StripBreaks.h"

#include <numbers>

namespace bolster {

using namespace test;

namespace {

const auto findAll = [](const Drawing& drawing) { findPieces(drawing, {}); };
const auto importAll = [](const Drawing& drawing) { patternEdit(Design(), findPieces(drawing, {})); };

/// Pieces beside each other, each with a sewing line, a hole and a line inside.
Drawing manyPieces(int count, const std::string& cut, const std::string& sew)
{
    Drawing drawing = drawingWith({});
    DrawnPart& part = drawing.parts.front();
    const int columns = 50;
    for (int i = 0; i < count; ++i) {
        const Vec2 at(400.0 * (i % columns), 300.0 * (i / columns));
        part.lines.push_back(rectangleOf(cut, at, {320, 220}));
        part.lines.push_back(rectangleOf(sew, at + Vec2(10, 10), {300, 200}));
        part.lines.push_back(lineOf("8", {at + Vec2(50, 50), at + Vec2(150, 50)}));
        part.dots.push_back({"13", at + Vec2(100, 100), 3, 0, {}});
    }
    return drawing;
}

Drawing manyBlocks(int count)
{
    Drawing drawing;
    for (int i = 0; i < count; ++i) {
        drawing.parts.push_back({"Seat", {rectangleOf("1", {0, 0}, {300, 200})}, {}, {}});
    }
    return drawing;
}

Drawing manyHoles(int count)
{
    Drawing drawing = drawingWith({rectangleOf("1", {0, 0}, {10000, 10000})});
    for (int i = 0; i < count; ++i)
        drawing.parts.front().dots.push_back({"13", {10.0 + i % 1000, 10.0 + i / 1000}, 3, 0, {}});
    return drawing;
}

Drawing manyFromOnePoint(int count)
{
    Drawing drawing = drawingWith({rectangleOf("1", {-1000, -1000}, {2000, 2000})});
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        drawing.parts.front().lines.push_back(lineOf("8", {{0, 0}, 900 * Vec2(std::cos(angle), std::sin(angle))}));
    }
    return drawing;
}

struct DesignWithEdges {
    Design design;
    std::vector<OutlineEdge> edges;
};

/// Each edge is as long as all others.
DesignWithEdges manySquares(int count)
{
    Patch square;
    square.outline = BSpline2(1, true, {{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    Edit edit;
    for (int i = 0; i < count; ++i) {
        square.position = {120.0 * i, 0};
        edit.changes.push_back({ElementId(i + 1), nullptr, makeElement(square)});
    }
    const Design design = Design().with(edit);
    return {design, outlineEdges(design)};
}

std::string manyAttributes(int count)
{
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect";
    for (int i = 0; i < count; ++i)
        text.append(" a").append(std::to_string(i)).append("=\"\"");
    return text + "/></svg>";
}

} // namespace

TEST(PatternGrowth, Pieces)
{
    for (const auto& [cut, sew] : {std::pair("1", "14"), std::pair("0", "0")})
        EXPECT_LT(growth(
                      500, [cut = cut, sew = sew](int n) { return manyPieces(n, cut, sew); }, findAll),
                  nearlyLinear)
            << cut;
}

TEST(PatternGrowth, Blocks)
{
    EXPECT_LT(growth(500, manyBlocks, importAll), nearlyLinear);
}

TEST(PatternGrowth, DrillHoles)
{
    EXPECT_LT(growth(1000, manyHoles, importAll), nearlyLinear);
}

TEST(PatternGrowth, LinesFromOnePoint)
{
    EXPECT_LT(growth(500, manyFromOnePoint, findAll), nearlyLinear);
}

TEST(PatternGrowth, AttributesOfAnElement)
{
    EXPECT_LT(growth(5000, manyAttributes, [](const std::string& text) { refusalOf(text, readSvg); }),
              nearlyLinear);
}

TEST(PatternGrowth, StripsAlongSquares)
{
    EXPECT_LT(growth(150, manySquares,
                     [](const DesignWithEdges& squares) { stripBreaks(squares.design, squares.edges); }),
              nearlyLinear);
}

TEST(PatternGrowth, UnitGuess)
{
    EXPECT_LT(growth(
                  250, [](int n) { return manyPieces(n, "1", "14"); }, guessedUnit),
              nearlyLinear);
}

} // namespace bolster
