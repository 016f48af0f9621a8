// The soft shadows of what the 3D view shows: found beside the GUI thread.
#pragma once

#include "LatestJob.h"
#include "ViewScene.h"

#include <functional>
#include <memory>

namespace bolster {

class SceneShadows {
public:
    /// The scene must outlive it. `ready` is called when there are new ones in it.
    SceneShadows(ViewScene& scene, std::function<void()> ready);

    void request();
    void cancel() { m_job.cancel(); }

private:
    ViewScene& m_scene;
    LatestJob<CoverOcclusion::Input, std::shared_ptr<const CoverOcclusion>> m_job;
};

} // namespace bolster
