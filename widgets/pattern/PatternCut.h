// The production pattern around and in the patches: cut lines, notches, grain, labels, drill holes.
#pragma once

#include "ElementId.h"

#include <QPolygonF>

#include <vector>

class QPainter;

namespace bolster {

class PatternScene;
class PatternTransform;
class Selection;
struct CutPattern;
struct PieceLabel;
struct ViewColors;

/// The label of a patch's piece where it is so large on the screen that it can be read; else null, and the view's
/// own words stand there.
const PieceLabel* readableLabel(const CutPattern* cut, ElementId patch, const PatternTransform& transform);

/// Below the patches: the allowances, faintly.
void paintAllowances(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                     const PatternTransform& transform, const ViewColors& colors);
/// Above them: everything else, and handles of what somebody placed. Grain lines leave the `words` of the view
/// (pixels) free.
void paintCutMarks(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                   const PatternTransform& transform, const ViewColors& colors, const Selection& selection,
                   const std::vector<QPolygonF>& words);

} // namespace bolster
