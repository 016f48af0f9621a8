// From a solved cover to a model of it in its fabrics.
#pragma once

#include "CoverModel.h"
#include "ModelPictures.h"
#include "PictureScene.h"

#include <stop_token>

namespace bolster {

/// What a model is made of.
struct ModelSubject {
    SurfaceMeshPtr surface;
    Design design;
    DesignFiles files;
    FabricBaker bake; ///< none: all in their plain colours
};

/// The cover refined, with stitches, piping and dark lines along plain seams, in all colourways: first the one that
/// the design shows, then the others. `frames`: with frames and foam, as the cover lies on them. Two calls give the
/// same. What was made means nothing when it was stopped. Throws std::runtime_error when the cover cannot be
/// refined, or a picture not be encoded.
CoverModel makeCoverModel(const ModelSubject& subject, bool frames, const PictureKind& pictures,
                          const std::stop_token& stop = {});

} // namespace bolster
