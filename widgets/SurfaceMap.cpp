#include "SurfaceMap.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Told apart by people who see no red or green, too (ColorBrewer's RdBu).
constexpr std::array<std::array<float, 3>, 5> stops = {
    {{0x21, 0x66, 0xac}, {0x74, 0xb0, 0xd8}, {0xf5, 0xf5, 0xf5}, {0xf0, 0x94, 0x6c}, {0xb2, 0x18, 0x2b}}};

} // namespace

SurfaceMap::Rgba SurfaceMap::color(float value) const
{
    const bool known = std::isfinite(value) && limit > 0;
    const float share = known ? std::clamp(value / limit, -1.F, 1.F) : 0;
    const float at = 0.5F * (share + 1) * static_cast<float>(stops.size() - 1);
    const std::size_t lower = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const float part = at - static_cast<float>(lower);
    Rgba rgba{};
    for (std::size_t c = 0; c < 3; ++c)
        rgba[c] = static_cast<std::uint8_t>(std::lround((1 - part) * stops[lower][c] + part * stops[lower + 1][c]));
    rgba[3] = known ? 255 : 0;
    return rgba;
}

std::vector<SurfaceMap::Rgba> SurfaceMap::colors() const
{
    std::vector<Rgba> all;
    all.reserve(values.size());
    for (const float value : values)
        all.push_back(color(value));
    return all;
}

float SurfaceMap::usualLimit(double size)
{
    for (double decade = 1e-4; decade < 1e6; decade *= 10)
        for (const double round : {1.0, 2.0, 5.0})
            if (round * decade >= size)
                return static_cast<float>(round * decade);
    return 1e6F;
}

} // namespace bolster
