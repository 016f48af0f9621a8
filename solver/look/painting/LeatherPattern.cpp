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

/// A crease with a round bottom and soft shoulders: 1 where pebbles meet.
float crease(const Cell& pebble, float width)
{
    const float away = pebble.inside() / width;
    return std::exp(-away * away);
}

/// Full grain: soft pebbles of unequal size in shallow creases that come and go. Where a crease fades, two pebbles
/// are one; finer creases part others. So no net of even lines arises, which would look like dried mud.
Texel grained(const Leather& leather, const Spot& at)
{
    const int n = leather.cells, fine = (9 * n) / 5;
    const Cell pebble = cellAt(bent(at, n, 1.1f, 0.3f), n, 1.f, 1);
    const Cell small = cellAt(bent(at, fine, 1.6f, 0.4f), fine, 1.f, 2);
    const float deep = 0.38f + 0.62f * ramp(-0.45f, 0.35f, fractalAt(at, every((2 * n) / 3), 2, 8));
    const float parted = 0.85f * ramp(-0.25f, 0.5f, fractalAt(at, every(n / 3), 3, 9));
    const float wide = deep * crease(pebble, 0.10f + 0.07f * deep), narrow = parted * crease(small, 0.15f);
    const float folded = std::max(wide, 0.7f * narrow) + 0.3f * std::min(wide, 0.7f * narrow);
    const float dome = 1 - std::min(1.f, 0.8f * pebble.nearest * pebble.nearest);
    const float lump = fractalAt(at, every((3 * n) / 2), 2, 7);
    const float skin = fractalAt(at, every(5 * n), 2, 3);

    Texel texel;
    texel.height = leather.grain * (-0.042f * folded + 0.020f * dome + 0.006f * lump + 0.0012f * skin);
    const float bright = cloudy(at, 0.045f) * (0.985f + 0.03f * pebble.random) * (1 + 0.02f * skin);
    const float shown = std::min(1.f, 0.42f * folded * folded);
    texel.color = bright * (leather.color + shown * (leather.crease - leather.color));
    texel.roughness = leather.roughness + 0.10f * folded - 0.04f * dome + 0.03f * skin;
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
