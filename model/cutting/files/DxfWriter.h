// Patterns as DXF, for cutters and pattern programs.
#pragma once

#include "CutLayers.h"
#include "CutPattern.h"

namespace bolster {

enum class DxfStandard {
    Aama,   ///< ANSI/AAMA-292: a block for each piece, numbered layers
    Astm,   ///< ASTM D6673: the same with other texts
    Plain,  ///< R12: everything where it lies on the table, layers with names
    Splines ///< R2000: the same; sewing lines and lines inside as curves, exactly
};

struct DxfOrder {
    DxfStandard standard = DxfStandard::Aama;
    CutLayers layers = {};
    std::string date = {}; ///< DD-MM-YYYY
    std::string time = {}; ///< HH:MM
};

/// ASCII with CR LF; millimetres.
std::string dxfText(const CutPattern& pattern, const DxfOrder& order);

} // namespace bolster
