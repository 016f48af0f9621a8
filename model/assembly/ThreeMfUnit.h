// What a 3MF file says that Assimp does not tell: its unit, the names of its objects, and what is wrong with it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace bolster {

/// mm; 1, as the format has it, when the file says nothing that can be read, and nothing when it says a unit that
/// the format does not have. `bytes`: the whole file, a ZIP archive.
std::optional<double> threeMfUnit(std::string_view bytes);

struct ThreeMfObjects {
    /// By the objects' numbers, which Assimp takes for names. Of those that have one.
    std::map<std::string, std::string, std::less<>> names;
    double placed = 0;             ///< objects with all that they consist of, as often as the build places them
    bool hasDecimalCommas = false; ///< in coordinates: they would be read as whole numbers
    bool hasWrongIndices = false;  ///< of triangles: no numbers, or such as would be taken for others
};

ThreeMfObjects threeMfObjects(std::string_view bytes);

} // namespace bolster
