#include "GlCover.h"

#include "Design.h"
#include "Shading.h"

namespace bolster {

namespace {

constexpr int places = 8;      ///< one behind the other, for patches that lie in the same place
constexpr float placeStep = 4; ///< between two of them, in the smallest steps of depth: far less than a millimetre

} // namespace

GlCover::GlCover(GlFunctions& gl, GlFabrics& fabrics)
    : m_gl(gl)
    , m_program("cover.vert", "cover.frag")
    , m_plain("plain.vert", "plain.frag")
    , m_solved(gl)
    , m_refined(gl)
    , m_fabrics(fabrics)
{}

void GlCover::update(const ViewScene& scene)
{
    if (!scene.surface)
        return;
    if (scene.cover)
        m_refined.put(scene.cover);
    else
        m_solved.put(scene.surface);
    GlCoverMesh& mesh = shown(scene);
    mesh.putMap(scene.map);
    mesh.putOpenness(scene.occlusion);
    updateRelief(scene);
}

void GlCover::updateRelief(const ViewScene& scene)
{
    GlCoverMesh& mesh = shown(scene);
    const SurfaceTopology& topology = *scene.surface->topology;
    if (scene.cover && scene.cover->relief)
        m_relief = scene.cover->relief;
    if (!m_relief || !m_relief->fits(topology.serial, mesh.vertexCount()))
        m_relief = scene.cover ? seamRelief(Design(), *scene.cover->topology) : seamRelief(Design(), topology);
    mesh.putRelief(m_relief);
}

void GlCover::setCloth(const ViewScene& scene, ElementId patch, bool quick)
{
    const Scene::PatchLook* look = scene.look(patch);
    const auto tint = scene.tints.find(patch);
    const shading::vec3 color = linearLight(colorOf(look ? look->color : Scene::PatchLook{}.color));
    m_program.set("lightTone", shading::lightSquare(color).matrix().eval());
    m_program.set("darkTone", (scene.checker ? shading::darkSquare(color) : color).matrix().eval());
    m_program.set("tint", tint != scene.tints.end() ? tint->second : QColor(0, 0, 0, 0));
    m_program.set("plainRoughness", shading::bareRoughness);
    m_program.set("sheen", shading::bareSheen);
    m_fabrics.wear(m_program, look && !scene.checker ? look->maps : nullptr, look ? look->turn : 0, quick);
}

void GlCover::draw(const ViewScene& scene, const GlView& view, bool quick)
{
    draw(scene, view, quick, quick ? GlCoverMesh::Detail::Fewer : GlCoverMesh::Detail::Refined);
}

void GlCover::drawDepth(const ViewScene& scene, const GlView& view, bool quick)
{
    draw(scene, view, true, quick ? GlCoverMesh::Detail::Fewer : GlCoverMesh::Detail::Solved);
}

void GlCover::draw(const ViewScene& scene, const GlView& view, bool quick, GlCoverMesh::Detail detail)
{
    GlCoverMesh& mesh = shown(scene);
    if (!scene.surface || mesh.empty())
        return;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("square", scene.checker ? static_cast<float>(scene.checkerSize) : 0.F);
    m_program.set("quick", quick);
    QColor veil = scene.veil();
    veil.setAlphaF(scene.dimmed ? 0.45F : 0.F);
    m_program.set("veil", veil);

    m_gl.glEnable(GL_POLYGON_OFFSET_FILL); // behind the lines on it
    int drawn = 0;
    mesh.draw(
        mesh.patches(*scene.surface->topology),
        [&](const SurfaceTopology::PatchRange& range) {
            m_gl.glPolygonOffset(1, 1 + placeStep * static_cast<float>(drawn++ % places));
            setCloth(scene, range.patch, quick);
        },
        detail);
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
}

void GlCover::drawEdges(const ViewScene& scene, const GlView& view, const QColor& color)
{
    GlCoverMesh& mesh = shown(scene);
    if (!scene.surface || mesh.empty())
        return;
    m_plain.use();
    view.setTransforms(m_plain);
    const float alpha = color.alphaF();
    m_plain.set("flatColor",
                QColor::fromRgbF(color.redF() * alpha, color.greenF() * alpha, color.blueF() * alpha, alpha));
    mesh.drawEdges(mesh.patches(*scene.surface->topology));
}

} // namespace bolster
