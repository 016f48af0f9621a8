// The maps of a fabric as picture files.
#pragma once

#include "CoverModel.h"
#include "FabricMaps.h"

#include <Eigen/Core>

namespace bolster {

/// How pictures are kept: small ones are for pages that travel by mail.
struct PictureKind {
    bool small = false;    ///< slopes as JPEG, too
    int mostPixels = 1024; ///< a side; larger maps are halved
};

struct FabricPicturesOf {
    ModelPicture color;     ///< opaque: over the fabric's plain colour
    ModelPicture normal;    ///< empty bytes: flat
    ModelPicture roughness; ///< empty bytes: `rough` everywhere
    float rough = 1;        ///< perceptual
};

/// `name`: what the files' names begin with. `maps` must be complete, `behind` is linear light. Throws
/// std::runtime_error when a picture cannot be encoded.
FabricPicturesOf fabricPictures(const FabricMaps& maps, const Eigen::Vector3f& behind, const std::string& name,
                                const PictureKind& kind);

} // namespace bolster
