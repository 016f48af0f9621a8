// Between light and the numbers that screens are given (IEC 61966-2-1).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace bolster {

/// Both within 0 and 1.
inline float linearFromSrgb(float shown)
{
    return shown <= 0.04045F ? shown / 12.92F : std::pow((shown + 0.055F) / 1.055F, 2.4F);
}
inline float srgbFromLinear(float light)
{
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
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
