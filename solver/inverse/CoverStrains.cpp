#include "CoverStrains.h"

#include "TriangleStrain.h"

#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

Eigen::Vector3d limitsOf(const Design& design, const Patch& patch, const std::optional<double>& limit)
{
    if (limit)
        return Eigen::Vector3d::Constant(*limit / 100);
    const auto* fabric = design.find<Fabric>(patch.fabric);
    const StretchLimits limits = fabric ? fabric->limits : StretchLimits{};
    return Eigen::Vector3d(limits.along, limits.across, limits.shear) / 100;
}

} // namespace

CoverStrains coverStrains(const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design,
                          const std::optional<double>& limit, const std::set<ElementId>& patches)
{
    CoverStrains result;
    const auto count = static_cast<Eigen::Index>(topology.triangles.size());
    result.strains.resize(3, count);
    result.limits.resize(3, count);
    result.areas.resize(count);
    for (const SurfaceTopology::PatchRange& range : topology.patches) {
        const auto* patch = design.find<Patch>(range.patch);
        if (!patch || (!patches.empty() && !patches.contains(range.patch)))
            continue;
        const Eigen::Vector3d limits = limitsOf(design, *patch, limit);
        const double grain = patch->grain * std::numbers::pi / 180;
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            std::array<Vec2, 3> rest;
            std::array<Vec3, 3> place;
            for (std::size_t k = 0; k < 3; ++k) {
                rest[k] = topology.pattern[topology.triangles[t][k]];
                place[k] = places[topology.triangles[t][k]];
            }
            const GrainStrain strain = grainStrain(rest, place, grain);
            const Vec2 u = rest[1] - rest[0], v = rest[2] - rest[0];
            const auto column = std::ssize(result.triangles);
            result.strains.col(column) = Eigen::Vector3d(strain.along, strain.across, strain.shear);
            result.limits.col(column) = limits;
            result.areas[column] = 0.5 * std::abs(u.x() * v.y() - u.y() * v.x());
            result.triangles.push_back(t);
        }
    }
    const auto meant = std::ssize(result.triangles);
    result.strains.conservativeResize(3, meant);
    result.limits.conservativeResize(3, meant);
    result.areas.conservativeResize(meant);
    return result;
}

OverLimit overLimit(const CoverStrains& strains)
{
    const Eigen::Array3Xd over = (strains.strains.array().abs() - strains.limits.array()).max(0);
    const Eigen::RowVectorXd energies = over.square().colwise().sum();
    const double all = strains.areas.sum();
    if (!(all > 0))
        return {};
    return {energies.dot(strains.areas) / all,
            (energies.array() > 0).cast<double>().matrix().dot(strains.areas) / all};
}

} // namespace bolster
