// The words on the labels of pieces, in the user's language.
#pragma once

#include "CutPattern.h"

namespace bolster {

CutWords cutLabelWords();

} // namespace bolster
