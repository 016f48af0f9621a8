// The frames and the foam that the 3D view shows.
#pragma once

#include "DesignFiles.h"
#include "FoamMeshes.h"
#include "FrameShapes.h"
#include "SkinnedFrames.h"

#include <functional>
#include <vector>

namespace bolster {

class SceneVisibility;

/// Fills in the frames of a scene, and says what must be known about them.
class ShownFrames {
public:
    /// The scene must outlive it. `ready` is called when shapes or skins were found.
    ShownFrames(ViewScene& scene, const std::function<void()>& ready);

    /// True: the scene's frames are others than before, or stand elsewhere.
    bool update(const Design& design, const DesignFiles& files, const SceneVisibility& visibility);

    const Box3& box() const { return m_box; } ///< mm
    const FrameShapes& shapes() const { return m_shapes; }
    const FoamMeshes& foam() const { return m_foam; }
    SkinnedFrames& skins() { return m_skins; }
    /// About a frame or foam, mm; empty if it is not shown.
    Box3 boxOf(ElementId id) const;
    /// Height of the ground, mm, under what is shown: a frame stands on it, and a cover that hangs a little below
    /// it does. Patches that lie anywhere do not move it, nor does a frame that is hidden for a while.
    double floorUnder(const Design& design, const Box3& shown);

private:
    ViewScene& m_scene;
    std::vector<ElementId> m_ids; ///< of the scene's frames: frames, then foam
    Box3 m_box;
    Box3 m_standing; ///< the same while the frame is hidden, too
    FoamMeshes m_foam;
    FrameShapes m_shapes;
    SkinnedFrames m_skins;
};

} // namespace bolster
