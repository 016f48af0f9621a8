// The tools of the 3D view. Cutting a scan needs to know which one: SurfaceView::startScanCut.
#pragma once

#include "SurfaceTool.h"

#include <memory>

namespace bolster {

enum class SurfaceToolKind { Select, CutScan, DrawFixation };

std::unique_ptr<SurfaceTool> makeSurfaceTool(SurfaceToolKind kind, SurfaceToolContext& context);

} // namespace bolster
