#include "ShownCover.h"

#include "Selection.h"

#include <utility>

namespace bolster {

void ShownCover::setSurface(SurfaceMeshPtr surface)
{
    const bool usable = surface && surface->topology &&
                        surface->positions.size() == surface->topology->vertexCount() &&
                        surface->normals.size() == surface->positions.size();
    m_surface = usable ? std::move(surface) : nullptr;
}

bool ShownCover::setRefined(CoverMeshPtr cover, TrimMeshPtr trims)
{
    m_refined = std::move(cover);
    m_trims = std::move(trims);
    return m_refined && m_refined->surface == m_surface;
}

void ShownCover::update(bool shown, const std::set<ElementId>& unseen)
{
    m_scene.surface = shown ? m_visible.of(m_surface, unseen) : nullptr;
    m_scene.cover = m_scene.surface && m_refined && m_refined->surface == m_surface ? m_refined : nullptr;
    m_scene.trims = m_scene.cover ? visibleTrims(m_trims, unseen) : nullptr;
    m_places.setSurface(m_scene.surface);
}

void ShownCover::updateLooks(const Design& design, const Selection& selection, const std::set<ElementId>& mirrored)
{
    m_scene.patches = patchLooks(design, design.settings().colourway, [this](ElementId fabric, const Fabric&) {
        const auto maps = m_scene.fabrics.find(fabric);
        return maps != m_scene.fabrics.end() ? maps->second : nullptr;
    });
    m_scene.tints.clear();
    for (const Scene::PatchLook& look : m_scene.patches) {
        QColor tint = m_scene.colors.accent;
        tint.setAlphaF(selection.contains(look.patch)                                       ? 0.14F
                       : selection.hovered() == look.patch || mirrored.contains(look.patch) ? 0.07F
                                                                                            : 0);
        m_scene.tints[look.patch] = tint;
    }
}

Box3 ShownCover::box() const
{
    Box3 box;
    if (m_scene.surface)
        for (const Vec3& p : m_scene.surface->positions)
            if (p.allFinite())
                box.extend(p);
    return box;
}

Box3 ShownCover::box(const std::set<ElementId>& patches) const
{
    Box3 box;
    if (m_scene.surface)
        for (const SurfaceTopology::PatchRange& range : m_scene.surface->topology->patches)
            if (patches.contains(range.patch))
                for (std::uint32_t i = 0; i < range.vertexCount; ++i)
                    box.extend(m_scene.surface->positions[range.firstVertex + i]);
    return box;
}

} // namespace bolster
