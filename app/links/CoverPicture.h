// A small picture of a cover for a list.
#pragma once

#include "Camera.h"
#include "Scene.h"

#include <QImage>

namespace bolster {

/// Drawn by the ray tracer, on any thread; transparent where the cover is not. The whole cover from where the
/// camera looks. `size` in pixels.
QImage coverPicture(const Scene& scene, Camera camera, const QSize& size);

/// The cover in the colours of its patches.
Scene coverScene(SurfaceMeshPtr surface, const Design& design);

} // namespace bolster
