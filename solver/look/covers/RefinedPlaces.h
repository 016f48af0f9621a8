// Points of the pattern on the refined cover.
#pragma once

#include "CoverMesh.h"
#include "PatternLocator.h"

#include <map>

namespace bolster {

/// A point of the cover, and which way it faces.
struct CoverPoint3 {
    Eigen::Vector3f point = Eigen::Vector3f::Zero(); ///< mm
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
};

CoverPoint3 coverPoint(const CoverMesh& cover, const PatternPlace& place);

/// Finds places in the triangles of a refined cover.
class RefinedPlaces {
public:
    explicit RefinedPlaces(std::shared_ptr<const CoverTopology> cover);

    const std::shared_ptr<const CoverTopology>& cover() const { return m_cover; }
    bool has(ElementId patch) const { return rangeOf(patch) != nullptr; }
    /// Of a point in outline coordinates, mm; the nearest place where it lies outside. The cover must have the
    /// patch.
    PatternPlace locate(ElementId patch, const Vec2& point);

private:
    const SurfaceTopology::PatchRange* rangeOf(ElementId patch) const;

    std::shared_ptr<const CoverTopology> m_cover;
    SurfaceTopology m_fine; ///< triangles, pattern and patches alone
    std::map<ElementId, PatternLocator> m_locators;
};

} // namespace bolster
