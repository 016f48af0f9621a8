#include "SkinnedFrames.h"

#include "Design.h"
#include "StiffFrames.h"

#include <algorithm>
#include <utility>

namespace bolster {

SkinnedFrames::SkinnedFrames(ViewScene& scene, const std::vector<ElementId>& ids, std::function<void()> ready)
    : m_scene(scene)
    , m_ids(ids)
    , m_ready(std::move(ready))
    , m_job(&SkinnedFrames::make, [this](const Wanted& made) { take(made); })
{}

SkinnedFrames::Wanted SkinnedFrames::make(const Wanted& wanted, std::stop_token stop)
{
    Wanted made = wanted;
    const FrameSkins pressed(wanted.surface.get()), stiff(nullptr);
    for (std::size_t f = 0; f < made.frames.size() && !stop.stop_requested(); ++f)
        if (made.frames[f].mesh)
            made.frames[f].skin = (isStiff(made.frames[f].material) ? stiff : pressed)
                                      .skin(*made.frames[f].mesh, made.frames[f].placement, stop);
    return made;
}

void SkinnedFrames::request()
{
    if (m_fit)
        return;
    Wanted wanted{m_scene.surface, m_scene.frames, m_ids};
    for (Scene::FrameLook& frame : wanted.frames)
        frame.skin = nullptr;
    m_job.request(std::move(wanted), true);
}

/// Besides these, those under the whole cover are kept: it comes back when nothing of it is hidden any more.
void SkinnedFrames::take(const Wanted& made)
{
    for (std::size_t f = 0; f < made.frames.size(); ++f) {
        const Scene::FrameLook& frame = made.frames[f];
        std::vector<Made>& known = m_made[made.ids[f]];
        std::erase_if(known, [&](const Made& other) {
            return other.mesh != frame.mesh || other.cover == made.surface || other.cover != m_whole;
        });
        if (frame.skin)
            known.insert(known.begin(), {frame.mesh, made.surface, frame.skin, isStiff(frame.material)});
    }
    use();
    m_ready();
}

/// The one that was made under what is shown of the cover, with the frame where it is; else the newest.
const SkinnedFrames::Made* SkinnedFrames::skinOf(std::size_t frame) const
{
    const auto found = m_made.find(m_ids[frame]);
    if (found == m_made.end())
        return nullptr;
    const Scene::FrameLook& look = m_scene.frames[frame];
    const Made* newest = nullptr;
    for (const Made& made : found->second) {
        if (made.mesh != look.mesh || made.stiff != isStiff(look.material))
            continue;
        if (made.cover == m_scene.surface && made.skin->placement == look.placement)
            return &made;
        newest = newest ? newest : &made;
    }
    return newest;
}

/// Of frames that were hidden, have moved or changed their colour the skin is kept until there is a better one.
void SkinnedFrames::use()
{
    m_scene.skinned = m_scene.surface;
    m_fit = true;
    bool any = false;
    for (std::size_t f = 0; f < m_scene.frames.size(); ++f) {
        const Made* made = skinOf(f);
        m_scene.frames[f].skin = made ? made->skin : nullptr;
        m_fit =
            m_fit && made && made->cover == m_scene.surface && made->skin->placement == m_scene.frames[f].placement;
        if (!made)
            continue;
        any = true;
        if (made->cover != m_scene.surface)
            m_scene.skinned = made->cover;
    }
    if (!any)
        m_scene.skinned = nullptr;
}

void SkinnedFrames::framesChanged(const Design& design)
{
    std::erase_if(m_made, [&](const auto& known) { return !design.element(known.first); });
    use();
    if (std::ranges::find(m_scene.frames, FrameSkinPtr(), &Scene::FrameLook::skin) != m_scene.frames.end())
        request();
}

void SkinnedFrames::coverChanged(const SurfaceMeshPtr& whole)
{
    m_whole = whole;
    use();
}

} // namespace bolster
