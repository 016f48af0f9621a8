// The tools of the 3D view. Some need to know for what: CoverView::startScanCut, startScanAlign, startFrameEdges,
// startAreaBrush.
#pragma once

#include "CoverTool.h"

#include <memory>

namespace bolster {

enum class CoverToolKind { Select, CutScan, AlignScan, DrawFixation, FixEdge, PaintArea, Measure };

std::unique_ptr<CoverTool> makeSurfaceTool(CoverToolKind kind, CoverToolContext& context);

} // namespace bolster
