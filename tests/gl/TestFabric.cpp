#include "TestFabric.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster::test {

namespace {

/// Height of a yarn that runs along the first coordinate and goes under and over; both from 0 to 1, two yarns each.
double yarn(double along, double across, double phase)
{
    const double round = std::sin(std::numbers::pi * (2 * across - std::floor(2 * across)));
    const double turn = std::floor(2 * across) * std::numbers::pi + phase;
    return round * (0.62 + 0.38 * std::sin(2 * std::numbers::pi * along + turn));
}

std::uint8_t byte(double value)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

} // namespace

FabricMapsPtr wovenFabric(int pixels)
{
    auto maps = std::make_shared<FabricMaps>();
    maps->width = maps->height = pixels;
    maps->widthMm = maps->heightMm = 4;
    maps->sheen = 0.3;
    const auto height = [](double x, double y) {
        return std::max(yarn(x, y, -std::numbers::pi / 2), yarn(y, x, std::numbers::pi / 2));
    };
    const double step = 1.0 / pixels;
    for (int row = 0; row < pixels; ++row)
        for (int column = 0; column < pixels; ++column) {
            const double x = (column + 0.5) * step, y = 1 - (row + 0.5) * step;
            const bool weft = yarn(x, y, -std::numbers::pi / 2) > yarn(y, x, std::numbers::pi / 2);
            const double shade = 0.55 + 0.45 * height(x, y);
            const double red = weft ? 0.72 : 0.50, green = weft ? 0.66 : 0.16, blue = weft ? 0.58 : 0.15;
            for (const double c : {red, green, blue})
                maps->albedo.push_back(byte(shade * c));
            maps->albedo.push_back(255);
            const double slope = 0.25; // mm of height over mm of tile
            const double dx = -slope * (height(x + step, y) - height(x - step, y)) / (2 * step) / 2;
            const double dy = -slope * (height(x, y + step) - height(x, y - step)) / (2 * step) / 2;
            const double length = std::sqrt(dx * dx + dy * dy + 1);
            for (const double c : {dx / length, dy / length, 1 / length})
                maps->normal.push_back(byte(0.5 + 0.5 * c));
            maps->roughness.push_back(byte(0.7));
        }
    return maps;
}

} // namespace bolster::test
