#include "CoverPicture.h"

#include "PreviewRenderer.h"

namespace bolster {

QImage coverPicture(const Scene& scene, Camera camera, const QSize& size)
{
    camera.size = {size.width(), size.height()};
    camera.fit(scene.surface->boundingBox());
    PreviewOptions options;
    options.width = size.width();
    options.height = size.height();
    options.transparent = true;
    const PreviewImage drawn = renderPreview(scene, RayCamera(camera), options);
    return QImage(drawn.rgba.data(), drawn.width, drawn.height, 4 * drawn.width, QImage::Format_RGBA8888).copy();
}

Scene coverScene(SurfaceMeshPtr surface, const Design& design)
{
    Scene scene;
    scene.surface = std::move(surface);
    scene.patches = patchLooks(design, design.settings().colourway);
    return scene;
}

} // namespace bolster
