// How a fabric looks.
#pragma once

#include <QImage>

namespace bolster {

/// Square, at one scale, see-through beside the shape; null until they are drawn.
struct FabricPictures {
    QImage cushion;
    QImage ball;
};

} // namespace bolster
