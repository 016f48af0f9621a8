// Cuts into a piece that lie edge to edge when it is flat, drawn apart a little. Private to the library.
#pragma once

#include "Flatten.h"

#include <vector>

namespace bolster {

/// A cut that needs no room lies edge to edge when the piece is flat, and an outline must not touch itself: its
/// sides are drawn apart a little, less towards its end, and less where it bends, as its outer side becomes longer
/// than the inner one. Moves places of the border of `flat`, which is the piece `p` of the form. Of each place of
/// the border: how far apart a cut may be drawn there, mm.
std::vector<double> openCuts(const Form& form, std::size_t p, FlatPiece& flat);

/// How far from its end on such a cut becomes wider, mm, if it may be drawn apart so far (mm).
double opensWithin(double room);

/// Whether a row of the piece `p` is the side of a cut that does not open when the piece is flat.
bool liesAtOtherSide(const Form& form, std::size_t p, std::size_t row, const FlatPiece& flat);

} // namespace bolster
