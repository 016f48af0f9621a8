// One colour for each seam pair, the same in every view; safe for colour-blind people.
#pragma once

#include "Design.h"

#include <QColor>

#include <map>

namespace bolster {

/// Seams at the same patch get different colours as far as the palette reaches. Depends on the design alone.
std::map<ElementId, QColor> seamColors(const Design& design, bool darkBackground);

/// "A", "B" ... "Z", "AA": of the seam with so many before it, the same for both of its sides.
QString seamLabel(std::size_t before);
/// The letter of a seam in the pattern; "" for what is none.
QString seamLetter(const Design& design, ElementId seam);

} // namespace bolster
