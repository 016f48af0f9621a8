#include "FabricSampler.h"

#include "MipTaps.h"
#include "Shading.h"
#include "Srgb.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr float steepest = 2;   // of a normal's lean
constexpr float mostProbes = 8; // along the longer side of a pixel

using Texel = std::array<std::uint16_t, 8>;
using Numbers = Eigen::Array<float, 8, 1>;

/// What 0 and 65535 stand for.
const Numbers lowest = (Numbers() << 0, 0, 0, 0, -steepest, -steepest, 0, 0).finished();
const Numbers range = (Numbers() << 1, 1, 1, 1, 2 * steepest, 2 * steepest, 2 * steepest * steepest, 1).finished();

Texel stored(const Numbers& numbers)
{
    const Numbers share = ((numbers - lowest) / range).max(0.F).min(1.F);
    Texel texel{};
    for (std::size_t i = 0; i < texel.size(); ++i)
        texel[i] = static_cast<std::uint16_t>(std::lround(65535 * share[static_cast<Eigen::Index>(i)]));
    return texel;
}

Numbers shares(const Texel& texel)
{
    return Eigen::Map<const Eigen::Array<std::uint16_t, 8, 1>>(texel.data()).cast<float>() * (1.F / 65535);
}

Numbers read(const Texel& texel)
{
    return lowest + range * shares(texel);
}

int wrapped(int i, int count)
{
    i %= count;
    return i < 0 ? i + count : i;
}

} // namespace

FabricSampler::FabricSampler(const FabricMaps& maps)
    : m_size(static_cast<float>(maps.widthMm), static_cast<float>(maps.heightMm))
    , m_texelsPerMm(static_cast<float>(maps.width) / m_size.x(), static_cast<float>(maps.height) / m_size.y())
{
    m_levels.push_back(finest(maps));
    while (m_levels.back().width > 1 || m_levels.back().height > 1)
        m_levels.push_back(half(m_levels.back()));
}

FabricSampler::Level FabricSampler::finest(const FabricMaps& maps)
{
    Level level{maps.width, maps.height, {}};
    level.texels.reserve(maps.roughness.size());
    for (int row = maps.height - 1; row >= 0; --row)
        for (int column = 0; column < maps.width; ++column) {
            const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(maps.width) +
                                   static_cast<std::size_t>(column);
            const float opacity = static_cast<float>(maps.albedo[4 * at + 3]) / 255;
            const auto color = [&](std::size_t c) { return opacity * linearFromSrgb(maps.albedo[4 * at + c]); };
            const auto normal = [&](std::size_t c) {
                return static_cast<float>(maps.normal[3 * at + c]) / 127.5F - 1;
            };
            const float up = std::max(0.2F, normal(2));
            const float x = std::clamp(normal(0) / up, -steepest, steepest);
            const float y = std::clamp(normal(1) / up, -steepest, steepest);
            const float rough = static_cast<float>(maps.roughness[at]) / 255;
            const float alpha2 = rough * rough * rough * rough;
            level.texels.push_back(stored(
                (Numbers() << color(0), color(1), color(2), opacity, x, y, x * x + y * y, alpha2).finished()));
        }
    return level;
}

FabricSampler::Level FabricSampler::half(const Level& finer)
{
    Level level{std::max(1, finer.width / 2), std::max(1, finer.height / 2), {}};
    for (int row = 0; row < level.height; ++row)
        for (int column = 0; column < level.width; ++column) {
            Numbers sum = Numbers::Zero();
            eachMipTap(row, level.height, finer.height, [&](int y, float part) {
                eachMipTap(column, level.width, finer.width, [&](int x, float share) {
                    sum += part * share *
                           read(finer.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(finer.width) +
                                             static_cast<std::size_t>(x)]);
                });
            });
            level.texels.push_back(stored(sum));
        }
    return level;
}

FabricSampler::Numbers FabricSampler::bilinear(const Level& level, const Eigen::Vector2f& share)
{
    const float x = share.x() * static_cast<float>(level.width) - 0.5F;
    const float y = share.y() * static_cast<float>(level.height) - 0.5F;
    const float left = std::floor(x), below = std::floor(y);
    const int x0 = wrapped(static_cast<int>(left), level.width), x1 = wrapped(x0 + 1, level.width);
    const int y0 = wrapped(static_cast<int>(below), level.height), y1 = wrapped(y0 + 1, level.height);
    const auto texel = [&](int column, int row) {
        return shares(level.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
                                   static_cast<std::size_t>(column)]);
    };
    const float tx = x - left, ty = y - below;
    return (1 - ty) * ((1 - tx) * texel(x0, y0) + tx * texel(x1, y0)) +
           ty * ((1 - tx) * texel(x0, y1) + tx * texel(x1, y1));
}

FabricSampler::Numbers FabricSampler::trilinear(float level, const Eigen::Vector2f& share) const
{
    const Eigen::Vector2f inside = share - Eigen::Vector2f(share.array().floor());
    level = std::clamp(level, 0.F, static_cast<float>(m_levels.size() - 1));
    const auto finer = std::min(static_cast<std::size_t>(level), m_levels.size() - 1);
    const float part = level - static_cast<float>(finer);
    if (part < 1e-3F)
        return bilinear(m_levels[finer], inside);
    return (1 - part) * bilinear(m_levels[finer], inside) + part * bilinear(m_levels[finer + 1], inside);
}

FabricSampler::Sample FabricSampler::at(const Eigen::Vector2f& place, const Eigen::Vector2f& right,
                                        const Eigen::Vector2f& up) const
{
    const Eigen::Vector2f share = place.cwiseQuotient(m_size);
    Numbers sum = Numbers::Zero();
    const Eigen::Vector2f a = right.cwiseProduct(m_texelsPerMm), b = up.cwiseProduct(m_texelsPerMm); // in texels
    if (!share.allFinite() || !a.allFinite() || !b.allFinite()) {
        sum = bilinear(m_levels.back(), Eigen::Vector2f::Zero());
    } else {
        const bool wide = a.squaredNorm() > b.squaredNorm();
        const float longer = std::max(1e-6F, (wide ? a : b).norm());
        const float shorter = std::abs(a.x() * b.y() - a.y() * b.x()) / longer;
        const float step = std::max({shorter, longer / mostProbes, 1e-6F});
        const int probes = std::clamp(static_cast<int>(std::ceil(longer / std::max(step, 1.F))), 1, 8);
        const Eigen::Vector2f along = (wide ? right : up).cwiseQuotient(m_size);
        const float level = std::log2(std::max(step, 1e-3F));
        for (int i = 0; i < probes; ++i)
            sum += trilinear(level,
                             share + ((static_cast<float>(i) + 0.5F) / static_cast<float>(probes) - 0.5F) * along);
        sum /= static_cast<float>(probes);
    }
    const Numbers numbers = lowest + range * sum;
    Sample sample;
    sample.color = numbers.head<3>();
    sample.opacity = numbers[3];
    sample.lean = numbers.segment<2>(4);
    const float spread = std::max(0.F, numbers[6] - sample.lean.squaredNorm());
    sample.roughness = shading::roughened(numbers[7], spread);
    return sample;
}

} // namespace bolster
