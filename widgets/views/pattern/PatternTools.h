// The tools of the pattern view.
#pragma once

#include "PatternTool.h"

#include <memory>

namespace bolster {

enum class PatternToolKind {
    Select,
    Outline,
    Rectangle,
    Ellipse,
    Split,
    Dart,
    DartRotation,
    HandleCurve,
    FancySeam,
    InternalLine,
    Notch,
    DrillHole,
    EdgeAllowance,
    CutCorner,
    Sew,
    Attach,
    Trim,
    Measure,
    BackgroundScale,
    BackgroundMove
};

std::unique_ptr<PatternTool> makePatternTool(PatternToolKind kind, PatternToolContext& context);

} // namespace bolster
