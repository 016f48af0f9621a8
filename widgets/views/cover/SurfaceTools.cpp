#include "SurfaceTools.h"

#include "FixationDrawTool.h"
#include "SurfaceSelectTool.h"

namespace bolster {

std::unique_ptr<SurfaceTool> makeSurfaceTool(SurfaceToolKind kind, SurfaceToolContext& context)
{
    if (kind == SurfaceToolKind::DrawFixation)
        return std::make_unique<FixationDrawTool>(context);
    return std::make_unique<SurfaceSelectTool>(context);
}

} // namespace bolster
