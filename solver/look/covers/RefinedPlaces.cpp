#include "RefinedPlaces.h"

#include <algorithm>

namespace bolster {

CoverPoint3 coverPoint(const CoverMesh& cover, const PatternPlace& place)
{
    CoverPoint3 at{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto weight = static_cast<float>(place.weights[static_cast<Eigen::Index>(c)]);
        at.point += weight * cover.points[place.corners[c]];
        at.normal += weight * cover.normals[place.corners[c]];
    }
    at.normal.normalize();
    return at;
}

RefinedPlaces::RefinedPlaces(std::shared_ptr<const CoverTopology> cover)
    : m_cover(std::move(cover))
{
    m_fine.triangles = m_cover->triangles;
    m_fine.patches = m_cover->coarse->patches;
    for (auto& patch : m_fine.patches) {
        patch.firstTriangle *= m_cover->trianglesPerCoarse();
        patch.triangleCount *= m_cover->trianglesPerCoarse();
    }
    for (const Eigen::Vector2f& p : m_cover->pattern)
        m_fine.pattern.push_back(p.cast<double>());
}

const SurfaceTopology::PatchRange* RefinedPlaces::rangeOf(ElementId patch) const
{
    const auto found = std::ranges::find(m_fine.patches, patch, &SurfaceTopology::PatchRange::patch);
    return found == m_fine.patches.end() || found->triangleCount == 0 ? nullptr : &*found;
}

PatternPlace RefinedPlaces::locate(ElementId patch, const Vec2& point)
{
    auto locator = m_locators.find(patch);
    if (locator == m_locators.end())
        locator = m_locators.try_emplace(patch, m_fine, *rangeOf(patch)).first;
    return locator->second.locate(point);
}

} // namespace bolster
