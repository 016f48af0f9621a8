#include "PictureTile.h"

#include <algorithm>
#include <cmath>

namespace bolster {

PictureTile::PictureTile(int x, int y, int pictureWidth, int pictureHeight)
    : m_left(std::max(0, x - margin))
    , m_top(std::max(0, y - margin))
    , m_width(std::min(pictureWidth, x + size + margin) - m_left)
    , m_height(std::min(pictureHeight, y + size + margin) - m_top)
    , m_pixels(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height))
{}

Eigen::Vector4f PictureTile::lit(const PicturePixel& pixel, float key, float sky)
{
    const Vec3f light = pixel.constant + key * pixel.direct + sky * pixel.ambient;
    return {light.x(), light.y(), light.z(), pixel.through.dot(Vec3f(1, key, sky))};
}

Eigen::Vector4f PictureTile::resolved(int x, int y, float pixelSize) const
{
    const PicturePixel& here = at(x, y);
    if (here.direct.isZero() && here.ambient.isZero() && here.through.tail<2>().isZero())
        return lit(here, 1, 1);

    // The directions of the shadow rays repeat every eight pixels; these weights count each of the eight alike.
    static constexpr float window[2 * margin + 1] = {0.5f, 1.f, 1.f, 1.f, 1.f, 1.f, 1.f, 1.f, 0.5f};
    const float tolerance = 2.f * pixelSize;
    float key = 0, keyWeight = 0, sky = 0, skyWeight = 0;
    for (int j = std::max(m_top, y - margin); j <= std::min(bottom() - 1, y + margin); ++j)
        for (int i = std::max(m_left, x - margin); i <= std::min(right() - 1, x + margin); ++i) {
            const PicturePixel& there = at(i, j);
            const float alike = there.normal.dot(here.normal);
            if (alike < 0.7f)
                continue;
            const float off = (there.position - here.position).dot(here.normal) / tolerance;
            const float weight =
                window[i - x + margin] * window[j - y + margin] * alike * alike / (1.f + off * off);
            key += weight * there.keySeen;
            keyWeight += weight * there.keyAsked;
            sky += weight * there.skySeen;
            skyWeight += weight * there.skyAsked;
        }
    const float keyShare = keyWeight > 0 ? key / keyWeight : 1.f;
    const float skyShare = skyWeight > 0 ? sky / skyWeight : 1.f;
    return lit(here, keyShare, skyShare);
}

} // namespace bolster
