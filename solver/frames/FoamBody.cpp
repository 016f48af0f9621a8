#include "FoamBody.h"

#include "Voxelise.h"

namespace bolster {

namespace {

/// `p` in the foam's own axes, mm at scale 1.
bool contains(const FrameFields::FoamKey& foam, const Vec3& p)
{
    const Vec3 half = 0.5 * foam.size;
    const Vec3 q = p.cwiseQuotient(half);
    switch (foam.shape) {
    case Foam::Shape::Box:
        return q.cwiseAbs().maxCoeff() <= 1;
    case Foam::Shape::Cylinder:
        return q.head<2>().squaredNorm() <= 1 && std::abs(q.z()) <= 1;
    case Foam::Shape::Sphere:
        return q.squaredNorm() <= 1;
    case Foam::Shape::Mesh:
        break;
    }
    return false;
}

} // namespace

FrameParts foamParts(const FrameFields::FoamKey& foam, const std::stop_token& stop)
{
    if (foam.shape != Foam::Shape::Mesh || !foam.mesh)
        return {};
    return frameParts(*foam.mesh, foam.placement, stop);
}

Box3 foamBox(const FrameFields::FoamKey& foam)
{
    Box3 box;
    if (foam.shape == Foam::Shape::Mesh) {
        if (foam.mesh)
            for (const Vec3& p : foam.mesh->points)
                box.extend(foam.placement.placed(p));
        return box;
    }
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
        box.extend(foam.placement.placed(sign.cwiseProduct(foam.size)));
    }
    return box;
}

std::shared_ptr<const Voxels> foamVoxels(const FrameFields::FoamKey& foam, double edge, WorkerPool& pool,
                                         const std::stop_token& stop)
{
    auto voxels = std::make_shared<Voxels>();
    voxels->grid = VoxelGrid::around(foamBox(foam), edge, 1);
    voxels->inside.assign(voxels->grid.voxelCount(), 0);
    for (const auto& bodies : foamParts(foam, stop))
        for (const FrameBody& body : bodies)
            fillInside(body, *voxels, pool, stop);
    if (foam.shape == Foam::Shape::Mesh)
        return voxels;
    const VoxelGrid& grid = voxels->grid;
    pool.forTasks(grid.size[2], [&](int z) {
        for (int y = 0; y < grid.size[1] && !stop.stop_requested(); ++y)
            for (int x = 0; x < grid.size[0]; ++x)
                voxels->inside[grid.index(x, y, z)] =
                    contains(foam, foam.placement.filePoint(grid.centre(x, y, z)));
    });
    return voxels;
}

} // namespace bolster
