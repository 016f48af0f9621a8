// What "bolster export" is asked for.
#pragma once

#include "Arguments.h"
#include "CutPattern.h"
#include "DxfWriter.h"
#include "SheetPlan.h"

namespace bolster::cli {

struct ExportOrder {
    DxfStandard standard = DxfStandard::Aama;
    PdfOrder pdf;       ///< its layers are those of all formats
    CutOptions cutting; ///< but for the pieces
    bool lenient = false;
};

/// Throws UsageError.
ExportOrder exportOrder(const Arguments& arguments);

/// The patches of the names that were given, all when there are none; throws UsageError for one that there is not.
std::optional<std::set<ElementId>> chosenPieces(const Arguments& arguments, const Design& design);

} // namespace bolster::cli
