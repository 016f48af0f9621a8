// The options of "bolster bench", which the program itself checks before it becomes the one that measures.
#pragma once

#include "Arguments.h"

#include <array>

namespace bolster::cli {

inline constexpr std::array benchOptions = {
    OptionRule{"--json", true}, OptionRule{"--markdown", true}, OptionRule{"--quick", false},
    OptionRule{"--smoke", false}, // for tests: tiny meshes, figures that say nothing
};

} // namespace bolster::cli
