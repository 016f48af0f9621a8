#include "RayRenderer.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

PreviewScene sceneOf(const SoftwareRenderer::Request& request)
{
    PreviewScene scene;
    scene.surface = request.surface;
    scene.cover = request.cover;
    scene.trims = request.trims;
    for (const auto& look : request.looks)
        scene.looks.push_back({look.patch, look.color.name().toStdString(), look.maps, look.turn});
    scene.piping = request.fabrics;
    for (const auto& look : request.frames)
        scene.frames.push_back(
            {look.mesh, look.placement, look.material, look.skin, look.opacity * request.frameOpacity});
    if (request.section)
        scene.section = {request.section->normal, request.section->offset};
    if (request.map && request.surface && request.map->fits(*request.surface->topology))
        scene.vertexColors = request.map->colors();
    scene.checker = request.checker;
    scene.ground = request.ground;
    scene.backgroundTop = request.backgroundTop.name().toStdString();
    scene.backgroundBottom = request.backgroundBottom.name().toStdString();
    return scene;
}

} // namespace

bool RayRenderer::prepared(const Request& request) const
{
    return m_last && m_renderer && m_last->surface == request.surface && m_last->cover == request.cover &&
           m_last->trims == request.trims && m_last->map == request.map &&
           m_last->frameOpacity == request.frameOpacity && m_last->section == request.section &&
           m_last->checker == request.checker && m_last->ground == request.ground &&
           m_last->backgroundTop == request.backgroundTop && m_last->backgroundBottom == request.backgroundBottom &&
           m_last->looks == request.looks && m_last->fabrics == request.fabrics && m_last->frames == request.frames;
}

SoftwareRenderer::Picture RayRenderer::render(const Request& request, std::stop_token stop)
{
    if (!prepared(request)) {
        m_renderer.emplace(sceneOf(request));
        m_last = request;
    }
    PreviewOptions options;
    options.width = static_cast<int>(std::lround(request.camera.size.x()));
    options.height = static_cast<int>(std::lround(request.camera.size.y()));
    options.samples = request.moving ? 1 : 4;
    options.quick = request.moving;
    options.depth = true;
    PreviewImage drawn = m_renderer->render(PreviewView(request.camera), options, stop);
    if (drawn.empty())
        return {};
    const QImage view(drawn.rgba.data(), drawn.width, drawn.height, 4 * drawn.width, QImage::Format_RGBA8888);
    return {view.copy(), std::move(drawn.depth)};
}

} // namespace bolster
