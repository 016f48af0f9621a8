// How a table with pieces is divided into sheets of paper.
#pragma once

#include "Geometry.h"
#include "PaperSize.h"

#include <QRectF>

namespace bolster {

/// Sheets beside and below each other, the first and the last included.
struct SheetSpan {
    int top = 0, bottom = 0, left = 0, right = 0;

    double count() const { return (bottom - top + 1.0) * (right - left + 1.0); }
};

struct SheetGrid {
    QSizeF paper; ///< mm
    QRectF room;  ///< of the paper that has a part of the table, mm from the upper left corner
    int rows = 1; ///< from above
    int columns = 1;
    QSizeF step;               ///< from sheet to sheet on the table, mm: neighbours have 10 mm in common
    Vec2 table = Vec2::Zero(); ///< mm

    /// The part of the table on a sheet, mm, y up.
    Box2 part(int row, int column) const;
    /// The fewest sheets that have all of a box on the table; its y runs down from the table's upper edge, mm.
    SheetSpan spanOf(const QRectF& box) const;
    /// Of all sheets together, mm.
    QSizeF whole() const;
};

/// What neighbours have in common, mm.
inline constexpr double sheetOverlap = 10;
/// Of the paper below its room, for words, mm.
inline constexpr double sheetFooter = 9;

/// Sheets of a roll are as long as the table, up to 5 m: longer pages there are not in PDF.
SheetGrid sheetGrid(const Vec2& table, const PaperSize& paper, bool landscape);

/// The widest table that has sense on this paper: so many sheets beside each other.
double tableWidth(const PaperSize& paper, bool landscape);

} // namespace bolster
