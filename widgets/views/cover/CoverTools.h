// The tools of the 3D view. Those for a scan need to know which one: CoverView::startScanCut, startScanAlign.
#pragma once

#include "CoverTool.h"

#include <memory>

namespace bolster {

enum class CoverToolKind { Select, CutScan, AlignScan, DrawFixation };

std::unique_ptr<CoverTool> makeSurfaceTool(CoverToolKind kind, CoverToolContext& context);

} // namespace bolster
