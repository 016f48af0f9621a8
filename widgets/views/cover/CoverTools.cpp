#include "CoverTools.h"

#include "CoverMeasureTool.h"
#include "CoverSelectTool.h"
#include "FixationDrawTool.h"

namespace bolster {

std::unique_ptr<CoverTool> makeSurfaceTool(CoverToolKind kind, CoverToolContext& context)
{
    if (kind == CoverToolKind::DrawFixation)
        return std::make_unique<FixationDrawTool>(context);
    if (kind == CoverToolKind::Measure)
        return std::make_unique<CoverMeasureTool>(context);
    return std::make_unique<CoverSelectTool>(context);
}

} // namespace bolster
