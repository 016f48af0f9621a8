// Draws pieces as they are cut: on paper, and for dialogs that show what will be on it.
#pragma once

#include "CutLayers.h"
#include "CutTable.h"

class QPainter;

namespace bolster {

/// In mm, y up, on a painter that is set up for that. Lines are as wide as on paper, or so many times.
void drawPiece(QPainter& painter, const CutPiece& piece, const TablePiece& place, const CutLayers& layers,
               double thickness = 1);

} // namespace bolster
