#include "ShownFrames.h"

#include "FramePieces.h"
#include "SceneVisibility.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr double opacityOfCuts = 0.3; ///< what foam takes away is nothing that is seen

} // namespace

ShownFrames::ShownFrames(ViewScene& scene, const std::function<void()>& ready)
    : m_scene(scene)
    , m_shapes(ready)
    , m_skins(scene, m_ids, ready)
{}

bool ShownFrames::update(const Design& design, const DesignFiles& files, const SceneVisibility& visibility)
{
    const bool shown = visibility.layerVisible(SceneVisibility::Layer::Frames);
    const std::set<ElementId>& hidden = visibility.hidden();
    std::vector<Scene::FrameLook> frames;
    m_ids.clear();
    if (shown)
        design.each<Frame>([&](ElementId id, const Frame& frame) {
            const auto mesh = files.meshes.find(id);
            if (mesh == files.meshes.end() || !mesh->second || hidden.contains(id))
                return;
            frames.push_back({shownMesh(mesh->second, frame.hiddenParts), frame, frame.material});
            m_ids.push_back(id);
        });
    m_foam.update(design, files);
    if (shown)
        for (const auto& [id, mesh] : m_foam.all()) {
            if (hidden.contains(id))
                continue;
            const Foam& foam = *design.find<Foam>(id);
            frames.push_back({mesh, foam, {FrameMaterial::Kind::Foam}, foam.cut ? opacityOfCuts : 1});
            m_ids.push_back(id);
        }
    if (std::ranges::equal(frames, m_scene.frames, &Scene::FrameLook::sameFrame))
        return false;
    m_scene.frames = std::move(frames);
    m_shapes.setFrames(m_scene.frames, m_ids);
    m_skins.framesChanged(design);
    m_box.setEmpty();
    for (const Scene::FrameLook& frame : m_scene.frames)
        for (const Vec3& p : placedPoints(frame))
            if (p.allFinite())
                m_box.extend(p);
    return true;
}

Box3 ShownFrames::boxOf(ElementId id) const
{
    constexpr int corners = 8;
    Box3 box;
    const auto at = std::ranges::find(m_ids, id);
    if (at == m_ids.end())
        return box;
    const Scene::FrameLook& look = m_scene.frames[static_cast<std::size_t>(at - m_ids.begin())];
    const Box3 own = look.mesh->boundingBox();
    for (int corner = 0; corner < corners && !own.isEmpty(); ++corner)
        box.extend(look.placement.placed(own.corner(static_cast<Box3::CornerType>(corner))));
    return box;
}

double ShownFrames::floorUnder(const Design& design, const Box3& shown)
{
    bool any = false;
    design.each<Frame>([&](ElementId, const Frame&) { any = true; });
    if (!m_box.isEmpty() || !any)
        m_standing = m_box;
    constexpr double skirt = 0.15; // of the frame's size
    const double lowest = shown.min().z();
    if (m_standing.isEmpty() || std::abs(lowest - m_standing.min().z()) < skirt * m_standing.diagonal().norm())
        return lowest;
    return m_standing.min().z();
}

} // namespace bolster
