// A number for a place, which no file can be made to collide in: the seed is random.
#pragma once

#include "Geometry.h"

#include <bit>
#include <cstdint>

namespace bolster {

inline std::uint64_t mixedBits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// Of -0 another one than of 0.
inline std::uint64_t placeHash(const Vec3& point, std::uint64_t seed)
{
    for (int i = 0; i < 3; ++i)
        seed = mixedBits(seed ^ std::bit_cast<std::uint64_t>(point[i]));
    return seed;
}

} // namespace bolster
