#include "ModelPictures.h"

#include "Imaging.h"
#include "Srgb.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bolster {

namespace {

/// Bytes of three channels, rows from the top down.
struct Channels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;
};

std::string encodedChannels(const Channels& picture, bool jpeg, bool srgb)
{
    EncodeOrder order;
    order.format = jpeg ? "jpeg" : "png";
    order.width = picture.width;
    order.height = picture.height;
    order.channels = 3;
    order.bytes = picture.bytes.data();
    if (jpeg) {
        order.words = {{"Compression", "jpeg:90"},
                       {"jpeg:subsampling", "4:4:4"}}; // what is no colour must not be blurred like one
    } else if (srgb) {
        order.words = {{"oiio:ColorSpace", "sRGB"}};
    }
    std::string problem;
    std::string bytes = imaging().encode(order, problem);
    if (bytes.empty())
        throw std::runtime_error(problem);
    return bytes;
}

/// Means of 2 x 2; of an odd number the last ones are left as they are.
FabricMaps halved(const FabricMaps& maps)
{
    FabricMaps half = maps;
    half.width = std::max(1, maps.width / 2);
    half.height = std::max(1, maps.height / 2);
    const auto shrink = [&](const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to, int channels) {
        to.clear();
        for (int y = 0; y < half.height; ++y)
            for (int x = 0; x < half.width; ++x)
                for (int c = 0; c < channels; ++c) {
                    int sum = 2;
                    for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
                        const int at = std::min(2 * y + dy, maps.height - 1) * maps.width +
                                       std::min(2 * x + dx, maps.width - 1);
                        sum += from[static_cast<std::size_t>(at) * static_cast<std::size_t>(channels) +
                                    static_cast<std::size_t>(c)];
                    }
                    to.push_back(static_cast<std::uint8_t>(sum / 4));
                }
    };
    shrink(maps.albedo, half.albedo, 4);
    shrink(maps.normal, half.normal, 3);
    shrink(maps.roughness, half.roughness, 1);
    return half;
}

Channels opaqueColor(const FabricMaps& maps, const Eigen::Vector3f& behind)
{
    Channels picture{maps.width, maps.height, {}};
    picture.bytes.reserve(maps.roughness.size() * 3);
    for (std::size_t p = 0; p < maps.roughness.size(); ++p) {
        const float opacity = static_cast<float>(maps.albedo[4 * p + 3]) / 255;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint8_t own = maps.albedo[4 * p + c];
            const float light = opacity * linearFromSrgb(own) + (1 - opacity) * behind[static_cast<int>(c)];
            picture.bytes.push_back(opacity >= 1 ? own
                                                 : static_cast<std::uint8_t>(std::lround(
                                                       255 * srgbFromLinear(std::clamp(light, 0.F, 1.F)))));
        }
    }
    return picture;
}

bool isFlat(const FabricMaps& maps)
{
    constexpr int level = 2; // of 255, what rounding does to a slope of 0
    for (std::size_t p = 0; p < maps.roughness.size(); ++p)
        if (std::abs(maps.normal[3 * p] - 128) > level || std::abs(maps.normal[3 * p + 1] - 128) > level)
            return false;
    return true;
}

/// Of unit length again, as readers want them.
Channels unitNormals(const FabricMaps& maps)
{
    Channels picture{maps.width, maps.height, {}};
    picture.bytes.reserve(maps.normal.size());
    for (std::size_t p = 0; p < maps.roughness.size(); ++p) {
        Eigen::Vector3f n(maps.normal[3 * p], maps.normal[3 * p + 1], maps.normal[3 * p + 2]);
        n = n / 127.5F - Eigen::Vector3f::Ones();
        n = n.z() > 0.01F ? Eigen::Vector3f(n.normalized()) : Eigen::Vector3f::UnitZ();
        for (int c = 0; c < 3; ++c)
            picture.bytes.push_back(static_cast<std::uint8_t>(std::lround(127.5F * (n[c] + 1))));
    }
    return picture;
}

Channels greyRoughness(const FabricMaps& maps)
{
    Channels picture{maps.width, maps.height, {}};
    picture.bytes.reserve(maps.roughness.size() * 3);
    for (const std::uint8_t rough : maps.roughness)
        picture.bytes.insert(picture.bytes.end(), 3, rough);
    return picture;
}

ModelPicture pictureOf(const Channels& channels, const std::string& name, bool jpeg, bool srgb)
{
    return {name + (jpeg ? ".jpg" : ".png"), encodedChannels(channels, jpeg, srgb), jpeg};
}

} // namespace

FabricPicturesOf fabricPictures(const FabricMaps& maps, const Eigen::Vector3f& behind, const std::string& name,
                                const PictureKind& kind)
{
    if (std::max(maps.width, maps.height) > std::max(kind.mostPixels, 16))
        return fabricPictures(halved(maps), behind, name, kind);
    FabricPicturesOf pictures;
    pictures.color = pictureOf(opaqueColor(maps, behind), name + "-color", true, true);
    if (!isFlat(maps))
        pictures.normal = pictureOf(unitNormals(maps), name + "-normal", kind.small, false);
    const auto [least, most] = std::ranges::minmax_element(maps.roughness);
    if (*most - *least > 3)
        pictures.roughness = pictureOf(greyRoughness(maps), name + "-roughness", true, false);
    else
        pictures.rough = static_cast<float>(*least + *most) / 510;
    return pictures;
}

} // namespace bolster
