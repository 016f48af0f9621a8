#include "CoverTools.h"

#include "CoverSelectTool.h"
#include "FixationDrawTool.h"

namespace bolster {

std::unique_ptr<CoverTool> makeSurfaceTool(CoverToolKind kind, CoverToolContext& context)
{
    if (kind == CoverToolKind::DrawFixation)
        return std::make_unique<FixationDrawTool>(context);
    return std::make_unique<CoverSelectTool>(context);
}

} // namespace bolster
