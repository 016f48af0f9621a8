#include "MaterialBook.h"

#include "BakeFabric.h"
#include "LinearLight.h"
#include "Shading.h"

#include <algorithm>
#include <cctype>

namespace bolster {

namespace {

/// Letters, digits and dashes: for names of files.
std::string plainWord(const std::string& name)
{
    std::string word;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (!word.empty() && word.back() != '-')
            word += '-';
    while (word.ends_with('-'))
        word.pop_back();
    return word;
}

} // namespace

MaterialBook::MaterialBook(const Design& design, FabricBaker bake, PictureKind kind)
    : m_design(design)
    , m_bake(std::move(bake))
    , m_kind(kind)
{}

FabricMapsPtr MaterialBook::maps(ElementId fabric)
{
    return dressed(fabric).maps;
}

const MaterialBook::Dressed& MaterialBook::dressed(ElementId id)
{
    const auto [at, isNew] = m_dressed.try_emplace(id);
    Dressed& made = at->second;
    if (!isNew)
        return made;
    const Fabric* const found = m_design.find<Fabric>(id);
    const Fabric fabric = found ? *found : Fabric{};
    made.material.name = fabric.name.empty() ? "Fabric" : fabric.name;
    made.material.color = made.material.mean = lightOf(fabric.color);
    const FabricMapsPtr maps = found && m_bake ? m_bake(id, fabric) : nullptr;
    if (!maps || !maps->complete())
        return made;
    const std::string word = plainWord(fabric.name);
    const std::string name = "fabric-" + std::to_string(number(id)) + (word.empty() ? "" : "-" + word);
    FabricPicturesOf pictures = fabricPictures(*maps, made.material.mean, name, m_kind);
    made.maps = maps;
    made.material.mean = lightOf(meanColor(*maps));
    made.material.color = Eigen::Vector3f::Ones();
    made.material.roughness = pictures.rough;
    made.material.sheen = static_cast<float>(maps->sheen);
    made.material.colorPicture = add(std::move(pictures.color));
    made.material.normalPicture = add(std::move(pictures.normal));
    made.material.roughPicture = add(std::move(pictures.roughness));
    return made;
}

std::optional<std::size_t> MaterialBook::add(ModelPicture picture)
{
    if (picture.bytes.empty())
        return std::nullopt;
    m_pictures.push_back(std::move(picture));
    return m_pictures.size() - 1;
}

/// The same one where there is one that differs in nothing.
std::size_t MaterialBook::add(ModelMaterial material)
{
    const std::string name = material.name;
    for (int copy = 2;; ++copy) {
        const auto taken = std::ranges::find(m_materials, material.name, &ModelMaterial::name);
        if (taken == m_materials.end())
            break;
        if (*taken == material)
            return static_cast<std::size_t>(taken - m_materials.begin());
        material.name = name + " " + std::to_string(copy);
    }
    m_materials.push_back(std::move(material));
    return m_materials.size() - 1;
}

std::size_t MaterialBook::fabric(ElementId id, std::size_t places, const Eigen::Vector2f& tile)
{
    const Dressed& made = dressed(id);
    ModelMaterial material = made.material;
    material.places = places;
    if (made.maps && tile.minCoeff() > 0)
        material.repeats = {tile.x() / static_cast<float>(made.maps->widthMm),
                            tile.y() / static_cast<float>(made.maps->heightMm)};
    return add(std::move(material));
}

std::size_t MaterialBook::seam(ElementId fabric)
{
    const Dressed& made = dressed(fabric);
    ModelMaterial material;
    material.name = made.material.name + ", seam";
    const shading::Cloth dark = shading::inValley({made.material.mean.array(), 0.9F, 0, 0.02F}, 0.9F);
    material.color = material.mean = dark.color.matrix();
    material.roughness = 0.9F;
    return add(std::move(material));
}

std::size_t MaterialBook::thread(const std::string& color)
{
    ModelMaterial material;
    material.name = "Thread " + color;
    material.color = material.mean = lightOf(color);
    material.roughness = 0.6F;
    return add(std::move(material));
}

std::size_t MaterialBook::frame(const FrameMaterial& kind)
{
    constexpr float woodInTheMiddle = 0.12F; // of what its rings darken
    const bool metal = kind.kind == FrameMaterial::Kind::Metal;
    const Eigen::Vector3f color = lightOf(colorShown(kind));
    const shading::Cloth seen = shading::frameSurface(static_cast<int>(kind.kind), color.array(), woodInTheMiddle);
    ModelMaterial material;
    material.name = "Frame " + colorShown(kind);
    material.color = metal ? color : Eigen::Vector3f(seen.color.matrix());
    material.roughness = seen.roughness;
    material.metallic = metal ? 1.F : 0.F;
    material.sheen = seen.sheen;
    return add(std::move(material));
}

} // namespace bolster
