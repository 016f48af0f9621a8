// Points of scans on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

namespace bolster {

class GlPoints {
public:
    explicit GlPoints(GlFunctions& gl);

    void update(const ViewScene& scene);
    void draw(const GlView& view);

private:
    GlFunctions& m_gl;
    GlProgram m_program;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_vertices;
    std::vector<ViewScene::PointsLook> m_looks; ///< that are uploaded, one after the other
};

} // namespace bolster
