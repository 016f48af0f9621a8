// The cover without the patches and lines that are hidden.
#pragma once

#include "SurfaceMesh.h"

#include <set>

namespace bolster {

/// Keeps all vertices, so that what belongs to them fits; cheap while topology and hidden patches stay.
class VisibleCover {
public:
    /// The same mesh when nothing of it is hidden.
    SurfaceMeshPtr of(const SurfaceMeshPtr& cover, const std::set<ElementId>& hidden);

private:
    std::shared_ptr<const SurfaceTopology> m_whole;
    std::set<ElementId> m_hidden;
    std::shared_ptr<const SurfaceTopology> m_visible;
};

} // namespace bolster
