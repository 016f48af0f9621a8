#include "SurfaceTools.h"

#include "SurfaceSelectTool.h"

namespace bolster {

std::unique_ptr<SurfaceTool> makeSurfaceTool(SurfaceToolKind, SurfaceToolContext& context)
{
    return std::make_unique<SurfaceSelectTool>(context);
}

} // namespace bolster
