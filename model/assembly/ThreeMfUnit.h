// The unit that a 3MF file is in, which Assimp does not tell.
#pragma once

#include <string_view>

namespace bolster {

/// mm; 1, as the format has it, when the file says nothing that can be read. `bytes`: the whole file, a ZIP
/// archive.
double threeMfUnit(std::string_view bytes);

} // namespace bolster
