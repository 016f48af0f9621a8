// The production pattern around and in the patches: cut lines, notches, grain, labels, drill holes.
#pragma once

#include "PatternLabel.h"

#include <vector>

class QPainter;

namespace bolster {

class Selection;
struct CutPattern;
struct CutPiece;
struct PieceLabel;
struct ViewColors;

/// The label of a patch's piece where it is so large on the screen that it can be read; else null, and the view's
/// own words stand there.
const PieceLabel* readableLabel(const CutPattern* cut, ElementId patch, const PatternTransform& transform);
/// The piece of a patch if it has a label, readable or not; else null.
const CutPiece* labelledPiece(const CutPattern* cut, ElementId patch);
/// Where the label of a piece cannot be read its name stands there alone, as large as the view's own words; until
/// somebody has put the label somewhere, where the name finds room.
PatternLabel nameOnPiece(const CutPiece& piece, const PatternPatch& patch, const PatternTransform& transform,
                         const QFont& font);
/// Around that which stands there, label or name, in pixels; empty when nothing does.
QPolygonF labelFrame(const CutPiece& piece, const PatternPatch& patch, const PatternTransform& transform,
                     const QFont& font);

/// Below the patches: the allowances, faintly.
void paintAllowances(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                     const PatternTransform& transform, const ViewColors& colors);
/// Above them: everything else, and handles of what somebody placed. Grain lines leave the `words` of the view
/// (pixels) free.
void paintCutMarks(QPainter& painter, const CutPattern& pattern, const PatternScene& scene,
                   const PatternTransform& transform, const ViewColors& colors, const Selection& selection,
                   const std::vector<QPolygonF>& words);

} // namespace bolster
