#include "PatternTools.h"

#include "AttachTool.h"
#include "PatternDrawTool.h"
#include "PatternSelectTool.h"
#include "SewTool.h"
#include "PatternSplitTool.h"

namespace bolster {

std::unique_ptr<PatternTool> makePatternTool(PatternToolKind kind, PatternToolContext& context)
{
    switch (kind) {
    case PatternToolKind::HandleCurve:
        return std::make_unique<PatternDrawTool>(context, DrawnKind::HandleCurve);
    case PatternToolKind::FancySeam:
        return std::make_unique<PatternDrawTool>(context, DrawnKind::FancySeam);
    case PatternToolKind::Sew:
        return std::make_unique<SewTool>(context);
    case PatternToolKind::Attach:
        return std::make_unique<AttachTool>(context);
    case PatternToolKind::Split:
        return std::make_unique<PatternSplitTool>(context);
    case PatternToolKind::Select:
        break;
    }
    return std::make_unique<PatternSelectTool>(context);
}

} // namespace bolster
