// Rays against the frames.
#pragma once

#include "Camera.h"
#include "SurfaceJob.h"
#include "SurfaceRays.h"
#include "SurfaceScene.h"

#include <memory>
#include <vector>

namespace bolster {

/// Trees are built beside the GUI thread, once for each mesh: they keep to the coordinates of the file, so a frame
/// can be moved for nothing. A frame is hit as soon as its tree is there.
class FrameRays {
public:
    struct Hit {
        ElementId frame{};
        Vec3 position = Vec3::Zero(); ///< mm
    };

    FrameRays();

    void setFrames(const std::vector<SurfaceScene::FrameLook>& frames, const std::vector<ElementId>& ids);
    std::optional<Hit> first(const Camera::Ray& ray) const;

private:
    using MeshPtr = std::shared_ptr<const TriangleMesh>;
    struct Tree {
        MeshPtr mesh;
        std::shared_ptr<const SurfaceRays> rays; ///< null while it is being built
    };
    using Trees = std::vector<Tree>;
    struct Placed {
        ElementId id{};
        SurfaceScene::FrameLook look;
    };

    static Trees build(const Trees& wanted, std::stop_token stop);
    const SurfaceRays* raysOf(const MeshPtr& mesh) const;

    std::vector<Placed> m_frames;
    Trees m_trees;
    SurfaceJob<Trees, Trees> m_job;
};

} // namespace bolster
