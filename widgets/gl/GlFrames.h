// The frames on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

namespace bolster {

class GlFrames {
public:
    enum class Part { Solid, SeeThrough };

    explicit GlFrames(GlFunctions& gl);

    void update(const ViewScene& scene);
    bool has(const ViewScene& scene, Part part) const;
    /// Those that are solid hide what is behind them. Of the others only what is nearest to the eye is seen.
    void draw(const ViewScene& scene, const GlView& view, Part part);

private:
    static Part partOf(const ViewScene& scene, std::size_t frame);
    void drawAll(const ViewScene& scene, Part part);

    GlFunctions& m_gl;
    GlProgram m_program;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_corners;
    std::vector<FrameSkinPtr> m_skins; ///< that are uploaded, one after the other
};

} // namespace bolster
