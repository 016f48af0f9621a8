// A pattern on sheets of paper, 1:1.
#pragma once

#include "SheetPlan.h"
#include "SheetWatch.h"

#include <QByteArray>
#include <QCoreApplication>

namespace bolster {

/// An overview first, if there are several sheets; then a page for each sheet that a piece needs. Every one has a
/// square of 100 mm and one of an inch, its place among the others, and marks towards those with which it is put
/// together. Needs a QGuiApplication.
class PatternPdf {
    Q_DECLARE_TR_FUNCTIONS(PatternPdf)

public:
    PatternPdf(const CutPattern& pattern, const PdfOrder& order, const std::stop_token& stop = {});

    const SheetPlan& plan() const { return m_plan; }
    /// Nothing when it is stopped, and of too many sheets.
    QByteArray bytes(const SheetWatch& watch = {}) const;

private:
    class Pages;

    void keepLabelsOnSheets();

    CutPattern m_pattern;
    PdfOrder m_order;
    SheetPlan m_plan;
};

} // namespace bolster
