// The design's foam as meshes and lines for the 3D view.
#pragma once

#include "DesignFile.h"
#include "ViewScene.h"

namespace bolster {

class Selection;

/// Kept while their shape stays: moving foam makes no new mesh.
class FoamMeshes {
public:
    using MeshPtr = std::shared_ptr<const TriangleMesh>;

    void update(const Design& design, const DesignFiles& files);
    const std::map<ElementId, MeshPtr>& all() const { return m_meshes; }
    /// The edges of all foam, seen through the cover too; red where it is cut away.
    void addLines(const Design& design, const Selection& selection, ViewScene& scene) const;

private:
    std::map<ElementId, MeshPtr> m_meshes;
    std::map<ElementId, std::pair<Foam::Shape, Vec3>> m_shapes; ///< of the meshes that were made here
};

} // namespace bolster
