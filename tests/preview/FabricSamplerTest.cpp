// What becomes of a fabric's maps where they are seen from afar.
#include "FabricSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {
namespace {

/// Soft stripes, `count` of them on a tile of 256 mm and as many pixels.
FabricMaps stripes(int count)
{
    FabricMaps maps;
    maps.width = maps.height = 256;
    maps.widthMm = maps.heightMm = 256;
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            const double turns = count * (x + 0.5) / maps.width; // smooth: steps would beat with the pixels
            const auto shade =
                static_cast<std::uint8_t>(std::lround(140 + 80 * std::sin(2 * std::numbers::pi * turns)));
            maps.albedo.insert(maps.albedo.end(), {shade, shade, shade});
            maps.albedo.push_back(255);
            maps.normal.insert(maps.normal.end(), {128, 128, 255});
            maps.roughness.push_back(200);
        }
    return maps;
}

/// How much the brightness of pixels of this size differs across the tile, of its mean.
float unrest(const FabricSampler& sampler, float pixel)
{
    float least = 1e9F, most = 0, sum = 0;
    constexpr int count = 400;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector2f at(256.F * static_cast<float>(i) / count, 100);
        const float seen = sampler.at(at, {pixel, 0}, {0, pixel}).color.x();
        least = std::min(least, seen);
        most = std::max(most, seen);
        sum += seen / count;
    }
    return (most - least) / sum;
}

TEST(FabricSampler, AWeaveFadesToItsMeanBeforeItBeats)
{
    for (const int repeats : {37, 45, 53}) { // they never fit the texels of mip-maps
        const FabricSampler sampler(stripes(repeats));
        const float repeat = 256.F / static_cast<float>(repeats);
        EXPECT_GT(unrest(sampler, repeat / 8), 0.5F) << "near by it is there";
        EXPECT_LT(unrest(sampler, repeat / 1.2F), 0.2F);
        EXPECT_LT(unrest(sampler, 1.5F * repeat), 0.04F);
        EXPECT_LT(unrest(sampler, 3 * repeat), 0.02F);
    }
}

} // namespace
} // namespace bolster
