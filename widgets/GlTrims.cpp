#include "GlTrims.h"

namespace bolster {

GlTrims::GlTrims(GlFunctions& gl)
    : m_gl(gl)
    , m_program("frame.vert", "frame.frag")
{
    m_array.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    bindColumns(gl, m_vertices, sizeof(Vertex),
                {{0, 3, GL_FLOAT, offsetof(Vertex, position)}, {1, 3, GL_FLOAT, offsetof(Vertex, normal)}});
    m_triangles.bind();
}

void GlTrims::update(const SurfaceScene& scene)
{
    if (!scene.trims || m_trims == scene.trims)
        return;
    m_trims = scene.trims;
    std::vector<Vertex> vertices;
    vertices.reserve(m_trims->points.size());
    for (std::size_t v = 0; v < m_trims->points.size(); ++v)
        vertices.push_back({m_trims->points[v], m_trims->normals[v]});
    m_vertices.put(vertices, QOpenGLBuffer::DynamicDraw);
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_triangles.put(m_trims->triangles, QOpenGLBuffer::DynamicDraw);
}

void GlTrims::draw(const SurfaceScene& scene, const GlView& view)
{
    if (!scene.trims || !scene.surface)
        return;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("opacity", 1.F);
    m_program.set("push", 0.F);
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    for (const TrimMesh::Part& part : m_trims->parts) {
        m_program.set("material", linearLight(QColor(QString::fromStdString(part.color))));
        m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * part.triangleCount), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(std::size_t{12} * part.firstTriangle));
    }
}

} // namespace bolster
