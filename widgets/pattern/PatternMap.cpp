#include "PatternMap.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double finest = 2;          // mm per pixel
constexpr double mostMapPixels = 400; // along a patch

/// Colours between the corners, where the pixel's middle lies inside.
void fillTriangle(QImage& image, const std::array<Vec2, 3>& at, const std::array<ShownMap::Rgba, 3>& colors)
{
    Box2 box;
    for (const Vec2& p : at)
        box.extend(p);
    const Vec2 u = at[1] - at[0], v = at[2] - at[0];
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0)
        return;
    constexpr double slack = -0.02; // so that no line of pixels is left between triangles
    for (int y = std::max(0, static_cast<int>(box.min().y()));
         y <= std::min<double>(image.height() - 1, box.max().y()); ++y)
        for (int x = std::max(0, static_cast<int>(box.min().x()));
             x <= std::min<double>(image.width() - 1, box.max().x()); ++x) {
            const Vec2 p = Vec2(x + 0.5, y + 0.5) - at[0];
            const double b = (p.x() * v.y() - p.y() * v.x()) / area, c = (u.x() * p.y() - u.y() * p.x()) / area;
            const std::array<double, 3> weights = {1 - b - c, b, c};
            if (*std::min_element(weights.begin(), weights.end()) < slack)
                continue;
            std::array<double, 4> sum{};
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t channel = 0; channel < 4; ++channel)
                    sum[channel] += weights[k] * colors[k][channel];
            const auto byte = [&](std::size_t channel) {
                return static_cast<int>(std::clamp(std::lround(sum[channel]), 0L, 255L));
            };
            image.setPixel(x, y, qRgba(byte(0), byte(1), byte(2), byte(3)));
        }
}

} // namespace

void PatternMap::setMap(ShownMapPtr map)
{
    m_map = std::move(map);
    m_pictures.clear();
    if (!m_map)
        return;
    m_colors = m_map->colors();
    for (const SurfaceTopology::PatchRange& range : m_map->topology->patches)
        m_pictures.emplace(range.patch, paint(range));
}

const PatternMap::Picture* PatternMap::picture(ElementId patch) const
{
    const auto found = m_pictures.find(patch);
    return found == m_pictures.end() ? nullptr : &found->second;
}

PatternMap::Picture PatternMap::paint(const SurfaceTopology::PatchRange& range) const
{
    const SurfaceTopology& topology = *m_map->topology;
    Box2 box;
    for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
        box.extend(topology.pattern[v]);
    const double pixel = std::max(finest, box.sizes().maxCoeff() / mostMapPixels);
    const Vec2 size = (box.sizes() / pixel).array().ceil().max(1);
    Picture picture{QImage(static_cast<int>(size.x()), static_cast<int>(size.y()), QImage::Format_ARGB32),
                    QRectF(box.min().x(), box.min().y(), size.x() * pixel, size.y() * pixel)};
    picture.image.fill(Qt::transparent);
    for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
        std::array<Vec2, 3> at;
        std::array<ShownMap::Rgba, 3> colors;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = topology.triangles[t][k];
            at[k] = (topology.pattern[v] - box.min()) / pixel;
            colors[k] = m_colors[v];
        }
        fillTriangle(picture.image, at, colors);
    }
    return picture;
}

} // namespace bolster
