#include "GlFrames.h"

#include "FrameShapes.h"

#include <algorithm>

namespace bolster {

namespace {

/// The cover presses into the foam here and there. What lies less than that before it is not drawn, mm.
constexpr float foam = 120;

} // namespace

GlFrames::GlFrames(GlFunctions& gl)
    : m_gl(gl)
    , m_program("frame.vert", "frame.frag")
    , m_triangles(gl)
{}

void GlFrames::update(const SurfaceScene& scene)
{
    if (m_frames == scene.frames && m_shapes == scene.frameShapes)
        return;
    m_frames = scene.frames;
    m_shapes = scene.frameShapes;
    std::vector<GlVertex> vertices;
    std::vector<GlTriangles::Triangle> all;
    for (std::size_t f = 0; f < m_frames.size(); ++f) {
        if (!m_shapes[f])
            continue;
        const std::vector<Vec3> points = placedPoints(m_frames[f]);
        const Eigen::Matrix3f turned = m_frames[f].placement.rotation.toRotationMatrix().cast<float>();
        const auto& triangles = m_frames[f].mesh->triangles;
        vertices.reserve(vertices.size() + 3 * triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            all.push_back({first, first + 1, first + 2});
            for (std::size_t i = 0; i < 3; ++i)
                vertices.push_back({points[triangles[t][i]].cast<float>(), turned * m_shapes[f]->normals[t][i]});
        }
    }
    m_triangles.put(vertices, all, QOpenGLBuffer::StaticDraw);
}

void GlFrames::draw(const SurfaceScene& scene, const GlView& view)
{
    if (m_triangles.empty())
        return;
    const bool solid = !scene.surface;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("material", Eigen::Vector3f(0.42F, 0.43F, 0.45F));
    m_program.set("opacity", std::min(1.F, (solid ? 1.F : 0.45F) * static_cast<float>(scene.frameOpacity)));
    m_program.set("push", solid ? 0.F : foam);
    if (!solid) { // curves and seams behind it stay visible
        m_gl.glDepthMask(GL_FALSE);
        m_gl.glEnable(GL_CULL_FACE);
    }
    m_gl.glEnable(GL_BLEND);
    m_triangles.draw();
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDepthMask(GL_TRUE);
}

} // namespace bolster
