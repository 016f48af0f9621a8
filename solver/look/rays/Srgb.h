// Between light and the numbers that screens are given (IEC 61966-2-1).
#pragma once

#include "LinearLight.h"
#include "Shading.h"

#include <array>
#include <cstdint>

namespace bolster {

/// Both within 0 and 1.
inline float linearFromSrgb(float shown)
{
    return toLinear(shown);
}
inline float srgbFromLinear(float light)
{
    return shading::encoded(light);
}

/// The same of a byte, from a table.
inline float linearFromSrgb(std::uint8_t shown)
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> light{};
        for (std::size_t i = 0; i < light.size(); ++i)
            light[i] = linearFromSrgb(static_cast<float>(i) / 255);
        return light;
    }();
    return table[shown];
}

} // namespace bolster
