#include "FabricPattern.h"

#include "SeamlessImage.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace bolster {

namespace {

constexpr float depthOfTones = 0.12f; ///< mm that black is deeper than white: shows the threads of a scanned fabric

/// Where a picture is missing: nothing that anybody would take for a fabric.
FabricPattern signForMissing(const Fabric& fabric)
{
    FabricPattern pattern;
    pattern.width = pattern.height = 128;
    pattern.widthMm = pattern.heightMm = scaleOf(fabric);
    pattern.texel = [](const Spot& at) {
        const bool even = (static_cast<int>(8 * at.x()) + static_cast<int>(8 * at.y())) % 2 == 0;
        return Texel{0, even ? Light(0.75f, 0.02f, 0.6f) : Light::Constant(0.25f), 0.9f};
    };
    return pattern;
}

/// The picture in the tile's size, encoded as it is, laid over the fabric's own colour.
OIIO::ImageBuf fitted(const Fabric& fabric, const ImagePixels& image, int width, int height, int threads)
{
    using namespace OIIO;
    ImageSpec spec(image.width, image.height, 4, TypeDesc::UINT8);
    spec.alpha_channel = 3;
    // The buffer only reads the pixels that it is given.
    const ImageBuf given(spec, const_cast<std::uint8_t*>(image.rgba.data()));
    const ImageBuf opaque = ImageBufAlgo::premult(given, {}, threads);
    const ImageBuf small = ImageBufAlgo::resize(opaque, "", 0, ROI(0, width, 0, height, 0, 1, 0, 4), threads);
    ImageBuf result(ImageSpec(width, height, 3, TypeDesc::FLOAT));
    const Light light = lightOf(fabric.color);
    for (ImageBuf::Iterator<float> pixel(result); !pixel.done(); ++pixel) {
        const float under = 1 - std::clamp(small.getchannel(pixel.x(), pixel.y(), 0, 3), 0.f, 1.f);
        for (int c = 0; c < 3; ++c)
            pixel[c] = small.getchannel(pixel.x(), pixel.y(), 0, c) + under * toEncoded(light[c]);
    }
    return result;
}

} // namespace

FabricPattern imagePattern(const Fabric& fabric, const ImagePixels* image, int pixels, int threads)
{
    if (!image || !image->complete())
        return signForMissing(fabric);
    const int longer = std::max(image->width, image->height);
    const double shrunk = std::min(1.0, static_cast<double>(pixels) / longer);
    FabricPattern pattern;
    pattern.width = std::max(4, static_cast<int>(std::lround(shrunk * image->width)));
    pattern.height = std::max(4, static_cast<int>(std::lround(shrunk * image->height)));
    pattern.widthMm = scaleOf(fabric);
    pattern.heightMm = pattern.widthMm * image->height / image->width;

    const auto tile =
        std::make_shared<OIIO::ImageBuf>(fitted(fabric, *image, pattern.width, pattern.height, threads));
    makeSeamless(*tile);
    const auto roughness = static_cast<float>(std::clamp(fabric.look.roughness, 0.0, 1.0));
    const int width = pattern.width, height = pattern.height;
    pattern.texel = [tile, roughness, width, height](const Spot& at) {
        const int x = std::clamp(static_cast<int>(at.x() * static_cast<float>(width)), 0, width - 1);
        const int y = std::clamp(static_cast<int>((1 - at.y()) * static_cast<float>(height)), 0, height - 1);
        float encoded[3];
        tile->getpixel(x, y, encoded, 3);
        Texel texel;
        for (int c = 0; c < 3; ++c)
            texel.color[c] = toLinear(std::clamp(encoded[c], 0.f, 1.f));
        texel.height = depthOfTones * toEncoded(luminance(texel.color));
        texel.roughness = roughness;
        return texel;
    };
    return pattern;
}

} // namespace bolster
