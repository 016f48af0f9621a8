// What the words of a piece say. Private to the library.
#pragma once

#include "FoundPieces.h"

namespace bolster {

/// "KEY: value" as blocks of AAMA and ASTM have it. False when the key is none of theirs.
bool readKey(const std::string& words, FoundPiece& piece);
/// Lines of a label that people read, the first one being the name: "Cut 2 and 2 mirrored", "2x", "Qty 4".
void readLabel(const std::vector<std::string>& lines, FoundPiece& piece);

} // namespace bolster
