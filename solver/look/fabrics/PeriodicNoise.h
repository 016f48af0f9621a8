// Noise that repeats after a whole number of units, so that a tile has no border. The same on every machine.
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace bolster {

using Spot = Eigen::Vector2f; ///< where on a tile

/// 0 to 1, for a lattice point.
float randomAt(int x, int y, std::uint32_t seed);

/// Gradient noise (K. Perlin, "Improving noise", 2002) with a bump a unit, about -1 to 1; it repeats after `period`
/// units, at least 1.
float noiseAt(const Spot& at, Eigen::Vector2i period, std::uint32_t seed);

/// Octaves of it, each half as strong and twice as fine, about -1 to 1. `at`: 0 to 1 over the tile; `period` is
/// that of the first octave.
float fractalAt(const Spot& at, Eigen::Vector2i period, int octaves, std::uint32_t seed);

/// Where a place lies among points strewn one to a unit square (S. Worley, "A cellular texture basis function",
/// 1996).
struct Cell {
    float nearest = 9; ///< distances to the nearest points, units
    float second = 9;
    float random = 0; ///< 0 to 1, of the nearest point

    /// Distance from the border between both cells, units.
    float inside() const { return 0.5f * (second - nearest); }
};

/// `jitter`: 0 for a lattice to 1 for points anywhere in their squares.
Cell cellAt(const Spot& at, int period, float jitter, std::uint32_t seed);

/// 0 below `from`, 1 above `to`, smooth between.
float ramp(float from, float to, float value);

} // namespace bolster
