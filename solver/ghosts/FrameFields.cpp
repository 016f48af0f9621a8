#include "FrameFields.h"

#include "FoamBody.h"
#include "Voxelise.h"

#include <cmath>

namespace bolster {

namespace {

VoxelMetric metricOf(Cushion::Distance distance)
{
    return distance == Cushion::Distance::CityBlock ? VoxelMetric::CityBlock : VoxelMetric::Euclidean;
}

Box3 grown(const Box3& box, double margin)
{
    return box.isEmpty() ? box : Box3(box.min().array() - margin, box.max().array() + margin);
}

/// Depths of voxels near the surface, exactly: whole voxels would leave steps in a cover that lies on the frame.
void refine(const std::vector<const FrameBody*>& bodies, const VoxelGrid& grid, double reach,
            std::vector<float>& depths, WorkerPool& pool, const std::stop_token& stop)
{
    pool.forTasks(grid.size[2], [&](int z) {
        for (int y = 0; y < grid.size[1] && !stop.stop_requested(); ++y)
            for (int x = 0; x < grid.size[0]; ++x) {
                float& depth = depths[grid.index(x, y, z)];
                if (depth < -reach || depth > 2 * grid.edge)
                    continue;
                double nearest = std::abs(depth) + 2 * grid.edge;
                for (const FrameBody* body : bodies)
                    nearest = body->tree.distance(grid.centre(x, y, z), nearest);
                depth = static_cast<float>(depth > 0 ? nearest : -nearest);
            }
    });
}

} // namespace

std::shared_ptr<const FrameParts> FrameFields::parts(const Shape& shape)
{
    return m_parts.get(shape, [](const Shape& s) {
        Placement placement;
        placement.scale = s.scale;
        return std::make_shared<const FrameParts>(frameParts(*s.mesh, placement));
    });
}

Box3 FrameFields::boxOf(const SolidKey& key)
{
    Box3 box;
    const auto all = parts(key.shape);
    for (const int part : key.parts)
        for (const FrameBody& body : (*all)[part])
            box.extend(body.tree.box());
    return box;
}

std::shared_ptr<const Voxels> FrameFields::solid(const SolidKey& key, WorkerPool& pool, const std::stop_token& stop)
{
    return m_solids.get(key, [&](const SolidKey& k) -> std::shared_ptr<const Voxels> {
        auto voxels = std::make_shared<Voxels>();
        voxels->grid = VoxelGrid::around(boxOf(k), k.edge, 1);
        voxels->inside.assign(voxels->grid.voxelCount(), 0);
        const auto all = parts(k.shape);
        for (const int part : k.parts)
            for (const FrameBody& body : (*all)[part])
                fillInside(body, *voxels, pool, stop);
        return stop.stop_requested() ? nullptr : voxels;
    });
}

double FrameFields::voxelCount(const CushionKey& key)
{
    Box3 box = grown(boxOf(key.frame), key.dilation);
    for (const FoamKey& foam : key.foams)
        box.extend(grown(foamBox(foam), foam.dilation)); // cutting ones too: their own grids need room
    return VoxelGrid::count(box, key.frame.edge, 5);
}

std::shared_ptr<const ForceField> FrameFields::cushion(const CushionKey& key, WorkerPool& pool,
                                                       const std::stop_token& stop)
{
    return m_cushions.get(key, [&](const CushionKey& k) -> std::shared_ptr<const ForceField> {
        std::vector<CushionBody> bodies = {{solid(k.frame, pool, stop), k.dilation, false}};
        for (const FoamKey& foam : k.foams)
            bodies.push_back({foamVoxels(foam, k.frame.edge, pool, stop), foam.dilation, foam.cut});
        if (stop.stop_requested())
            return nullptr;
        return cushionField(bodies, metricOf(k.distance), pool, stop);
    });
}

std::shared_ptr<const ForceField> FrameFields::contact(const ContactKey& key, WorkerPool& pool,
                                                       const std::stop_token& stop)
{
    return m_contacts.get(key, [&](const ContactKey& k) -> std::shared_ptr<const ForceField> {
        const Box3 box = grown(boxOf({k.shape, k.parts, 0}), k.gap);
        constexpr double resolution = 150; // voxels along the longest side
        const double edge = std::max(box.isEmpty() ? 1.0 : box.sizes().maxCoeff() / resolution, 1.0);
        Voxels voxels{VoxelGrid::around(box, edge, 3), {}};
        voxels.inside.assign(voxels.grid.voxelCount(), 0);
        std::vector<const FrameBody*> bodies;
        const auto all = parts(k.shape);
        for (const int part : k.parts)
            for (const FrameBody& body : (*all)[part])
                bodies.push_back(&body);
        for (const FrameBody* body : bodies)
            fillInside(*body, voxels, pool, stop);
        std::vector<float> depths = depthsOf(voxels, VoxelMetric::Euclidean, pool, stop);
        refine(bodies, voxels.grid, k.gap + 2 * edge, depths, pool, stop);
        if (stop.stop_requested())
            return nullptr;
        for (float& depth : depths)
            depth += static_cast<float>(k.gap);
        return std::make_shared<const ForceField>(voxels.grid, depths, std::vector<std::uint8_t>{}, pool);
    });
}

void FrameFields::endRound()
{
    m_parts.endRound();
    m_solids.endRound();
    m_cushions.endRound();
    m_contacts.endRound();
}

} // namespace bolster
