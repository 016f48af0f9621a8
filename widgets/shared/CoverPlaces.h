// The same point on the cover and in the pattern.
#pragma once

#include "PatternLocator.h"

#include <map>
#include <optional>

namespace bolster {

struct CoverPoint {
    ElementId patch{};
    Vec2 outline = Vec2::Zero(); ///< outline coordinates, mm

    friend bool operator==(const CoverPoint&, const CoverPoint&) = default;
};

/// Keeps what finds triangles as long as the topology stays.
class CoverPlaces {
public:
    void setSurface(SurfaceMeshPtr surface);

    /// Where a point of the pattern lies on the cover, mm; nothing when the cover lacks the patch.
    std::optional<Vec3> onCover(const CoverPoint& point);
    /// The direction out of the cover there, unit.
    std::optional<Vec3> outwards(const CoverPoint& point);
    /// The point of the pattern at a place (mm) in a triangle of the cover.
    std::optional<CoverPoint> inPattern(std::uint32_t triangle, const Vec3& place) const;

private:
    std::optional<PatternPlace> locate(const CoverPoint& point);

    SurfaceMeshPtr m_surface;
    std::shared_ptr<const SurfaceTopology> m_locatorsOf;
    std::map<ElementId, PatternLocator> m_locators;
};

} // namespace bolster
