// The production pattern around and in the patches: cut lines, notches, grain, labels, drill holes.
#pragma once

class QPainter;

namespace bolster {

class PatternScene;
class PatternTransform;
class Selection;
struct CutPattern;
struct ViewColors;

/// Whether labels of pieces are large enough to be read.
bool pieceLabelsReadable(const PatternTransform& transform);

/// Below the patches: the allowances, faintly.
void paintAllowances(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                     const PatternTransform& transform, const ViewColors& colors);
/// Above them: everything else, and handles of what somebody placed.
void paintCutMarks(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                   const PatternTransform& transform, const ViewColors& colors, const Selection& selection);

} // namespace bolster
