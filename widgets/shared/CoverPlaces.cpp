#include "CoverPlaces.h"

#include <algorithm>

namespace bolster {

void CoverPlaces::setSurface(SurfaceMeshPtr surface)
{
    m_surface = std::move(surface);
    const auto topology = m_surface ? m_surface->topology : nullptr;
    if (topology == m_locatorsOf)
        return;
    m_locators.clear();
    m_locatorsOf = topology;
}

std::optional<PatternPlace> CoverPlaces::locate(const CoverPoint& point)
{
    if (!m_surface)
        return std::nullopt;
    const SurfaceTopology& topology = *m_surface->topology;
    const auto range = std::ranges::find(topology.patches, point.patch, &SurfaceTopology::PatchRange::patch);
    if (range == topology.patches.end() || range->triangleCount == 0)
        return std::nullopt;
    const PatternLocator& locator = m_locators.try_emplace(point.patch, topology, *range).first->second;
    return locator.locate(point.outline);
}

std::optional<Vec3> CoverPlaces::onCover(const CoverPoint& point)
{
    const std::optional<PatternPlace> at = locate(point);
    if (!at)
        return std::nullopt;
    Vec3 place = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        place += at->weights[static_cast<Eigen::Index>(k)] * m_surface->positions[at->corners[k]];
    return place.allFinite() ? std::optional(place) : std::nullopt;
}

std::optional<Vec3> CoverPlaces::outwards(const CoverPoint& point)
{
    const std::optional<PatternPlace> at = locate(point);
    if (!at)
        return std::nullopt;
    Vec3 normal = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        normal += at->weights[static_cast<Eigen::Index>(k)] * m_surface->normals[at->corners[k]].cast<double>();
    return normal.norm() > 0 ? std::optional(normal.normalized()) : std::nullopt;
}

std::optional<CoverPoint> CoverPlaces::inPattern(std::uint32_t triangle, const Vec3& place) const
{
    if (!m_surface || triangle >= m_surface->topology->triangles.size())
        return std::nullopt;
    const SurfaceTopology& topology = *m_surface->topology;
    const auto& corners = topology.triangles[triangle];
    const Vec3 a = m_surface->positions[corners[0]], b = m_surface->positions[corners[1]],
               c = m_surface->positions[corners[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    if (!(area > 0))
        return std::nullopt;
    const double u = (c - b).cross(place - b).dot(normal) / area, v = (a - c).cross(place - c).dot(normal) / area;
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        if (triangle - range.firstTriangle < range.triangleCount)
            return CoverPoint{range.patch, u * topology.pattern[corners[0]] + v * topology.pattern[corners[1]] +
                                               (1 - u - v) * topology.pattern[corners[2]]};
    return std::nullopt;
}

} // namespace bolster
