#include "GlPoints.h"

namespace bolster {

namespace {

struct GlPoint {
    Eigen::Vector3f at;
    Eigen::Vector4f color; ///< premultiplied
};

} // namespace

GlPoints::GlPoints(GlFunctions& gl)
    : m_gl(gl)
    , m_program("point.vert", "point.frag")
{
    m_array.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    bindColumns(gl, m_vertices, sizeof(GlPoint),
                {{0, 3, GL_FLOAT, offsetof(GlPoint, at)}, {1, 4, GL_FLOAT, offsetof(GlPoint, color)}});
}

void GlPoints::update(const ViewScene& scene)
{
    if (scene.points == m_looks)
        return;
    m_looks = scene.points;
    std::vector<GlPoint> all;
    for (const ViewScene::PointsLook& look : m_looks)
        for (std::size_t i = 0; i < look.points->size(); ++i) {
            const QColor color = look.colorOf(i);
            const float alpha = color.alphaF();
            all.push_back({(*look.points)[i], Eigen::Vector4f(alpha * color.redF(), alpha * color.greenF(),
                                                              alpha * color.blueF(), alpha)});
        }
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
    for (const ViewScene::PointsLook& look : m_looks) {
        m_program.set("size", look.size * view.pixelRatio);
        const auto count = static_cast<GLsizei>(look.points->size());
        m_gl.glDrawArrays(GL_POINTS, first, count);
        first += count;
    }
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_PROGRAM_POINT_SIZE);
}

} // namespace bolster
