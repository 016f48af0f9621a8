#include "MapScale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace bolster {

namespace {

using Stop = std::array<float, 3>;
constexpr std::array<Stop, 5> diverging = { // ColorBrewer's RdBu
    {{0x21, 0x66, 0xac}, {0x74, 0xb0, 0xd8}, {0xf5, 0xf5, 0xf5}, {0xf0, 0x94, 0x6c}, {0xb2, 0x18, 0x2b}}};
constexpr std::array<Stop, 9> sequential = {{{0x44, 0x01, 0x54}, // Matplotlib's viridis
                                             {0x47, 0x2d, 0x7b},
                                             {0x3b, 0x52, 0x8b},
                                             {0x2c, 0x72, 0x8e},
                                             {0x21, 0x91, 0x8c},
                                             {0x28, 0xae, 0x80},
                                             {0x5e, 0xc9, 0x62},
                                             {0xad, 0xdc, 0x30},
                                             {0xfd, 0xe7, 0x25}}};

} // namespace

MapScale::Rgba MapScale::color(float value, float allowed) const
{
    const bool known = std::isfinite(value) && limit > 0;
    if (known && std::abs(value) > allowed)
        return value > 0 ? over : under;
    const bool both = kind == Kind::Diverging;
    const std::span<const Stop> stops = both ? std::span<const Stop>(diverging) : std::span<const Stop>(sequential);
    const float share = known ? std::clamp(value / limit, both ? -1.F : 0.F, 1.F) : 0;
    const float at = (both ? 0.5F * (share + 1) : share) * static_cast<float>(stops.size() - 1);
    const std::size_t lower = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const float part = at - static_cast<float>(lower);
    Rgba rgba{};
    for (std::size_t c = 0; c < 3; ++c)
        rgba[c] = static_cast<std::uint8_t>(std::lround((1 - part) * stops[lower][c] + part * stops[lower + 1][c]));
    rgba[3] = known ? 255 : 0;
    return rgba;
}

float MapScale::usualLimit(double size)
{
    for (double decade = 1e-4; decade < 1e6; decade *= 10)
        for (const double round : {1.0, 2.0, 5.0})
            if (round * decade >= size)
                return static_cast<float>(round * decade);
    return 1e6F;
}

} // namespace bolster
