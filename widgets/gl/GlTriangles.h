// Triangles with normals on the graphics card.
#pragma once

#include "GlBuffer.h"

#include <Eigen/Core>

#include <array>

namespace bolster {

struct GlVertex {
    Eigen::Vector3f position, normal;
    Eigen::Vector2f cloth = Eigen::Vector2f::Zero(); ///< where it lies in a fabric, mm
};

/// A context must be current whenever it is used or destroyed.
class GlTriangles {
public:
    using Triangle = std::array<std::uint32_t, 3>;

    explicit GlTriangles(GlFunctions& gl)
        : m_gl(gl)
    {
        m_array.create();
        const QOpenGLVertexArrayObject::Binder bound(&m_array);
        bindColumns(gl, m_vertices, sizeof(GlVertex),
                    {{0, 3, GL_FLOAT, offsetof(GlVertex, position)},
                     {1, 3, GL_FLOAT, offsetof(GlVertex, normal)},
                     {2, 2, GL_FLOAT, offsetof(GlVertex, cloth)}});
        m_triangles.bind();
    }

    void put(const std::vector<GlVertex>& vertices, const std::vector<Triangle>& triangles,
             QOpenGLBuffer::UsagePattern usage)
    {
        m_vertices.put(vertices, usage);
        const QOpenGLVertexArrayObject::Binder bound(&m_array);
        m_triangles.put(triangles, usage);
        m_count = triangles.size();
    }

    bool empty() const { return m_count == 0; }
    void draw() { draw(0, m_count); }
    void draw(std::size_t first, std::size_t count)
    {
        const QOpenGLVertexArrayObject::Binder bound(&m_array);
        m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(sizeof(Triangle) * first));
    }

private:
    GlFunctions& m_gl;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_vertices;
    GlBuffer m_triangles{QOpenGLBuffer::IndexBuffer};
    std::size_t m_count = 0;
};

} // namespace bolster
