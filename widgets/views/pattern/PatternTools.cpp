#include "PatternTools.h"

#include "AttachTool.h"
#include "BackgroundTools.h"
#include "BoxShapeTool.h"
#include "DartRotateTool.h"
#include "DartTool.h"
#include "MarkTool.h"
#include "MeasureTool.h"
#include "OutlineTool.h"
#include "PatternDrawTool.h"
#include "PatternSelectTool.h"
#include "PatternSplitTool.h"
#include "SewTool.h"
#include "TrimTool.h"

namespace bolster {

std::unique_ptr<PatternTool> makePatternTool(PatternToolKind kind, PatternToolContext& context)
{
    switch (kind) {
    case PatternToolKind::Outline:
        return std::make_unique<OutlineTool>(context);
    case PatternToolKind::Rectangle:
        return std::make_unique<BoxShapeTool>(context, BoxShape::Rectangle);
    case PatternToolKind::Ellipse:
        return std::make_unique<BoxShapeTool>(context, BoxShape::Ellipse);
    case PatternToolKind::HandleCurve:
        return std::make_unique<PatternDrawTool>(context, DrawnKind::HandleCurve);
    case PatternToolKind::FancySeam:
        return std::make_unique<PatternDrawTool>(context, DrawnKind::FancySeam);
    case PatternToolKind::InternalLine:
        return std::make_unique<PatternDrawTool>(context, DrawnKind::InternalLine);
    case PatternToolKind::Notch:
        return std::make_unique<MarkTool>(context, MarkKind::Notch);
    case PatternToolKind::DrillHole:
        return std::make_unique<MarkTool>(context, MarkKind::DrillHole);
    case PatternToolKind::EdgeAllowance:
        return std::make_unique<MarkTool>(context, MarkKind::EdgeAllowance);
    case PatternToolKind::CutCorner:
        return std::make_unique<MarkTool>(context, MarkKind::CutCorner);
    case PatternToolKind::Sew:
        return std::make_unique<SewTool>(context);
    case PatternToolKind::Attach:
        return std::make_unique<AttachTool>(context);
    case PatternToolKind::Trim:
        return std::make_unique<TrimTool>(context);
    case PatternToolKind::Split:
        return std::make_unique<PatternSplitTool>(context);
    case PatternToolKind::Dart:
        return std::make_unique<DartTool>(context);
    case PatternToolKind::DartRotation:
        return std::make_unique<DartRotateTool>(context);
    case PatternToolKind::Measure:
        return std::make_unique<MeasureTool>(context);
    case PatternToolKind::BackgroundScale:
        return std::make_unique<BackgroundScaleTool>(context);
    case PatternToolKind::BackgroundMove:
        return std::make_unique<BackgroundMoveTool>(context);
    case PatternToolKind::Select:
        break;
    }
    return std::make_unique<PatternSelectTool>(context);
}

} // namespace bolster
