#include "GlCover.h"

namespace bolster {

namespace {

constexpr float checkerSquare = 20; ///< mm
constexpr float plainRoughness = 0.62F;
constexpr float plainSheen = 0.12F;
constexpr float fineAnisotropy = 8;

} // namespace

GlCover::GlCover(GlFunctions& gl)
    : m_gl(gl)
    , m_program("cover.vert", "cover.frag")
    , m_plain("plain.vert", "plain.frag")
    , m_solved(gl)
    , m_refined(gl)
{}

void GlCover::update(const SurfaceScene& scene)
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
    std::set<FabricMapsPtr> used;
    for (const SurfaceScene::PatchLook& look : scene.patches)
        used.insert(look.maps);
    m_fabrics.keepOnly(used);
}

void GlCover::setCloth(const SurfaceScene& scene, ElementId patch, bool quick)
{
    const SurfaceScene::PatchLook* look = scene.look(patch);
    const Eigen::Vector3f color = linearLight(look ? look->fabric : QColor(0x7a, 0x4a, 0x2b));
    const GlFabrics::Textures* textures =
        look && !scene.checker ? m_fabrics.textures(look->maps, quick ? 1 : fineAnisotropy) : nullptr;
    m_program.set("lightTone", Eigen::Vector3f((1.6F * color.array() + 0.03F).min(1.F)));
    m_program.set("darkTone", Eigen::Vector3f((scene.checker ? 0.85F : 1.F) * color));
    m_program.set("tint", look ? look->tint : QColor(0, 0, 0, 0));
    m_program.set("textured", textures != nullptr);
    m_program.set("plainRoughness", plainRoughness);
    m_program.set("sheen", textures ? static_cast<float>(look->maps->sheen) : plainSheen);
    if (!textures)
        return;
    const auto turn = static_cast<float>(look->turn);
    const auto width = static_cast<float>(look->maps->widthMm), height = static_cast<float>(look->maps->heightMm);
    m_program.set("toTileX", Eigen::Vector2f(std::cos(turn) / width, std::sin(turn) / width));
    m_program.set("toTileY", Eigen::Vector2f(std::sin(turn) / height, -std::cos(turn) / height)); // rows run down
    textures->color->bind(0);
    textures->relief->bind(1);
}

void GlCover::draw(const SurfaceScene& scene, const GlView& view, bool quick)
{
    GlCoverMesh& mesh = shown(scene);
    if (!scene.surface || mesh.empty())
        return;
    m_program.use();
    view.setTransforms(m_program);
    view.setLights(m_program);
    m_program.set("square", scene.checker ? checkerSquare : 0.F);
    m_program.set("colorMap", 0);
    m_program.set("reliefMap", 1);
    m_program.set("quick", quick);
    QColor veil = mixed(scene.backgroundTop(), scene.backgroundBottom(), 0.5);
    veil.setAlphaF(scene.dimmed ? 0.45F : 0.F);
    m_program.set("veil", veil);

    m_gl.glEnable(GL_POLYGON_OFFSET_FILL); // behind the lines on it
    m_gl.glPolygonOffset(1, 1);
    mesh.draw(
        mesh.patches(*scene.surface->topology),
        [&](const SurfaceTopology::PatchRange& range) { setCloth(scene, range.patch, quick); }, quick);
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);
}

void GlCover::drawEdges(const SurfaceScene& scene, const GlView& view, const QColor& color)
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
