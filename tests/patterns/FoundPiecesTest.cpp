// Which pieces are in a drawing.
#include "FoundPieces.h"
#include "PatternDesign.h"

#include <gtest/gtest.h>

namespace bolster {

namespace {

DrawnLine line(const std::string& layer, std::vector<Vec2> points, bool closed = false)
{
    DrawnLine drawn;
    drawn.layer = layer;
    drawn.closed = closed;
    for (const Vec2& at : points)
        drawn.points.push_back({at});
    return drawn;
}

DrawnLine rectangleLine(const std::string& layer, const Vec2& from, const Vec2& size)
{
    return line(layer, {from, from + Vec2(size.x(), 0), from + size, from + Vec2(0, size.y())}, true);
}

Drawing drawingOf(std::vector<DrawnLine> lines)
{
    Drawing drawing;
    drawing.parts.push_back({"", std::move(lines), {}, {}});
    return drawing;
}

} // namespace

TEST(FoundPieces, ArePutTogetherFromOpenLines)
{
    const FoundPattern found =
        findPieces(drawingOf({line("1", {{0, 0}, {100, 0}}), line("1", {{100, 200}, {100, 0}}),
                              line("1", {{100, 200}, {0, 200}, {0, 0}})}),
                   {});
    ASSERT_EQ(found.pieces.size(), 1u);
    EXPECT_NEAR(found.pieces[0].cut.signedArea(), 20000, 1e-9);
    EXPECT_TRUE(found.pieces[0].isCutLine);
}

TEST(FoundPieces, OpenOutlinesAreToldAndClosedOnDemand)
{
    const Drawing drawing = drawingOf({line("1", {{0, 0}, {100, 0}, {100, 200}, {0, 200}, {0, 3}})});
    const FoundPattern open = findPieces(drawing, {});
    EXPECT_TRUE(open.pieces.empty());
    ASSERT_EQ(open.open.size(), 1u);
    EXPECT_NEAR(open.open[0].gap, 3, 1e-9);
    EXPECT_EQ(findPieces(drawing, {1, "", 4}).pieces.size(), 1u);
    EXPECT_EQ(findPieces(drawing, {10, "", 4}).pieces.size(), 0u) << "30 mm in centimetres";
}

TEST(FoundPieces, DoubledLinesAreTakenOnce)
{
    const DrawnLine outline = rectangleLine("cut", {0, 0}, {100, 50});
    const FoundPattern found = findPieces(drawingOf({outline, outline, line("cut", {{300, 0}, {300, 10}})}), {});
    EXPECT_EQ(found.pieces.size(), 1u);
    EXPECT_EQ(found.doubled, 1);
}

TEST(FoundPieces, WithoutLayersTheOutermostLinesArePieces)
{
    const FoundPattern found =
        findPieces(drawingOf({rectangleLine("0", {0, 0}, {300, 200}), rectangleLine("0", {10, 10}, {280, 180}),
                              rectangleLine("0", {100, 50}, {20, 20}), rectangleLine("0", {400, 0}, {100, 100})}),
                   {});
    ASSERT_EQ(found.pieces.size(), 2u);
    ASSERT_TRUE(found.pieces[0].sew) << "it follows the outline at 10 mm";
    EXPECT_NEAR(found.pieces[0].sew->signedArea(), 280 * 180, 1e-9);
    EXPECT_EQ(found.pieces[0].inner.size(), 1u);
    EXPECT_FALSE(found.pieces[1].sew);
}

TEST(FoundPieces, AllowancesAreUnderstood)
{
    // 10 mm all around, 25 mm at the bottom.
    const FoundPattern found = findPieces(
        drawingOf({rectangleLine("1", {-10, -25}, {320, 235}), rectangleLine("14", {0, 0}, {300, 200})}), {});
    const ImportedPattern imported = patternEdit(Design(), found);
    const Design design = Design().with(imported.edit);
    const Patch& patch = *design.find<Patch>(imported.patches.at(0));
    EXPECT_EQ(patch.outline.degree(), 1);
    EXPECT_EQ(patch.outline.pointCount(), 4);
    ASSERT_TRUE(patch.allowance);
    EXPECT_EQ(patch.allowance->width, 10);
    EXPECT_EQ(patch.allowance->corner, CornerJoin::Mitred);
    std::vector<double> widths;
    design.each<EdgeAllowance>([&](ElementId, const EdgeAllowance& edge) { widths.push_back(edge.width); });
    EXPECT_EQ(widths, std::vector<double>{25});
    const Design byCut = Design().with(patternEdit(Design(), found, {PatternLines::Cut, {}}).edit);
    byCut.each<Patch>([](ElementId, const Patch& whole) {
        EXPECT_NEAR(whole.outline.signedArea(), 320 * 235, 1e-6);
        EXPECT_EQ(whole.allowance->width, 0);
    });
}

TEST(FoundPieces, OneSizeIsTakenOfMany)
{
    Drawing drawing;
    for (const auto& [name, width] : {std::pair{"S", 90.0}, {"M", 100.0}, {"L", 110.0}}) {
        DrawnPart part;
        part.name = std::string("Seat_").append(name);
        part.lines.push_back(rectangleLine("1", {0, 0}, {width, 50}));
        part.texts.push_back({"1", {0, 0}, std::string("Size: ").append(name)});
        part.texts.push_back({"1", {0, 0}, "Quantity: 2,2"});
        drawing.parts.push_back(std::move(part));
    }
    drawing.texts.push_back("Sample Size: M");
    const FoundPattern sample = findPieces(drawing, {});
    EXPECT_EQ(sample.sizes, (std::vector<std::string>{"S", "M", "L"}));
    ASSERT_EQ(sample.pieces.size(), 1u);
    EXPECT_EQ(sample.pieces[0].name, "Seat");
    EXPECT_EQ(sample.pieces[0].quantity, 2);
    EXPECT_TRUE(sample.pieces[0].pair);
    EXPECT_NEAR(sample.pieces[0].cut.box().sizes().x(), 100, 1e-9);
    EXPECT_NEAR(findPieces(drawing, {1, "L", 0}).pieces.at(0).cut.box().sizes().x(), 110, 1e-9);
}

TEST(FoundPieces, UnitsAreGuessedByWordsAndSizes)
{
    Drawing drawing = drawingOf({rectangleLine("1", {0, 0}, {67.2, 22.8})});
    EXPECT_EQ(guessedUnit(drawing), 10) << "nobody sews a pattern of 67 mm";
    drawing.texts.push_back("Units: ENGLISH");
    EXPECT_EQ(guessedUnit(drawing), 25.4);
    drawing.unit = 1;
    EXPECT_EQ(guessedUnit(drawing), 1) << "the file says so";
    EXPECT_EQ(guessedUnit(drawingOf({rectangleLine("1", {0, 0}, {672, 228})})), 1);
}

} // namespace bolster
