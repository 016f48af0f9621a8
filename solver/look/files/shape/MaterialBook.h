// The materials of a model: each once, with the pictures of its fabric.
#pragma once

#include "CoverModel.h"
#include "ModelPictures.h"
#include "Scene.h"

#include <map>
#include <tuple>

namespace bolster {

class MaterialBook {
public:
    MaterialBook(const Design& design, FabricBaker bake, PictureKind kind);

    /// The maps of a fabric; null where it is plain.
    FabricMapsPtr maps(ElementId fabric);
    /// A fabric whose tile, where the coordinates `places` were made for one of `tile` mm, is of its own size.
    std::size_t fabric(ElementId id, std::size_t places = 0, const Eigen::Vector2f& tile = {0, 0});
    /// What is dark at the bottom of a seam in this fabric.
    std::size_t seam(ElementId fabric);
    /// "#rrggbb"
    std::size_t thread(const std::string& color);
    std::size_t frame(const FrameMaterial& material);

    std::vector<ModelMaterial> takeMaterials() { return std::move(m_materials); }
    std::vector<ModelPicture> takePictures() { return std::move(m_pictures); }

private:
    /// What is made of a fabric once.
    struct Dressed {
        FabricMapsPtr maps;
        ModelMaterial material;
    };

    const Dressed& dressed(ElementId fabric);
    std::optional<std::size_t> add(ModelPicture picture);
    std::size_t add(ModelMaterial material);

    const Design& m_design;
    FabricBaker m_bake;
    PictureKind m_kind;
    std::map<ElementId, Dressed> m_dressed;
    std::vector<ModelMaterial> m_materials;
    std::vector<ModelPicture> m_pictures;
};

} // namespace bolster
