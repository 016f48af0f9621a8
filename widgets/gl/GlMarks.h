// Lines and handles on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

namespace bolster {

class GlMarks {
public:
    explicit GlMarks(GlFunctions& gl);

    void update(const ViewScene& scene);
    /// The visible parts, or those behind what is drawn already.
    void draw(const GlView& view, bool hiddenPart);

private:
    struct Segment {
        Eigen::Vector3f from, to;
        std::array<std::uint8_t, 4> color;
        std::array<float, 3> style;
    };
    struct Dot {
        Eigen::Vector3f at;
        std::array<std::uint8_t, 4> fill, rim;
        std::array<float, 2> style;
    };

    GlFunctions& m_gl;
    GlProgram m_lineProgram;
    GlProgram m_dotProgram;
    QOpenGLVertexArrayObject m_lineArray;
    QOpenGLVertexArrayObject m_dotArray;
    GlBuffer m_segments;
    GlBuffer m_dots;
    GLsizei m_segmentCount = 0;
    GLsizei m_dotCount = 0;
    std::uint64_t m_marks = 0; ///< of the scene that is uploaded
};

} // namespace bolster
