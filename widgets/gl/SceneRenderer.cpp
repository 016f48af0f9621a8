#include "SceneRenderer.h"

#include <stdexcept>

namespace bolster {

GlFunctions& SceneRenderer::functions()
{
    GlFunctions* gl = glFunctions();
    if (!gl)
        throw std::runtime_error("no OpenGL 3.3");
    return *gl;
}

SceneRenderer::SceneRenderer()
    : m_gl(functions())
    , m_ground(m_gl)
    , m_cover(m_gl, m_fabrics)
    , m_trims(m_gl, m_fabrics)
    , m_frames(m_gl)
    , m_points(m_gl)
    , m_marks(m_gl)
{}

void SceneRenderer::update(const ViewScene& scene)
{
    m_ground.update(scene);
    m_cover.update(scene);
    m_trims.update(scene);
    m_frames.update(scene);
    m_points.update(scene);
    m_marks.update(scene);
    std::set<FabricMapsPtr> used;
    for (const Scene::PatchLook& look : scene.patches)
        used.insert(look.maps);
    for (const auto& [id, maps] : scene.fabrics)
        used.insert(maps);
    m_fabrics.keepOnly(used);
}

void SceneRenderer::draw(const ViewScene& scene, const Camera& camera, const QSize& size, const Vec2& jitter,
                         bool quick)
{
    const GlView view(scene, camera, size, jitter);
    m_gl.glViewport(0, 0, size.width(), size.height());
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDisable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); // colours come premultiplied
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glClear(GL_DEPTH_BUFFER_BIT);

    m_ground.draw(scene, camera, view);
    if (scene.section)
        m_gl.glEnable(GL_CLIP_DISTANCE0);
    m_cover.draw(scene, view, quick);
    m_trims.draw(scene, view, quick);
    if (scene.meshEdges) {
        m_gl.glEnable(GL_BLEND);
        m_cover.drawEdges(scene, view, QColor(10, 10, 10, 90));
        m_gl.glDisable(GL_BLEND);
    }
    m_frames.draw(scene, view, GlFrames::Part::Solid, quick);
    if (m_frames.has(scene, GlFrames::Part::SeeThrough))
        drawSeeThrough(scene, view, quick);
    m_gl.glDisable(GL_CLIP_DISTANCE0);
    m_points.draw(view);
    m_marks.draw(view, true);
    m_marks.draw(view, false);
}

/// What is see-through hides no lines: afterwards depths are again those without it.
void SceneRenderer::drawSeeThrough(const ViewScene& scene, const GlView& view, bool quick)
{
    m_frames.draw(scene, view, GlFrames::Part::SeeThrough, quick);
    m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    m_gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    m_cover.drawDepth(scene, view, quick);
    m_frames.draw(scene, view, GlFrames::Part::Solid, quick);
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace bolster
