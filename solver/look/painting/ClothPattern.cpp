#include "FabricPattern.h"

#include "FabricColors.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr float tau = 6.2831853f;

float roughnessOf(const Fabric& fabric)
{
    return static_cast<float>(std::clamp(fabric.look.roughness, 0.0, 1.0));
}

/// A yarn where it passes a place.
struct Yarn {
    float height; ///< 0 to 1
    float round;  ///< 0 at its borders, 1 in the middle
    float shade;  ///< factor of its colour
};

/// `across`: yarns from the border of the tile on; `along`: crossings from there on, in which it is over and under
/// in turn. `period`: yarns in the tile.
Yarn yarnAt(float across, float along, int period, std::uint32_t seed)
{
    // Spun by hand or machine, no yarn is straight or even.
    const int slubs = std::max(1, period / 3);
    const Spot unit(across / static_cast<float>(period), along / static_cast<float>(period));
    across += 0.13f * fractalAt(unit, {period / 2, period / 2}, 2, seed);
    const float number = std::floor(across);
    const int index = ((static_cast<int>(number) % period) + period) % period;
    const float spun = randomAt(index, 0, seed + 1);
    const float thick =
        0.47f * (0.93f + 0.07f * noiseAt(Spot(0.5f, unit.y() * static_cast<float>(slubs)), {1, slubs},
                                         seed + 100u + static_cast<std::uint32_t>(index)));
    const float side = (across - number - 0.5f) / thick;

    Yarn yarn{};
    yarn.round = std::sqrt(std::max(0.f, 1 - side * side));
    const float over = 0.5f + 0.5f * std::cos(0.5f * tau * (along - 0.5f - number));
    // Fibres lie slanting, as the yarn was twisted; ply lines in a lighter rhythm.
    const float twist = std::cos(tau * (3.f * along + 0.55f * side + spun));
    const float fibre = fractalAt(unit, {6 * period, 2 * period}, 2, seed + 2);
    yarn.height = 0.62f * over + 0.38f * yarn.round + 0.05f * twist * yarn.round + 0.10f * fibre;
    yarn.shade = (0.84f + 0.32f * spun) * (1 + 0.10f * twist + 0.34f * fibre) * (0.55f + 0.45f * yarn.round) *
                 (0.62f + 0.38f * over);
    if (yarn.round <= 0)
        yarn.height = -0.3f;
    return yarn;
}

} // namespace

FabricPattern plainPattern(const Fabric& fabric)
{
    FabricPattern pattern;
    Texel texel;
    texel.color = lightOf(fabric.color);
    texel.roughness = roughnessOf(fabric);
    pattern.texel = [texel](const Spot&) { return texel; };
    return pattern;
}

FabricPattern checkerPattern(const Fabric& fabric, int pixels)
{
    FabricPattern pattern;
    pattern.width = pattern.height = std::max(2, pixels / 2) / 2 * 2; // squares end where pixels do
    pattern.widthMm = pattern.heightMm = 2 * scaleOf(fabric);
    const Light one = lightOf(fabric.color), other = lightOf(secondColorShown(fabric));
    const float roughness = roughnessOf(fabric);
    pattern.texel = [=](const Spot& at) {
        return Texel{0, (at.x() < 0.5f) == (at.y() < 0.5f) ? one : other, roughness};
    };
    return pattern;
}

FabricPattern wovenPattern(const Fabric& fabric, int pixels)
{
    const int yarns = 2 * repeatsFor(fabric, 90, 4, 42);
    const auto scale = static_cast<float>(scaleOf(fabric));
    const Light warp = lightOf(fabric.color), weft = lightOf(secondColorShown(fabric));
    const float roughness = roughnessOf(fabric);
    FabricPattern pattern;
    pattern.width = pattern.height = pixels;
    pattern.widthMm = pattern.heightMm = 0.5 * yarns * scale;
    pattern.sheen = 0.35;
    pattern.texel = [=](const Spot& at) {
        const auto n = static_cast<float>(yarns);
        const Yarn up = yarnAt(at.x() * n, at.y() * n, yarns, 41);
        const Yarn across = yarnAt(at.y() * n, at.x() * n + 1, yarns, 57);
        const bool warpOver = up.height >= across.height;
        const Yarn& over = warpOver ? up : across;
        const float top = std::max(over.height, 0.05f);
        // Into the holes between the yarns little light falls.
        const float seen = 0.25f + 0.75f * ramp(0.05f, 0.65f, top);
        Texel texel;
        texel.height = 0.16f * scale * top;
        texel.color = (warpOver ? warp : weft) * (1.18f * over.shade * seen);
        texel.roughness = roughness;
        return texel;
    };
    return pattern;
}

FabricPattern velvetPattern(const Fabric& fabric, int pixels)
{
    const int naps = repeatsFor(fabric, 120, 6, 60);
    const auto scale = static_cast<float>(scaleOf(fabric));
    const Light pile = lightOf(fabric.color), depth = lightOf(secondColorShown(fabric));
    const float roughness = roughnessOf(fabric);
    FabricPattern pattern;
    pattern.width = pattern.height = pixels;
    pattern.widthMm = pattern.heightMm = static_cast<double>(naps) * scale;
    pattern.sheen = 1;
    pattern.texel = [=](const Spot& at) {
        // Hands and seats have stroked the pile this way and that; the fibres' ends are finer than the maps.
        const float stroked = fractalAt(at, {naps / 2, naps / 4}, 3, 71);
        const float far = fractalAt(at, {4, 3}, 3, 72);
        const float tuft = fractalAt(at, {8 * naps, 5 * naps}, 1, 73);
        const float fibre = fractalAt(at, {17 * naps, 11 * naps}, 1, 74);
        const float lit =
            std::clamp(0.60f + 0.34f * stroked + 0.20f * far + 0.26f * tuft + 0.20f * fibre, 0.f, 1.f);
        Texel texel;
        texel.height = 0.035f * scale * (stroked + 0.6f * far) + 0.05f * tuft + 0.025f * fibre;
        texel.color = depth + lit * (1.1f * pile - depth);
        texel.roughness = roughness + 0.05f * tuft;
        return texel;
    };
    return pattern;
}

} // namespace bolster
