// The frames on the graphics card.
#pragma once

#include "GlTriangles.h"
#include "GlView.h"

namespace bolster {

class GlFrames {
public:
    explicit GlFrames(GlFunctions& gl);

    void update(const SurfaceScene& scene);
    /// See-through over a cover, solid without one.
    void draw(const SurfaceScene& scene, const GlView& view);

private:
    GlFunctions& m_gl;
    GlProgram m_program;
    GlTriangles m_triangles;
    std::vector<SurfaceScene::FrameLook> m_frames; ///< that are uploaded, as far as their shapes are known
    std::vector<std::shared_ptr<const FrameShape>> m_shapes;
};

} // namespace bolster
