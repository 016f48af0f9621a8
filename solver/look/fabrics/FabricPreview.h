// A fabric on a ball or a cushion, to choose it by the eye.
#pragma once

#include "FabricMaps.h"
#include "ImagePixels.h"

namespace bolster {

struct FabricPreviewOptions {
    enum class Shape { Ball, Cushion, Flat };

    Shape shape = Shape::Cushion;
    int pixels = 128;    ///< width and height of the picture
    double width = 60;   ///< of what is shown, mm: fabric that faces the eye has its real size on any shape
    double rotation = 0; ///< of the fabric, radians, counter-clockwise
};

/// The light of the 3D view's studio; see-through beside the shape. About 60 ms at 240 pixels.
ImagePixelsPtr fabricPreview(const FabricMaps& maps, const FabricPreviewOptions& options = {});

} // namespace bolster
