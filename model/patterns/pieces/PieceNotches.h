// Notches as points of layers, and as lines that somebody drew. Private to the library.
#pragma once

#include "FoundPieces.h"

namespace bolster {

/// A point on a layer of notches; depth and width where the file says them, in `unit` millimetres.
FoundNotch notchOfDot(const DrawnDot& dot, double unit);
/// A notch as it is cut: a slit, a V, a T, a castle, a U, by the number of its points. Nothing for other lines.
std::optional<FoundNotch> notchOfLine(const Contour& line, const Contour& outline);
/// With the bar of each T, which may be a line of its own, put to its stem.
std::vector<Contour> withBars(std::vector<Contour> lines);
/// Two of one shape beside each other, or three, are one that is double.
void pairDoubles(std::vector<FoundNotch>& notches);

} // namespace bolster
