// A pattern as a file: which format, and what it holds.
#pragma once

#include "DxfWriter.h"
#include "PatternPdf.h"

#include <QImage>

#include <string>

namespace bolster {

enum class PatternFormat { Pdf, DxfAama, DxfAstm, DxfPlain, DxfSplines, Svg, Hpgl, SewingSheet };

struct PatternOrder {
    PatternFormat format = PatternFormat::Pdf;
    PaperSize paper;
    bool landscape = false;
    CutLayers layers = {};
    CutOptions cutting = {};
};

/// The file's bytes; nothing when it is stopped. PDF needs a QGuiApplication. `cover`: for the sewing sheet, may be
/// null.
std::string patternBytes(const Design& design, const PatternOrder& order, const QImage& cover = {},
                         const SheetWatch& watch = {});
/// The first pages of the sewing sheet, as wide as that, at most so many. `all`: how many there are.
std::vector<QImage> sewingPages(const Design& design, const PatternOrder& order, const QImage& cover, int width,
                                int most, int& all, const SheetWatch& watch);
/// "pdf", "dxf", "svg", "plt"
QString patternEnding(PatternFormat format);
/// Whether it is divided into sheets of paper.
inline bool hasSheets(PatternFormat format)
{
    return format == PatternFormat::Pdf;
}

} // namespace bolster
