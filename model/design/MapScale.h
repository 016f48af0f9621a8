// Colours for numbers, told apart by people who see no red or green, too.
#pragma once

#include <array>
#include <cstdint>

namespace bolster {

struct MapScale {
    enum class Kind {
        Diverging, ///< from -limit (blue) over 0 (nearly white) to limit (red)
        Sequential ///< from 0 (dark violet) to limit (yellow)
    };

    Kind kind = Kind::Diverging;
    float limit = 1; ///< > 0

    using Rgba = std::array<std::uint8_t, 4>;
    /// sRGB. Alpha 0 where nothing is known (NaN). `over` or `under` where the value's size is over `allowed`, > 0.
    Rgba color(float value, float allowed = 1e30F) const;

    /// Nearly black: cloth that tears is another matter than cloth that folds.
    static constexpr Rgba over = {0x4d, 0x00, 0x1a, 255}, under = {0x06, 0x12, 0x46, 255};
    /// A round number that is not below this one.
    static float usualLimit(double size);
};

} // namespace bolster
