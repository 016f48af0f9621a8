// A pattern as a file: which format, and what it holds.
#pragma once

#include "DxfWriter.h"
#include "PatternPdf.h"

#include <string>

namespace bolster {

enum class PatternFormat { Pdf, DxfAama, DxfAstm, DxfPlain, Svg, Hpgl };

struct PatternOrder {
    PatternFormat format = PatternFormat::Pdf;
    PaperSize paper;
    bool landscape = false;
    CutLayers layers = {};
    CutOptions cutting = {};
};

/// The file's bytes. PDF needs a QGuiApplication.
std::string patternBytes(const CutPattern& pattern, const PatternOrder& order);
/// "pdf", "dxf", "svg", "plt"
QString patternEnding(PatternFormat format);
/// Whether it is divided into sheets of paper.
inline bool hasSheets(PatternFormat format)
{
    return format == PatternFormat::Pdf;
}

} // namespace bolster
