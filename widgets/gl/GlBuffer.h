// Vertex data on the graphics card.
#pragma once

#include "GlFunctions.h"

#include <QOpenGLBuffer>
#include <QOpenGLVertexArrayObject>

#include <vector>

namespace bolster {

/// A buffer that grows with what is put into it. A context must be current whenever it is used or destroyed.
class GlBuffer {
public:
    explicit GlBuffer(QOpenGLBuffer::Type type = QOpenGLBuffer::VertexBuffer)
        : m_buffer(type)
    {
        m_buffer.create();
    }

    void bind() { m_buffer.bind(); }
    template <class T>
    void put(const std::vector<T>& values, QOpenGLBuffer::UsagePattern usage)
    {
        m_buffer.bind();
        m_buffer.setUsagePattern(usage);
        m_buffer.allocate(values.data(), static_cast<int>(values.size() * sizeof(T)));
    }

private:
    QOpenGLBuffer m_buffer;
};

/// One column of an interleaved vertex buffer.
struct GlColumn {
    GLuint location;
    GLint count;
    GLenum type;
    std::size_t offset;
    bool perInstance = false;
};

/// Binds columns of `buffer` to the vertex array that is bound.
inline void bindColumns(GlFunctions& gl, GlBuffer& buffer, std::size_t stride,
                        std::initializer_list<GlColumn> columns)
{
    buffer.bind();
    for (const GlColumn& column : columns) {
        gl.glEnableVertexAttribArray(column.location);
        gl.glVertexAttribPointer(column.location, column.count, column.type, column.type == GL_UNSIGNED_BYTE,
                                 static_cast<GLsizei>(stride), reinterpret_cast<const void*>(column.offset));
        gl.glVertexAttribDivisor(column.location, column.perInstance ? 1 : 0);
    }
}

} // namespace bolster
