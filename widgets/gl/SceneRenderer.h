// Draws a scene with OpenGL.
#pragma once

#include "GlCover.h"
#include "GlFrames.h"
#include "GlGround.h"
#include "GlMarks.h"
#include "GlPoints.h"
#include "GlTrims.h"

namespace bolster {

/// Lives with one context, which must be current whenever it is used or destroyed.
class SceneRenderer {
public:
    /// Throws std::runtime_error when the context is too old or a shader does not compile.
    SceneRenderer();

    /// Brings the graphics card up to date.
    void update(const ViewScene& scene);
    /// Into the framebuffer that is bound, of the given size in pixels, moved by `jitter` pixels. `quick`: rather
    /// than beautiful, since something moves.
    void draw(const ViewScene& scene, const Camera& camera, const QSize& size, const Vec2& jitter, bool quick);

private:
    static GlFunctions& functions();
    void drawSeeThrough(const ViewScene& scene, const GlView& view, bool quick);

    GlFunctions& m_gl;
    GlGround m_ground;
    GlFabrics m_fabrics; ///< before those who wear them
    GlCover m_cover;
    GlTrims m_trims;
    GlFrames m_frames;
    GlPoints m_points;
    GlMarks m_marks;
};

} // namespace bolster
