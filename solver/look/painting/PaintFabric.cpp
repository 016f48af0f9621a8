#include "PaintFabric.h"

#include "FabricPattern.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imagebufalgo_util.h>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

using Kind = FabricLook::Kind;

FabricPattern patternOf(const Fabric& fabric, const ImagePixels* image, const BakeOptions& options)
{
    const int pixels = std::clamp(options.pixels, 16, 4096);
    switch (fabric.look.kind) {
    case Kind::Plain:
        break;
    case Kind::Checker:
        return checkerPattern(fabric, pixels);
    case Kind::SmoothLeather:
        return smoothLeatherPattern(fabric, pixels);
    case Kind::GrainedLeather:
        return grainedLeatherPattern(fabric, pixels);
    case Kind::Woven:
        return wovenPattern(fabric, pixels);
    case Kind::Velvet:
        return velvetPattern(fabric, pixels);
    case Kind::Image:
        return imagePattern(fabric, image, pixels, options.threads);
    }
    return plainPattern(fabric);
}

/// Colour as it is written, then roughness, then height in mm.
enum Channel { Red, Green, Blue, Roughness, Height, ChannelCount };

OIIO::ImageBuf painted(const FabricPattern& pattern, int threads)
{
    OIIO::ImageBuf tile(OIIO::ImageSpec(pattern.width, pattern.height, ChannelCount, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::parallel_image(tile.roi(), threads, [&](OIIO::ROI part) {
        for (OIIO::ImageBuf::Iterator<float> pixel(tile, part); !pixel.done(); ++pixel) {
            const Spot at((static_cast<float>(pixel.x()) + 0.5f) / static_cast<float>(pattern.width),
                          1 - (static_cast<float>(pixel.y()) + 0.5f) / static_cast<float>(pattern.height));
            const Texel texel = pattern.texel(at);
            for (int c = 0; c < 3; ++c)
                pixel[c] = toEncoded(texel.color[c]);
            pixel[Roughness] = std::clamp(texel.roughness, 0.f, 1.f);
            pixel[Height] = texel.height;
        }
    });
    return tile;
}

/// Central differences; what leaves the tile on one side comes in on the other.
OIIO::ImageBuf normals(const OIIO::ImageBuf& tile, const FabricPattern& pattern, float relief, int threads)
{
    const int w = pattern.width, h = pattern.height;
    const float perX = relief * static_cast<float>(w / (2 * pattern.widthMm));
    const float perY = relief * static_cast<float>(h / (2 * pattern.heightMm));
    const auto* values = static_cast<const float*>(tile.localpixels());
    OIIO::ImageBuf result(OIIO::ImageSpec(w, h, 3, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::parallel_image(result.roi(), threads, [&](OIIO::ROI part) {
        const auto height = [&](int x, int y) {
            return values[ChannelCount * (static_cast<std::size_t>((y + h) % h) * static_cast<std::size_t>(w) +
                                          static_cast<std::size_t>((x + w) % w)) +
                          Height];
        };
        for (OIIO::ImageBuf::Iterator<float> pixel(result, part); !pixel.done(); ++pixel) {
            const int x = pixel.x(), y = pixel.y();
            const Eigen::Vector3f normal = Eigen::Vector3f(perX * (height(x - 1, y) - height(x + 1, y)),
                                                           perY * (height(x, y + 1) - height(x, y - 1)), 1)
                                               .normalized();
            for (int c = 0; c < 3; ++c)
                pixel[c] = 0.5f + 0.5f * normal[c];
        }
    });
    return result;
}

std::vector<std::uint8_t> bytes(const OIIO::ImageBuf& image, int from, int to)
{
    OIIO::ROI roi = image.roi();
    roi.chbegin = from;
    roi.chend = to;
    std::vector<std::uint8_t> result(static_cast<std::size_t>(roi.npixels()) * static_cast<std::size_t>(to - from));
    image.get_pixels(roi, OIIO::TypeDesc::UINT8, result.data());
    return result;
}

std::vector<std::uint8_t> withOpacity(const std::vector<std::uint8_t>& rgb)
{
    std::vector<std::uint8_t> rgba;
    rgba.reserve(rgb.size() / 3 * 4);
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
        rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 255});
    return rgba;
}

} // namespace

double scaleOf(const Fabric& fabric)
{
    const double scale = fabric.look.scale;
    return std::isfinite(scale) && scale > 0 ? std::clamp(scale, 0.01, 100'000.0)
                                             : usualLook(fabric.look.kind).scale;
}

int repeatsFor(const Fabric& fabric, double size, int least, int most)
{
    return std::clamp(static_cast<int>(std::lround(std::min(1e6, size / scaleOf(fabric)))), least, most);
}

FabricMapsPtr paintedFabric(const Fabric& fabric, const ImagePixels* image, const BakeOptions& options)
{
    const FabricPattern pattern = patternOf(fabric, image, options);
    const OIIO::ImageBuf tile = painted(pattern, options.threads);
    const auto relief = static_cast<float>(std::clamp(fabric.look.relief, 0.0, 2.0));
    const auto maps = std::make_shared<FabricMaps>();
    maps->width = pattern.width;
    maps->height = pattern.height;
    maps->widthMm = pattern.widthMm;
    maps->heightMm = pattern.heightMm;
    maps->sheen = pattern.sheen;
    maps->albedo = withOpacity(bytes(tile, Red, Roughness));
    maps->roughness = bytes(tile, Roughness, Height);
    maps->normal = bytes(normals(tile, pattern, relief, options.threads), 0, 3);
    return maps;
}

} // namespace bolster
