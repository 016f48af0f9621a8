#include "SceneShadows.h"

#include <utility>

namespace bolster {

SceneShadows::SceneShadows(ViewScene& scene, std::function<void()> ready)
    : m_scene(scene)
    , m_job(&CoverOcclusion::of, [this, ready = std::move(ready)](std::shared_ptr<const CoverOcclusion> occlusion) {
        m_scene.occlusion = std::move(occlusion);
        ready();
    })
{}

void SceneShadows::request()
{
    CoverOcclusion::Input input;
    input.surface = m_scene.surface;
    input.frames = m_scene.frames;
    input.floor = static_cast<float>(m_scene.floor);
    m_job.request(std::move(input), true);
}

} // namespace bolster
