#include "FabricPattern.h"

#include "FabricColors.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double tileSize = 125; ///< mm: large enough that the eye finds no repeat on a seat

struct Leather {
    int cells;   ///< across the tile
    float grain; ///< from crease to crease, mm
    Light color;
    Light crease;
    float roughness;
};

Leather leatherOf(const Fabric& fabric, int most)
{
    Leather leather{};
    leather.cells = repeatsFor(fabric, tileSize, 12, most);
    leather.grain = static_cast<float>(scaleOf(fabric));
    leather.color = lightOf(fabric.color);
    leather.crease = lightOf(secondColorShown(fabric));
    leather.roughness = static_cast<float>(std::clamp(fabric.look.roughness, 0.0, 1.0));
    return leather;
}

FabricPattern leatherTile(const Leather& leather, int pixels)
{
    FabricPattern pattern;
    pattern.width = pattern.height = pixels;
    pattern.widthMm = pattern.heightMm = static_cast<double>(leather.cells) * leather.grain;
    return pattern;
}

Eigen::Vector2i every(int period)
{
    return Eigen::Vector2i::Constant(std::max(1, period));
}

/// Nothing that has grown is regular: the lattice is bent, far and near.
Spot bent(const Spot& at, int cells, float far, float near)
{
    const auto bend = [&](int period, int octaves, std::uint32_t seed) {
        return Spot(fractalAt(at, every(period), octaves, seed), fractalAt(at, every(period), octaves, seed + 31));
    };
    return at * static_cast<float>(cells) + far * bend(cells / 7, 2, 5) + near * bend((2 * cells) / 3, 2, 6);
}

/// Tanned skins are a little darker here and lighter there.
float cloudy(const Spot& at, float strength)
{
    return 1 + strength * fractalAt(at, every(4), 3, 11);
}

/// Grain as embossed or shrunken leather has it: rounded pebbles of unequal size, creases of unequal depth between.
Texel grained(const Leather& leather, const Spot& at)
{
    const int n = leather.cells;
    const Cell pebble = cellAt(bent(at, n, 1.1f, 0.24f), n, 0.85f, 1);
    const float uneven = 0.5f + 0.5f * fractalAt(at, every(n / 3), 2, 8);
    const float dome = std::sqrt(std::min(1.f, pebble.inside() / 0.44f)); // steep where pebbles meet
    const float round = dome * (2 - dome);
    const float groove = 1 - ramp(0, 0.08f + 0.08f * uneven, pebble.inside());

    // Finer folds run over the pebbles, more in some places than in others.
    const int fine = (5 * n) / 2;
    const Cell fold = cellAt(bent(at, fine, 1.2f, 0.5f), fine, 1.f, 2);
    const float folded = ramp(0.3f, 0.8f, 0.5f + 0.5f * fractalAt(at, every(n / 4), 2, 9));
    const float crinkle = (1 - ramp(0, 0.12f, fold.inside())) * folded;
    const float skin = fractalAt(at, every(5 * n), 2, 3);

    Texel texel;
    texel.height = leather.grain * (0.075f * round * (0.6f + 0.4f * pebble.random) * (0.65f + 0.35f * uneven) -
                                    0.007f * groove - 0.008f * crinkle + 0.002f * skin);
    const float bright = cloudy(at, 0.05f) * (0.97f + 0.06f * pebble.random) * (1 + 0.025f * skin);
    const float shown = 0.62f + 0.38f * round - (0.30f + 0.25f * uneven) * groove - 0.14f * crinkle;
    texel.color = bright * (leather.crease + std::clamp(shown, 0.f, 1.f) * (leather.color - leather.crease));
    texel.roughness = leather.roughness + 0.12f * groove + 0.05f * crinkle - 0.06f * round + 0.03f * skin;
    return texel;
}

/// Smooth (nappa): tiny facets hardly deeper than the eye sees, pores in groups, and soft waves.
Texel smooth(const Leather& leather, const Spot& at)
{
    const int n = leather.cells;
    const Cell facet = cellAt(bent(at, n, 1.8f, 0.6f), n, 1.f, 21);
    const float lively = ramp(-0.5f, 0.6f, fractalAt(at, every(n / 9), 2, 22));
    const float groove = 1 - ramp(0, 0.16f, facet.inside());
    const Cell hair = cellAt(bent(at, (3 * n) / 4, 1.2f, 0.2f), (3 * n) / 4, 1.f, 23);
    const float here = ramp(0.35f, 0.6f, hair.random + 0.35f * fractalAt(at, every(n / 8), 2, 24));
    const float pore = here * std::exp(-hair.nearest * hair.nearest / 0.022f);
    const float skin = fractalAt(at, every(3 * n), 2, 25);
    const float wave = fractalAt(at, every(9), 2, 26);

    Texel texel;
    const float mm = std::min(leather.grain, 4.f);
    texel.height =
        mm * (-0.017f * groove * (0.35f + 0.65f * lively) - 0.030f * pore + 0.0035f * skin) + 0.05f * wave;
    const float bright = cloudy(at, 0.045f) * (0.985f + 0.03f * facet.random) * (1 + 0.02f * skin);
    texel.color =
        bright * (leather.color + std::clamp(0.3f * groove * (0.3f + 0.7f * lively) + 0.35f * pore, 0.f, 1.f) *
                                      (leather.crease - leather.color));
    texel.roughness = leather.roughness + 0.06f * groove + 0.12f * pore + 0.035f * skin + 0.03f * wave;
    return texel;
}

} // namespace

FabricPattern smoothLeatherPattern(const Fabric& fabric, int pixels)
{
    const Leather leather = leatherOf(fabric, 84);
    FabricPattern pattern = leatherTile(leather, pixels);
    pattern.texel = [leather](const Spot& at) { return smooth(leather, at); };
    return pattern;
}

FabricPattern grainedLeatherPattern(const Fabric& fabric, int pixels)
{
    const Leather leather = leatherOf(fabric, 64);
    FabricPattern pattern = leatherTile(leather, pixels);
    pattern.texel = [leather](const Spot& at) { return grained(leather, at); };
    return pattern;
}

} // namespace bolster
