#include "GlTrims.h"

#include "Shading.h"

namespace bolster {

GlTrims::GlTrims(GlFunctions& gl, GlFabrics& fabrics)
    : m_program("trim.vert", "trim.frag")
    , m_triangles(gl)
    , m_fabrics(fabrics)
{}

void GlTrims::update(const ViewScene& scene)
{
    if (!scene.trims || m_trims == scene.trims)
        return;
    m_trims = scene.trims;
    std::vector<GlVertex> vertices;
    vertices.reserve(m_trims->points.size());
    for (std::size_t v = 0; v < m_trims->points.size(); ++v)
        vertices.push_back({m_trims->points[v], m_trims->normals[v], m_trims->cloth[v]});
    m_triangles.put(vertices, m_trims->triangles, QOpenGLBuffer::DynamicDraw);
}

void GlTrims::draw(const ViewScene& scene, const GlView& view, bool quick)
{
    if (!scene.trims || !scene.surface)
        return;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("quick", quick);
    for (const TrimMesh::Part& part : m_trims->parts) {
        const auto maps = scene.fabrics.find(part.fabric);
        const bool textured = maps != scene.fabrics.end() && !scene.checker;
        m_program.set("material", linearLight(colorOf(part.color)));
        m_program.set("plainRoughness", shading::trimRoughness);
        m_program.set("sheen", 0.F);
        m_fabrics.wear(m_program, textured ? maps->second : nullptr, 0, quick);
        m_triangles.draw(part.firstTriangle, part.triangleCount);
    }
}

} // namespace bolster
