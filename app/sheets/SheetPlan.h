// What is on which sheet of paper.
#pragma once

#include "CutLayers.h"
#include "CutTable.h"
#include "SheetGrid.h"

#include <stop_token>

namespace bolster {

struct PdfOrder {
    PaperSize paper;
    bool landscape = false;
    CutLayers layers = {};
};

/// A sheet that is printed.
struct Sheet {
    int row = 0, column = 0;
    std::vector<std::size_t> pieces;                                ///< of the table: those that need it
    bool left = false, right = false, above = false, below = false; ///< a piece goes on there
};

struct SheetPlan {
    CutTable table;
    SheetGrid grid;
    std::vector<Sheet> sheets;    ///< by rows; those that no piece needs are left out
    std::vector<SheetSpan> spans; ///< of each piece of the table
    double wanted = 0;            ///< how many there would be

    /// More are not to be drawn: whoever has such a pattern mistook its unit. `sheets` is empty then.
    bool tooMany() const { return wanted > mostSheets; }
    /// There is a page with all of them on it.
    bool hasOverview() const { return sheets.size() > 1; }
    int pages() const { return static_cast<int>(sheets.size()) + hasOverview(); }

    static constexpr double mostSheets = 5000;
};

/// Incomplete when it is stopped.
SheetPlan planSheets(const CutPattern& pattern, const PdfOrder& order, const std::stop_token& stop = {});

} // namespace bolster
