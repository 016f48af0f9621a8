// Where the grain line and the label of a piece find room.
#pragma once

#include "CutPiece.h"

#include <utility>

namespace bolster {

/// As long as there is room for, up to 200 mm; `grain` in degrees, counter-clockwise.
GrainLine placeGrain(const CutPiece& piece, double grain);

/// The largest letters, up to 6 mm from line to line, with which it lies inside the sewing line and on nothing
/// else; turned so that the grain runs up, or along the piece if only so there is room. `fits` is false when there
/// is none. `avoided`: lines that it must not lie on either.
PieceLabel placeLabel(const CutPiece& piece, std::vector<std::string> lines, double grain,
                      const std::vector<std::pair<Vec2, Vec2>>& avoided = {});
/// The same where somebody has put it.
PieceLabel placeLabel(const CutPiece& piece, std::vector<std::string> lines, const PieceLabelPlace& place);

} // namespace bolster
