// The cover without the patches and lines that are hidden.
#pragma once

#include "SurfaceMesh.h"
#include "TrimMesh.h"

#include <set>

namespace bolster {

/// Keeps all vertices, so that what belongs to them fits; cheap while topology and hidden patches stay, and the
/// same mesh again for the same cover.
class VisibleCover {
public:
    /// The same mesh when nothing of it is hidden.
    SurfaceMeshPtr of(const SurfaceMeshPtr& cover, const std::set<ElementId>& hidden);

private:
    std::shared_ptr<const SurfaceTopology> m_whole;
    std::set<ElementId> m_hidden;
    std::shared_ptr<const SurfaceTopology> m_visible;
    SurfaceMeshPtr m_of, m_shown; ///< the last one, and what is seen of it
};

/// Likewise stitches and piping; those of a seam go with either of its patches, as the seam itself does.
TrimMeshPtr visibleTrims(const TrimMeshPtr& trims, const std::set<ElementId>& hidden);

} // namespace bolster
