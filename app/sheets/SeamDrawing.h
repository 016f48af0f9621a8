// A piece with the numbers of its seams, for whoever sews.
#pragma once

#include "CutPiece.h"

#include <QImage>

namespace bolster {

/// A part of a piece's outline that is sewn.
struct NumberedSide {
    int number = 0;
    double from = 0; ///< parameters of the outline
    double to = 0;
};

/// Pixels: as large as fits, with the piece's proportions.
QSize seamDrawingSize(const CutPiece& piece, const QSize& most);

/// With its grain upright; each number in a circle beside the middle of its edge, inside where there is room.
QImage seamDrawing(const CutPiece& piece, const std::vector<NumberedSide>& sides, const QSize& pixels);

} // namespace bolster
