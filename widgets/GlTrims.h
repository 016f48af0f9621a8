// Stitches and piping on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"
#include "TrimMesh.h"

namespace bolster {

/// Uploads what has changed only. A context must be current whenever it is used or destroyed.
class GlTrims {
public:
    explicit GlTrims(GlFunctions& gl);

    void update(const SurfaceScene& scene);
    void draw(const SurfaceScene& scene, const GlView& view);

private:
    struct Vertex {
        Eigen::Vector3f position, normal;
    };

    GlFunctions& m_gl;
    GlProgram m_program;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_vertices;
    GlBuffer m_triangles{QOpenGLBuffer::IndexBuffer};
    TrimMeshPtr m_trims; ///< that is uploaded
};

} // namespace bolster
