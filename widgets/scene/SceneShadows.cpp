#include "SceneShadows.h"

#include <utility>

namespace bolster {

SceneShadows::SceneShadows(SurfaceScene& scene, std::function<void()> ready)
    : m_scene(scene)
    , m_job(&SurfaceOcclusion::of,
            [this, ready = std::move(ready)](std::shared_ptr<const SurfaceOcclusion> occlusion) {
                m_scene.occlusion = std::move(occlusion);
                ready();
            })
{}

void SceneShadows::request()
{
    SurfaceOcclusion::Input input;
    input.surface = m_scene.surface;
    input.frames = m_scene.frames;
    input.floor = static_cast<float>(m_scene.floor);
    m_job.request(std::move(input), true);
}

} // namespace bolster
