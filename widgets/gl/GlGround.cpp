#include "GlGround.h"

namespace bolster {

namespace {

Eigen::Vector3f displayed(const QColor& color)
{
    return {color.redF(), color.greenF(), color.blueF()};
}

} // namespace

GlGround::GlGround(GlFunctions& gl)
    : m_gl(gl)
    , m_backgroundProgram("screen.vert", "background.frag")
    , m_groundProgram("ground.vert", "ground.frag")
{
    m_array.create();
}

void GlGround::update(const ViewScene& scene)
{
    if (scene.occlusion == m_occlusion)
        return;
    m_occlusion = scene.occlusion;
    m_texture.reset();
    if (!m_occlusion || m_occlusion->ground.count == 0)
        return;
    const CoverOcclusion::Ground& ground = m_occlusion->ground;
    m_texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    m_texture->setSize(ground.count, ground.count);
    m_texture->setFormat(QOpenGLTexture::R32F);
    m_texture->setMipLevels(1);
    m_texture->allocateStorage(QOpenGLTexture::Red, QOpenGLTexture::Float32);
    m_texture->setData(QOpenGLTexture::Red, QOpenGLTexture::Float32, ground.open.data());
    m_texture->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
    m_texture->setWrapMode(QOpenGLTexture::ClampToEdge);
}

void GlGround::draw(const ViewScene& scene, const Camera& camera, const GlView& view)
{
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_backgroundProgram.use();
    m_backgroundProgram.set("top", displayed(colorOf(scene.backgroundTop)));
    m_backgroundProgram.set("bottom", displayed(colorOf(scene.backgroundBottom)));
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    const bool fromAbove = camera.perspective ? camera.eye().z() > scene.floor : camera.elevation > 0;
    if (scene.ground && !scene.box.isEmpty() && fromAbove)
        drawFloor(scene, view);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glEnable(GL_DEPTH_TEST);
}

void GlGround::drawFloor(const ViewScene& scene, const GlView& view)
{
    m_groundProgram.use();
    m_groundProgram.set("viewProjection", Eigen::Matrix4f(view.projection * view.view));
    m_groundProgram.set("center", Eigen::Vector2f(scene.box.center().head<2>().cast<float>()));
    m_groundProgram.set("reach", static_cast<float>(1.4 * scene.box.diagonal().norm()));
    m_groundProgram.set("height", static_cast<float>(scene.floor));
    m_groundProgram.set("gridColor", scene.colors.dark ? QColor(255, 255, 255, 42) : QColor(40, 50, 60, 46));
    m_groundProgram.set("shadowStrength", scene.colors.dark ? 0.75F : 0.55F);
    m_groundProgram.set("openness", 0);
    m_groundProgram.set("shadowSide", 0.F);
    if (m_texture) {
        m_texture->bind(0);
        m_groundProgram.set("shadowCorner", Eigen::Vector2f(m_occlusion->ground.corner.cast<float>()));
        m_groundProgram.set("shadowSide", static_cast<float>(m_occlusion->ground.side));
    }
    m_gl.glEnable(GL_BLEND);
    m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl.glDisable(GL_BLEND);
}

} // namespace bolster
