// Background and floor of an OpenGL picture.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

#include <QOpenGLTexture>

namespace bolster {

class GlGround {
public:
    explicit GlGround(GlFunctions& gl);

    void update(const ViewScene& scene);
    /// Before everything else; does not touch the depths.
    void draw(const ViewScene& scene, const Camera& camera, const GlView& view);

private:
    void drawFloor(const ViewScene& scene, const GlView& view);

    GlFunctions& m_gl;
    GlProgram m_backgroundProgram;
    GlProgram m_groundProgram;
    QOpenGLVertexArrayObject m_array; ///< empty: the shaders know their corners
    std::unique_ptr<QOpenGLTexture> m_texture;
    std::shared_ptr<const CoverOcclusion> m_occlusion;
};

} // namespace bolster
