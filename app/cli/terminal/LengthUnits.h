// Units by their words on the command line.
#pragma once

#include "Arguments.h"

#include <array>

namespace bolster::cli {

struct LengthUnit {
    const char* word;
    const char* many; ///< for people
    double millimetres;
};

inline constexpr std::array<LengthUnit, 5> lengthUnits{{{"mm", "millimetres", 1},
                                                        {"cm", "centimetres", 10},
                                                        {"m", "metres", 1000},
                                                        {"in", "inches", 25.4},
                                                        {"ft", "feet", 304.8}}};

/// What `--unit` says, mm; nothing without it. Throws UsageError when it is none of these.
std::optional<double> saidUnit(const Arguments& arguments, std::span<const LengthUnit> units = lengthUnits);

/// "millimetres"; nothing for a length that none of these has.
std::optional<std::string> unitName(double millimetres, std::span<const LengthUnit> units = lengthUnits);

/// Whether `--up` says y; nothing without it. Throws UsageError when it is neither y nor z.
std::optional<bool> saysUpIsY(const Arguments& arguments);

} // namespace bolster::cli
