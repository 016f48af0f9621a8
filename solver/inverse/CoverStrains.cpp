#include "CoverStrains.h"

#include "TriangleStrain.h"

#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

Eigen::Vector3d limitsOf(const Design& design, const Patch& patch)
{
    const auto* fabric = design.find<Fabric>(patch.fabric);
    const StretchLimits limits = fabric ? fabric->limits : StretchLimits{};
    return Eigen::Vector3d(limits.along, limits.across, limits.shear) / 100;
}

Eigen::Vector3d strainsAlongGrain(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place, double degrees)
{
    const GrainStrain strain = grainStrain(rest, place, degrees * std::numbers::pi / 180);
    return {strain.along, strain.across, strain.shear};
}

Eigen::Vector3d principalStrains(const std::array<Vec2, 3>& rest, const std::array<Vec3, 3>& place)
{
    const Eigen::Vector2d stretches = principalStretches(rest, place);
    return {stretches[0] - 1, stretches[1] - 1, 0};
}

} // namespace

CoverStrains coverStrains(const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design,
                          const std::optional<double>& limit, const std::vector<std::uint32_t>& triangles)
{
    CoverStrains result;
    const auto count = std::ssize(triangles);
    result.strains.resize(3, count);
    result.limits.resize(3, count);
    result.areas.resize(count);
    result.triangles = triangles;
    std::vector<const Patch*> patches(topology.triangles.size(), nullptr);
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        std::fill_n(patches.begin() + range.firstTriangle, range.triangleCount, design.find<Patch>(range.patch));
    for (Eigen::Index column = 0; column < count; ++column) {
        const std::uint32_t t = triangles[static_cast<std::size_t>(column)];
        std::array<Vec2, 3> rest;
        std::array<Vec3, 3> place;
        for (std::size_t k = 0; k < 3; ++k) {
            rest[k] = topology.pattern[topology.triangles[t][k]];
            place[k] = places[topology.triangles[t][k]];
        }
        const Vec2 u = rest[1] - rest[0], v = rest[2] - rest[0];
        result.strains.col(column) =
            limit ? principalStrains(rest, place) : strainsAlongGrain(rest, place, patches[t]->grain);
        result.limits.col(column) = limit ? Eigen::Vector3d::Constant(*limit / 100) : limitsOf(design, *patches[t]);
        result.areas[column] = 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
    }
    return result;
}

CoverStrains coverStrains(const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design,
                          const std::optional<double>& limit)
{
    std::vector<std::uint32_t> all;
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        for (std::uint32_t t = 0; design.find<Patch>(range.patch) && t < range.triangleCount; ++t)
            all.push_back(range.firstTriangle + t);
    return coverStrains(topology, places, design, limit, all);
}

Eigen::VectorXd squaresOver(const CoverStrains& limits, const Eigen::Matrix3Xd& strains)
{
    return (strains.array().abs() - limits.limits.array()).max(0).square().colwise().sum().transpose();
}

OverLimit overLimit(const CoverStrains& strains)
{
    const Eigen::VectorXd squares = squaresOver(strains, strains.strains);
    const double all = strains.areas.sum();
    if (!(all > 0))
        return {};
    return {squares.dot(strains.areas) / all,
            (squares.array() > 0).cast<double>().matrix().dot(strains.areas) / all};
}

} // namespace bolster
