#include "GlPoints.h"

namespace bolster {

GlPoints::GlPoints(GlFunctions& gl)
    : m_gl(gl)
    , m_program("point.vert", "plain.frag")
{
    m_array.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    bindColumns(gl, m_vertices, 3 * sizeof(float), {{0, 3, GL_FLOAT, 0}});
}

void GlPoints::update(const SurfaceScene& scene)
{
    if (scene.points == m_looks)
        return;
    m_looks = scene.points;
    std::vector<Eigen::Vector3f> all;
    for (const SurfaceScene::PointsLook& look : m_looks)
        all.insert(all.end(), look.points->begin(), look.points->end());
    m_vertices.put(all, QOpenGLBuffer::StaticDraw);
}

void GlPoints::draw(const GlView& view)
{
    if (m_looks.empty())
        return;
    m_program.use();
    view.setTransforms(m_program);
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_gl.glEnable(GL_PROGRAM_POINT_SIZE);
    m_gl.glEnable(GL_BLEND);
    GLint first = 0;
    for (const SurfaceScene::PointsLook& look : m_looks) {
        const float alpha = look.color.alphaF();
        m_program.set("flatColor", QColor::fromRgbF(look.color.redF() * alpha, look.color.greenF() * alpha,
                                                    look.color.blueF() * alpha, alpha));
        m_program.set("size", look.size * view.pixelRatio);
        const auto count = static_cast<GLsizei>(look.points->size());
        m_gl.glDrawArrays(GL_POINTS, first, count);
        first += count;
    }
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_PROGRAM_POINT_SIZE);
}

} // namespace bolster
