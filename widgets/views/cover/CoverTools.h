// The tools of the 3D view. Cutting a scan needs to know which one: CoverView::startScanCut.
#pragma once

#include "CoverTool.h"

#include <memory>

namespace bolster {

enum class CoverToolKind { Select, CutScan, DrawFixation };

std::unique_ptr<CoverTool> makeSurfaceTool(CoverToolKind kind, CoverToolContext& context);

} // namespace bolster
