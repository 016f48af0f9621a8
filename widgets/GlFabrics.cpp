#include "GlFabrics.h"

#include <cmath>

namespace bolster {

namespace {

constexpr float fineAnisotropy = 8;

std::unique_ptr<QOpenGLTexture> tiled(const FabricMaps& maps, QOpenGLTexture::TextureFormat format,
                                      const std::vector<std::uint8_t>& rgba)
{
    auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    texture->setSize(maps.width, maps.height);
    texture->setFormat(format);
    texture->setMipLevels(texture->maximumMipLevels());
    texture->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    texture->setData(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, rgba.data());
    texture->generateMipMaps();
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

const GlFabrics::Textures* GlFabrics::textures(const FabricMapsPtr& maps, float anisotropy)
{
    if (!maps || !maps->complete())
        return nullptr;
    Textures& found = m_textures[maps];
    if (!found.color) {
        found.color = tiled(*maps, QOpenGLTexture::SRGB8_Alpha8, maps->albedo);
        found.relief = tiled(*maps, QOpenGLTexture::RGBA8_UNorm, reliefOf(*maps));
    }
    for (QOpenGLTexture* texture : {found.color.get(), found.relief.get()})
        if (texture->hasFeature(QOpenGLTexture::AnisotropicFiltering))
            texture->setMaximumAnisotropy(anisotropy);
    return &found;
}

void GlFabrics::wear(GlProgram& program, const FabricMapsPtr& maps, double turn, bool quick)
{
    const Textures* found = textures(maps, quick ? 1 : fineAnisotropy);
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
