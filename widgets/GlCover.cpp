#include "GlCover.h"

#include "SurfaceEdges.h"

#include <algorithm>
#include <iterator>

namespace bolster {

GlCover::GlCover(GlFunctions& gl)
    : m_gl(gl)
    , m_program("cover.vert", "cover.frag")
    , m_plain("plain.vert", "plain.frag")
{
    m_array.create();
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    bindColumns(gl, m_positions, 3 * sizeof(float), {{0, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_normals, 3 * sizeof(float), {{1, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_cloth, 3 * sizeof(float), {{2, 3, GL_FLOAT, 0}});
    bindColumns(gl, m_openness, 2 * sizeof(float), {{3, 2, GL_FLOAT, 0}});
    bindColumns(gl, m_mapColors, sizeof(SurfaceMap::Rgba), {{4, 4, GL_UNSIGNED_BYTE, 0}});
}

void GlCover::update(const SurfaceScene& scene)
{
    if (scene.surface != m_surface) {
        if (scene.surface && scene.surface->topology != m_topology) {
            m_topology = scene.surface->topology;
            putTopology(*m_topology);
            m_occlusion.reset();
            m_map.reset();
        }
        m_surface = scene.surface;
        if (m_surface)
            putPositions(*m_surface);
    }
    if (m_topology && scene.map != m_map) {
        m_map = scene.map;
        putMap();
    }
    if (m_topology && scene.occlusion != m_occlusion)
        putOpenness(scene);
}

void GlCover::putTopology(const SurfaceTopology& topology)
{
    std::vector<Eigen::Vector3f> cloth;
    for (const Vec2& p : topology.pattern)
        cloth.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 1.F});
    for (const SurfaceTopology::Chain& chain : topology.seams)
        for (const auto* side : {&chain.a, &chain.b})
            for (const std::uint32_t v : *side)
                cloth[v].z() = 0;
    m_cloth.put(cloth, QOpenGLBuffer::StaticDraw);
    m_openness.put(std::vector<Eigen::Vector2f>(cloth.size(), {1, 1}), QOpenGLBuffer::DynamicDraw);

    putMap();

    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_triangles.put(topology.triangles, QOpenGLBuffer::StaticDraw);
    m_edgeCount = 0;
}

/// Nothing where the map is of another topology.
void GlCover::putMap()
{
    const bool fits = m_map && m_map->fits(*m_topology) && m_map->values.size() == m_topology->vertexCount();
    m_mapColors.put(fits ? m_map->colors() : std::vector<SurfaceMap::Rgba>(m_topology->vertexCount()),
                    QOpenGLBuffer::DynamicDraw);
}

void GlCover::putEdges()
{
    std::vector<SurfaceEdge> edges;
    for (const SurfaceTopology::PatchRange& patch : m_topology->patches)
        std::ranges::copy(edgesOf(*m_topology, patch), std::back_inserter(edges));
    m_edges.put(edges, QOpenGLBuffer::StaticDraw);
    m_edgeCount = static_cast<GLsizei>(2 * edges.size());
}

void GlCover::putPositions(const SurfaceMesh& mesh)
{
    std::vector<Eigen::Vector3f> positions;
    positions.reserve(mesh.positions.size());
    for (const Vec3& p : mesh.positions)
        positions.push_back(p.cast<float>());
    m_positions.put(positions, QOpenGLBuffer::StreamDraw);
    m_normals.put(mesh.normals, QOpenGLBuffer::StreamDraw);
}

void GlCover::putOpenness(const SurfaceScene& scene)
{
    m_occlusion = scene.occlusion;
    if (!m_occlusion || m_occlusion->topology != m_topology->serial ||
        m_occlusion->outside.size() != m_topology->vertexCount())
        return; // that of an older topology: the next one is on its way
    std::vector<Eigen::Vector2f> openness;
    for (std::size_t i = 0; i < m_occlusion->outside.size(); ++i)
        openness.push_back({m_occlusion->outside[i], m_occlusion->inside[i]});
    m_openness.put(openness, QOpenGLBuffer::DynamicDraw);
}

void GlCover::draw(const SurfaceScene& scene, const GlView& view)
{
    if (!m_surface)
        return;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("square", scene.checker ? 20.F : 0.F);
    QColor veil = mixed(scene.backgroundTop(), scene.backgroundBottom(), 0.5);
    veil.setAlphaF(scene.dimmed ? 0.45F : 0.F);
    m_program.set("veil", veil);

    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    m_triangles.bind();
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL); // behind the lines on it
    m_gl.glPolygonOffset(1, 1);
    for (const SurfaceTopology::PatchRange& range : m_topology->patches) {
        const SurfaceScene::PatchLook* look = scene.look(range.patch);
        const Eigen::Vector3f color = linearLight(look ? look->fabric : QColor(0x7a, 0x4a, 0x2b));
        m_program.set("lightTone", Eigen::Vector3f((1.6F * color.array() + 0.03F).min(1.F)));
        m_program.set("darkTone", Eigen::Vector3f(0.85F * color));
        m_program.set("tint", look ? look->tint : QColor(0, 0, 0, 0));
        m_gl.glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * range.triangleCount), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(3 * sizeof(std::uint32_t) * range.firstTriangle));
    }
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
}

void GlCover::drawEdges(const GlView& view, const QColor& color)
{
    if (!m_surface)
        return;
    m_plain.use();
    view.setTransforms(m_plain);
    const float alpha = color.alphaF();
    m_plain.set("flatColor",
                QColor::fromRgbF(color.redF() * alpha, color.greenF() * alpha, color.blueF() * alpha, alpha));
    const QOpenGLVertexArrayObject::Binder bound(&m_array);
    if (m_edgeCount == 0)
        putEdges();
    m_edges.bind();
    m_gl.glDrawElements(GL_LINES, m_edgeCount, GL_UNSIGNED_INT, nullptr);
}

} // namespace bolster
