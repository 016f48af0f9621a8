// What is seen of the frames beside the cover: found beside the GUI thread, kept until there is something better.
#pragma once

#include "LatestJob.h"
#include "ViewScene.h"

#include <functional>
#include <map>
#include <vector>

namespace bolster {

/// Gives the frames of a scene their skins.
class SkinnedFrames {
public:
    /// `ids` are those of the scene's frames; both must outlive it. `ready` is called when there are new skins in
    /// the scene.
    SkinnedFrames(ViewScene& scene, const std::vector<ElementId>& ids, std::function<void()> ready);

    /// The scene's frames are others, or stand elsewhere.
    void framesChanged(const Design& design);
    /// The scene shows another cover; `whole`: the same with nothing hidden.
    void coverChanged(const SurfaceMeshPtr& whole);
    /// Finds those that do not fit what the scene shows now.
    void request();

private:
    struct Wanted {
        SurfaceMeshPtr surface; ///< may be null
        std::vector<Scene::FrameLook> frames;
        std::vector<ElementId> ids; ///< of the frames
    };
    struct Made {
        std::shared_ptr<const TriangleMesh> mesh;
        SurfaceMeshPtr cover; ///< under which it is pressed; may be null
        FrameSkinPtr skin;
        bool stiff = false; ///< made as of what gives nothing
    };

    static Wanted make(const Wanted& wanted, std::stop_token stop);
    void take(const Wanted& made);
    const Made* skinOf(std::size_t frame) const;
    void use();

    ViewScene& m_scene;
    const std::vector<ElementId>& m_ids;
    SurfaceMeshPtr m_whole;
    std::map<ElementId, std::vector<Made>> m_made; ///< of hidden ones, too; newest first
    bool m_fit = true; ///< those shown were made where the frames are now, under what is shown of the cover
    std::function<void()> m_ready;
    LatestJob<Wanted, Wanted> m_job;
};

} // namespace bolster
