#include "RayRenderer.h"

#include <cmath>

namespace bolster {

SoftwareRenderer::Picture RayRenderer::render(const Request& request, std::stop_token stop)
{
    if (!m_renderer || m_scene != request.scene) {
        m_renderer.emplace(request.scene);
        m_scene = request.scene;
    }
    PreviewOptions options;
    options.width = static_cast<int>(std::lround(request.camera.size.x()));
    options.height = static_cast<int>(std::lround(request.camera.size.y()));
    options.samples = request.moving ? 1 : 4;
    options.quick = request.moving;
    options.depth = true;
    PreviewImage drawn = m_renderer->render(RayCamera(request.camera), options, stop);
    if (drawn.empty())
        return {};
    const QImage view(drawn.rgba.data(), drawn.width, drawn.height, 4 * drawn.width, QImage::Format_RGBA8888);
    return {view.copy(), std::move(drawn.depth)};
}

} // namespace bolster
