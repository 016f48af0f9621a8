// A pattern on sheets of paper, 1:1.
#pragma once

#include "CutLayers.h"
#include "CutTable.h"
#include "PaperSize.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QRectF>

namespace bolster {

/// How a table is divided into sheets.
struct SheetGrid {
    QSizeF paper; ///< mm
    QRectF room;  ///< of the paper that has a part of the table, mm from the upper left corner
    int rows = 1; ///< from above
    int columns = 1;
    QSizeF step;               ///< from sheet to sheet on the table, mm: neighbours have 10 mm in common
    Vec2 table = Vec2::Zero(); ///< mm

    /// The part of the table on a sheet, mm, y up.
    Box2 part(int row, int column) const;
};

SheetGrid sheetGrid(const Vec2& table, const PaperSize& paper, bool landscape);

/// The widest table that has sense on this paper: so many sheets beside each other.
double tableWidth(const PaperSize& paper, bool landscape);

struct PdfOrder {
    PaperSize paper;
    bool landscape = false;
    CutLayers layers = {};
};

/// An overview first, if there are several sheets; then a page for each sheet with something on it. Every one has a
/// square of 100 mm and one of an inch, its place among the others, and marks that meet those of its neighbours.
/// Needs a QGuiApplication.
class PatternPdf {
    Q_DECLARE_TR_FUNCTIONS(PatternPdf)

public:
    PatternPdf(const CutPattern& pattern, const PdfOrder& order);
    QByteArray bytes() const;
    int pages() const;
    /// Empty ones too; more than mostSheets are not to be drawn: whoever has such a pattern mistook its unit.
    double sheets() const { return double(m_grid.rows) * double(m_grid.columns); }
    static constexpr double mostSheets = 5000;

private:
    class Pages;

    const CutPattern& m_pattern;
    PdfOrder m_order;
    CutTable m_table;
    SheetGrid m_grid;
};

} // namespace bolster
