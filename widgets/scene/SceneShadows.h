// The soft shadows of what the 3D view shows: found beside the GUI thread.
#pragma once

#include "SurfaceJob.h"
#include "SurfaceScene.h"

#include <functional>
#include <memory>

namespace bolster {

class SceneShadows {
public:
    /// The scene must outlive it. `ready` is called when there are new ones in it.
    SceneShadows(SurfaceScene& scene, std::function<void()> ready);

    void request();
    void cancel() { m_job.cancel(); }

private:
    SurfaceScene& m_scene;
    SurfaceJob<SurfaceOcclusion::Input, std::shared_ptr<const SurfaceOcclusion>> m_job;
};

} // namespace bolster
