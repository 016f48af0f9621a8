// The frames on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

namespace bolster {

class GlFrames {
public:
    explicit GlFrames(GlFunctions& gl);

    void update(const SurfaceScene& scene);
    /// See-through over a cover, solid without one.
    void draw(const SurfaceScene& scene, const GlView& view);

private:
    struct Vertex {
        Eigen::Vector3f position, normal;
    };

    GlFunctions& m_gl;
    GlProgram m_program;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_vertices;
    GLsizei m_count = 0;
    std::vector<SurfaceScene::FrameLook> m_frames; ///< that are uploaded, as far as their shapes are known
    std::vector<std::shared_ptr<const FrameShape>> m_shapes;
};

} // namespace bolster
