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

/// The file's bytes. PDF needs a QGuiApplication. `cover`: for the sewing sheet, may be null.
std::string patternBytes(const Design& design, const PatternOrder& order, const QImage& cover = {});
/// "pdf", "dxf", "svg", "plt"
QString patternEnding(PatternFormat format);
/// Whether it is divided into sheets of paper.
inline bool hasSheets(PatternFormat format)
{
    return format == PatternFormat::Pdf;
}

} // namespace bolster
