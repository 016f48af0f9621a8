// Pushes what lies inside of cushioning out of it (paper, section 4.1).
#pragma once

#include "DistanceTransform.h"
#include "VoxelGrid.h"

#include <memory>
#include <span>

namespace bolster {

/// Vectors at the centres of voxels, interpolated trilinearly: the way to the surface of the cushioning, as long as
/// the point lies deep in it, in mm whatever the size of the voxels. The voxels outside that touch the surface
/// carry their negative depth, so that the field vanishes at the surface and not half a voxel outside.
class ForceField {
public:
    /// Of depths in mm, positive inside; beyond 1.5 voxels outside they are not looked at. `owners`, one per voxel
    /// or empty, says whose strength counts there. When stopped it means nothing.
    ForceField(const VoxelGrid& grid, const std::vector<float>& depths, std::vector<std::uint8_t> owners,
               WorkerPool& pool, const std::stop_token& stop = {});

    struct Push {
        Vec3 force = Vec3::Zero(); ///< f, mm: each voxel's times its owner's strength
        double depth = 0;          ///< way to the surface along f, mm
    };
    /// Nothing far outside. `strengths` by owner; none: 1 everywhere.
    Push at(const Vec3& point, std::span<const double> strengths) const;

    const VoxelGrid& grid() const { return m_grid; }
    std::size_t insideCount() const { return m_insideCount; } ///< voxels

private:
    struct Cell {
        float force[4] = {0, 0, 0, 0}; ///< and, last, the depth
    };

    VoxelGrid m_grid;
    std::vector<Cell> m_cells;
    std::vector<std::uint8_t> m_owners;
    std::size_t m_insideCount = 0;
};

/// One of the bodies that cushioning is made of.
struct CushionBody {
    std::shared_ptr<const Voxels> voxels;
    double dilation = 0; ///< mm
    bool cut = false;    ///< taken away from the others instead of added
};

/// The field of all bodies together: those that are cut away go last. Where added ones overlap, the later one's
/// strength counts; owners are numbered like `bodies`, of which there may be 256. Null when stopped.
std::shared_ptr<const ForceField> cushionField(std::span<const CushionBody> bodies, VoxelMetric metric,
                                               WorkerPool& pool, const std::stop_token& stop);

/// The voxels within `dilation` mm of a body, on a grid with room for them: whole voxels, rounded.
Voxels dilated(const Voxels& body, double dilation, WorkerPool& pool, const std::stop_token& stop = {});

/// Depth of every voxel's centre below the surface between inside and outside, mm; negative outside.
std::vector<float> depthsOf(const Voxels& voxels, VoxelMetric metric, WorkerPool& pool,
                            const std::stop_token& stop = {});

} // namespace bolster
