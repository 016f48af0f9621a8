// Which piece lies on which sheet of paper.
#include "Growth.h"
#include "SheetLayout.h"
#include "SheetPlan.h"
#include "SquarePlace.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace bolster {
namespace {

CutPiece pieceOf(const std::vector<Vec2>& corners)
{
    CutPiece piece;
    for (const Vec2& corner : corners)
        piece.cut.push_back({corner, true});
    piece.sew = piece.cut;
    const Vec2 middle = piece.box().center();
    piece.grain = {middle, middle + Vec2(0, 10), Nap::TwoWays};
    return piece;
}

CutPiece rectangle(double width, double height)
{
    return pieceOf({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

/// With y down from the table's upper edge.
QRectF boxOn(const SheetPlan& plan, const CutPattern& pattern, const TablePiece& place)
{
    const Box2 box = turnedBox(pattern.pieces[place.piece], place.angle);
    const Vec2 low = box.min() + place.offset, size = box.sizes();
    return {low.x(), plan.table.size.y() - low.y() - size.y(), size.x(), size.y()};
}

TEST(Sheets, HoldAPieceOnOneWhereItFits)
{
    // So large that none can lie on what others leave of their sheets.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> width(165, 180), height(240, 255);
    for (int round = 0; round < 20; ++round) {
        CutPattern pattern;
        for (int k = 0; k < 1 + 7 * round; ++k)
            pattern.pieces.push_back(k % 3 == 0 ? rectangle(height(random), width(random))
                                                : rectangle(width(random), height(random)));
        const SheetPlan plan = planSheets(pattern, {});
        ASSERT_EQ(plan.table.pieces.size(), pattern.pieces.size());
        EXPECT_EQ(plan.sheets.size(), pattern.pieces.size());
        for (std::size_t i = 0; i < plan.table.pieces.size(); ++i) {
            EXPECT_EQ(plan.spans[i].count(), 1) << round;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(boxOn(plan, pattern, plan.table.pieces[i])
                                 .intersects(boxOn(plan, pattern, plan.table.pieces[k])))
                    << "they lie apart";
        }
        for (const Sheet& sheet : plan.sheets)
            EXPECT_FALSE(sheet.left || sheet.right || sheet.above || sheet.below) << "nothing is put together";
    }
}

TEST(Sheets, HaveAStripAskewThatIsAFewMillimetresTooLong)
{
    CutPattern pattern;
    pattern.pieces.push_back(rectangle(20, 290)); // a sheet of A4 has room for 268 mm
    const SheetPlan plan = planSheets(pattern, {});
    ASSERT_EQ(plan.sheets.size(), 1u);
    const QRectF box = boxOn(plan, pattern, plan.table.pieces[0]);
    EXPECT_LE(box.width(), plan.grid.room.width());
    EXPECT_LE(box.height(), plan.grid.room.height());
}

TEST(Sheets, AreNotMoreThanSideBySide)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> side(30, 700);
    int fewer = 0;
    for (int round = 0; round < 30; ++round) {
        CutPattern pattern;
        for (int k = 0; k < 2 + round; ++k)
            pattern.pieces.push_back(rectangle(side(random), side(random)));
        const SheetPlan plan = planSheets(pattern, {});
        // In rows, every sheet that a box touches.
        const CutTable rows = arranged(pattern, tableWidth({}, false));
        SheetPlan beside;
        beside.table = rows;
        beside.grid = sheetGrid(rows.size, {}, false);
        std::set<std::pair<int, int>> used;
        for (const TablePiece& place : rows.pieces) {
            const SheetSpan span = beside.grid.spanOf(boxOn(beside, pattern, place));
            for (int row = span.top; row <= span.bottom; ++row)
                for (int column = span.left; column <= span.right; ++column)
                    used.emplace(row, column);
        }
        EXPECT_LE(plan.sheets.size(), used.size()) << round;
        fewer += plan.sheets.size() < used.size();
    }
    EXPECT_GT(fewer, 5);
}

TEST(Sheets, ThatNoPartOfAPieceLiesOnAreLeftOut)
{
    // An L of two arms, 900 mm long and 60 mm wide: nothing lies in the middle of its box.
    CutPattern pattern;
    pattern.pieces.push_back(pieceOf({{0, 0}, {900, 0}, {900, 60}, {60, 60}, {60, 900}, {0, 900}}));
    const SheetPlan plan = planSheets(pattern, {});
    EXPECT_LT(plan.sheets.size(), 10u) << "5 beside and 4 above each other";
    EXPECT_GE(plan.sheets.size(), 8u);
    EXPECT_EQ(plan.grid.rows, 1 + std::ranges::max(plan.sheets, {}, &Sheet::row).row) << "nobody looks for more";
    EXPECT_EQ(plan.grid.columns, 1 + std::ranges::max(plan.sheets, {}, &Sheet::column).column);
    for (const Sheet& sheet : plan.sheets) {
        EXPECT_EQ(sheet.pieces.size(), 1u);
        EXPECT_TRUE(sheet.left || sheet.right || sheet.above || sheet.below) << "it is put together with others";
    }
    // A square has sheets inside it on which no line is: without them the paper had holes.
    pattern.pieces = {rectangle(900, 900)};
    EXPECT_EQ(planSheets(pattern, {}).sheets.size(), 20u);
}

TEST(Sheets, HaveTheirSquareWhereNothingLies)
{
    CutPattern pattern;
    pattern.pieces.push_back(rectangle(60, 240));
    const PdfOrder order;
    const SheetPlan plan = planSheets(pattern, order);
    ASSERT_EQ(plan.sheets.size(), 1u);
    const SquarePlace place = squarePlace(pattern, plan, plan.sheets[0], {});
    EXPECT_TRUE(place.free);
    const QRectF square(place.corner, QSizeF(testSquare, testSquare));
    EXPECT_FALSE(square.intersects(boxOn(plan, pattern, plan.table.pieces[0]).translated(10, 10)));
    EXPECT_TRUE(plan.grid.room.contains(square));

    // Inside a piece that fills the sheet, but on no line.
    pattern.pieces = {rectangle(175, 250)};
    const SheetPlan full = planSheets(pattern, order);
    ASSERT_EQ(full.sheets.size(), 1u);
    const SquarePlace inside = squarePlace(pattern, full, full.sheets[0], {});
    EXPECT_FALSE(inside.free);
    EXPECT_TRUE(boxOn(full, pattern, full.table.pieces[0])
                    .translated(10, 10)
                    .adjusted(1, 1, -1, -1)
                    .contains(QRectF(inside.corner, QSizeF(testSquare, testSquare))));

    // A roll is longer if it must be.
    pattern.pieces = {rectangle(565, 300)};
    const SheetPlan roll = planSheets(pattern, {*paperSize("roll:600"), false, {}});
    ASSERT_EQ(roll.sheets.size(), 1u);
    EXPECT_TRUE(squarePlace(pattern, roll, roll.sheets[0], {}).free);
}

TEST(Sheets, OfAKilometreAreRefusedWithoutBeingCounted)
{
    CutPattern pattern;
    pattern.pieces.push_back(rectangle(1e6, 1e6));
    const SheetPlan plan = planSheets(pattern, {});
    EXPECT_TRUE(plan.tooMany());
    EXPECT_TRUE(plan.sheets.empty());
    EXPECT_GT(plan.wanted, 1e7);
}

TEST(Sheets, OfManyPiecesTakeAsMuchLonger)
{
    const auto make = [](int count) {
        CutPattern pattern;
        for (int k = 0; k < count; ++k)
            pattern.pieces.push_back(rectangle(60 + k % 300, 80 + k % 170));
        return pattern;
    };
    EXPECT_LT(test::growth(200, make, [](const CutPattern& pattern) { return planSheets(pattern, {}); }),
              test::nearlyLinear);
}

} // namespace
} // namespace bolster
