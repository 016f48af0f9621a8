// Outlines whose sewn sides are equally long.
#pragma once

#include "BSpline.h"
#include "Form.h"

#include <stop_token>
#include <vector>

namespace bolster {

/// The outline of a piece, counter-clockwise: open curves from corner to corner, each begins where the one before
/// ends. None of a piece that is left out.
struct PieceCurves {
    std::vector<BSpline2> curves;
    std::vector<std::size_t> rows; ///< with which curve each of the piece's rows begins, the first one with curve 0
    std::vector<bool> shut = {}; ///< of each row: it lies beside the one that it is sewn to, and stays where it is

    bool isShut(std::size_t row) const { return row < shut.size() && shut[row]; }
};

/// Edges of triangles on both sides of a seam are equally long, but smooth curves through their ends are longer
/// where they bend more. Moves control points by as little as possible (least squares) until sides that are sewn to
/// each other are equally long, to 0.01 mm, and others as long as they were; straight curves stay straight. As they
/// were where that would ask for more than half a millimetre of a point, or when stopped.
void makeSidesEqual(const Form& form, std::vector<PieceCurves>& pieces, const std::stop_token& stop = {});

} // namespace bolster
