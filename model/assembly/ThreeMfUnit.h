// What a 3MF file says that Assimp does not tell: its unit, and the names of its objects.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace bolster {

/// mm; 1, as the format has it, when the file says nothing that can be read, and nothing when it says a unit that
/// the format does not have. `bytes`: the whole file, a ZIP archive.
std::optional<double> threeMfUnit(std::string_view bytes);

/// By the objects' numbers, which Assimp takes for names. Of those that have one.
std::map<std::string, std::string, std::less<>> threeMfNames(std::string_view bytes);

} // namespace bolster
