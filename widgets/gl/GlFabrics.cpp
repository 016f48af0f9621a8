#include "GlFabrics.h"

#include "LinearLight.h"
#include "MipTaps.h"

#include <QByteArrayView>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

/// How much is seen of a fabric where nothing moves.
struct Sharpness {
    float anisotropy;
    float bias; ///< levels of detail
};

/// Mesa's drivers that do without a graphics card walk over all texels that an anisotropic footprint spans: some
/// hundred million where the pixels beside a triangle seen from its edge lie behind the eye, for minutes. There the
/// many places within a pixel, which a picture at rest is the mean of, must do.
Sharpness finest()
{
    const auto* name =
        reinterpret_cast<const char*>(QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER));
    const QByteArrayView renderer(name);
    const bool software = renderer.contains("llvmpipe") || renderer.contains("softpipe");
    return software ? Sharpness{1, -1} : Sharpness{8, 0};
}

/// Colours are averaged as light.
struct MipLevel {
    int width = 0, height = 0;
    std::vector<Eigen::Array4f> texels;
};

MipLevel halfOf(const MipLevel& finer)
{
    const auto at = [](const auto& texels, int width, int x, int y) -> auto&
    {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    };
    MipLevel half{std::max(1, finer.width / 2), std::max(1, finer.height / 2), {}};
    std::vector<Eigen::Array4f> narrow; // first along the rows, then down them
    for (int y = 0; y < finer.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            narrow.emplace_back(Eigen::Array4f::Zero());
            eachMipTap(x, half.width, finer.width,
                       [&](int i, float share) { narrow.back() += share * at(finer.texels, finer.width, i, y); });
        }
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            half.texels.emplace_back(Eigen::Array4f::Zero());
            eachMipTap(y, half.height, finer.height,
                       [&](int i, float share) { half.texels.back() += share * at(narrow, half.width, x, i); });
        }
    return half;
}

MipLevel finestOf(const FabricMaps& maps, const std::vector<std::uint8_t>& rgba, bool colors)
{
    MipLevel level{maps.width, maps.height, {}};
    level.texels.reserve(rgba.size() / 4);
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = colors ? toLinear(static_cast<float>(i) / 255) : static_cast<float>(i) / 255;
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
        level.texels.emplace_back(light[rgba[i]], light[rgba[i + 1]], light[rgba[i + 2]],
                                  static_cast<float>(rgba[i + 3]) / 255);
    return level;
}

std::vector<std::uint8_t> bytesOf(const MipLevel& level, bool colors)
{
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * level.texels.size());
    for (const Eigen::Array4f& texel : level.texels)
        for (Eigen::Index c = 0; c < 4; ++c) {
            const float share = colors && c < 3 ? toEncoded(texel[c]) : texel[c];
            rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.F, 1.F))));
        }
    return rgba;
}

std::unique_ptr<QOpenGLTexture> tiled(const FabricMaps& maps, QOpenGLTexture::TextureFormat format,
                                      const std::vector<std::uint8_t>& rgba)
{
    const bool colors = format == QOpenGLTexture::SRGB8_Alpha8;
    auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    texture->setAutoMipMapGenerationEnabled(false);
    texture->setSize(maps.width, maps.height);
    texture->setFormat(format);
    texture->setMipLevels(texture->maximumMipLevels());
    texture->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    texture->setData(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, rgba.data());
    MipLevel level = finestOf(maps, rgba, colors);
    for (int i = 1; i < texture->mipLevels(); ++i) {
        level = halfOf(level);
        texture->setData(i, QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, bytesOf(level, colors).data());
    }
    texture->setMinMagFilters(QOpenGLTexture::LinearMipMapLinear, QOpenGLTexture::Linear);
    texture->setWrapMode(QOpenGLTexture::Repeat);
    return texture;
}

/// Normals grow short where mip-maps mean over different ones: the shader makes that rough.
std::vector<std::uint8_t> reliefOf(const FabricMaps& maps)
{
    std::vector<std::uint8_t> relief;
    relief.reserve(maps.albedo.size());
    for (std::size_t i = 0; i < maps.roughness.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            relief.push_back(maps.normal[3 * i + c]);
        relief.push_back(maps.roughness[i]);
    }
    return relief;
}

} // namespace

const GlFabrics::Textures* GlFabrics::textures(const FabricMapsPtr& maps, bool quick)
{
    if (!maps || !maps->complete())
        return nullptr;
    Textures& found = m_textures[maps];
    if (!found.color) {
        found.color = tiled(*maps, QOpenGLTexture::SRGB8_Alpha8, maps->albedo);
        found.relief = tiled(*maps, QOpenGLTexture::RGBA8_UNorm, reliefOf(*maps));
    }
    const Sharpness sharpness = quick ? Sharpness{1, 0} : finest();
    for (QOpenGLTexture* texture : {found.color.get(), found.relief.get()}) {
        texture->setLevelofDetailBias(sharpness.bias);
        if (texture->hasFeature(QOpenGLTexture::AnisotropicFiltering))
            texture->setMaximumAnisotropy(sharpness.anisotropy);
    }
    return &found;
}

void GlFabrics::wear(GlProgram& program, const FabricMapsPtr& maps, double turn, bool quick)
{
    const Textures* found = textures(maps, quick);
    program.set("textured", found != nullptr);
    if (!found)
        return;
    const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
    const auto width = static_cast<float>(maps->widthMm), height = static_cast<float>(maps->heightMm);
    program.set("toTileX", Eigen::Vector2f(c / width, s / width));
    program.set("toTileY", Eigen::Vector2f(s / height, -c / height)); // rows run down
    program.set("sheen", static_cast<float>(maps->sheen));
    program.set("colorMap", 0);
    program.set("reliefMap", 1);
    found->color->bind(0);
    found->relief->bind(1);
}

void GlFabrics::keepOnly(const std::set<FabricMapsPtr>& used)
{
    std::erase_if(m_textures, [&](const auto& entry) { return !used.contains(entry.first); });
}

} // namespace bolster
