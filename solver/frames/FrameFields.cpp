#include "FrameFields.h"

#include "BodyTree.h"
#include "CushionVoxels.h"
#include "FoamBody.h"
#include "Voxelise.h"

#include <algorithm>
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
void refine(const BodyTree& bodies, const VoxelGrid& grid, double reach, std::vector<float>& depths,
            WorkerPool& pool, const std::stop_token& stop)
{
    pool.forTasks(grid.size[2], [&](int z) {
        for (int y = 0; y < grid.size[1] && !stop.stop_requested(); ++y)
            for (int x = 0; x < grid.size[0]; ++x) {
                float& depth = depths[grid.index(x, y, z)];
                if (depth < -reach || depth > 2 * grid.edge)
                    continue;
                const double nearest = bodies.distance(grid.centre(x, y, z), std::abs(depth) + 2 * grid.edge);
                depth = static_cast<float>(depth > 0 ? nearest : -nearest);
            }
    });
}

} // namespace

std::shared_ptr<const FrameParts> FrameFields::parts(const Shape& shape, const std::stop_token& stop)
{
    auto made = m_parts.get(shape, [&](const Shape& s) {
        Placement placement;
        placement.scale = s.scale;
        auto parts = std::make_shared<const FrameParts>(frameParts(*s.mesh, placement, stop));
        return stop.stop_requested() ? nullptr : parts;
    });
    return made ? made : std::make_shared<const FrameParts>(shape.mesh->parts.size());
}

Box3 FrameFields::boxOf(const SolidKey& key, const std::stop_token& stop)
{
    Box3 box;
    const auto all = parts(key.shape, stop);
    for (const int part : key.parts)
        for (const FrameBody& body : (*all)[part])
            box.extend(body.tree.box());
    return box;
}

bool isThin(const FrameBody& body, double edge, std::optional<bool> found)
{
    constexpr double small = 4; // voxels
    if (body.tree.box().isEmpty() || body.tree.box().sizes().maxCoeff() < small * edge)
        return false;
    return found == false || (body.thickness && *body.thickness < edge);
}

/// Fills the parts in; those that are too thin for it.
std::vector<int> FrameFields::fill(const SolidKey& key, Voxels& voxels, WorkerPool& pool,
                                   const std::stop_token& stop)
{
    std::vector<int> thin;
    const auto all = parts(key.shape, stop);
    for (const int part : key.parts)
        for (const FrameBody& body : (*all)[part]) {
            if (stop.stop_requested())
                return thin;
            const bool found = fillInside(body, voxels, pool, stop);
            if (isThin(body, voxels.grid.edge, found) && (thin.empty() || thin.back() != part))
                thin.push_back(part);
        }
    return thin;
}

std::shared_ptr<const FrameFields::Solid> FrameFields::solid(const SolidKey& key, WorkerPool& pool,
                                                             const std::stop_token& stop)
{
    return m_solids.get(key, [&](const SolidKey& k) -> std::shared_ptr<const Solid> {
        auto solid = std::make_shared<Solid>();
        solid->voxels.grid = VoxelGrid::around(boxOf(k, stop), k.edge, 1);
        solid->voxels.inside.assign(solid->voxels.grid.voxelCount(), 0);
        solid->thin = fill(k, solid->voxels, pool, stop);
        return stop.stop_requested() ? nullptr : solid;
    });
}

std::vector<int> FrameFields::thinParts(const SolidKey& key, WorkerPool& pool, const std::stop_token& stop)
{
    const auto made = solid(key, pool, stop);
    return made ? made->thin : std::vector<int>();
}

double FrameFields::voxelCount(const CushionKey& key, const std::stop_token& stop)
{
    Box3 box = grown(boxOf(key.frame, stop), key.dilation);
    for (const FoamKey& foam : key.foams)
        box.extend(grown(foamBox(foam), foam.dilation)); // cutting ones too: their own grids need room
    return bolster::voxelCount(box, key.frame.edge, cushionMargin);
}

std::shared_ptr<const ForceField> FrameFields::cushion(const CushionKey& key, WorkerPool& pool,
                                                       const std::stop_token& stop)
{
    return m_cushions.get(key, [&](const CushionKey& k) -> std::shared_ptr<const ForceField> {
        const auto made = solid(k.frame, pool, stop);
        if (!made)
            return nullptr;
        std::vector<CushionBody> bodies = {{{made, &made->voxels}, k.dilation, false}};
        for (const FoamKey& foam : k.foams)
            bodies.push_back({foamVoxels(foam, k.frame.edge, pool, stop), foam.dilation, foam.cut});
        if (stop.stop_requested())
            return nullptr;
        return cushionField(bodies, metricOf(k.distance), pool, stop);
    });
}

double FrameFields::edgeOf(const ContactKey& key, const std::stop_token& stop)
{
    const Box3 box = grown(boxOf({key.shape, key.parts, 0}, stop), key.gap);
    constexpr double resolution = 150; // voxels along the longest side
    return std::max(box.isEmpty() ? 1.0 : box.sizes().maxCoeff() / resolution, 1.0);
}

std::shared_ptr<const FrameFields::Contact> FrameFields::contactField(const ContactKey& key, WorkerPool& pool,
                                                                      const std::stop_token& stop)
{
    return m_contacts.get(key, [&](const ContactKey& k) -> std::shared_ptr<const Contact> {
        const double edge = edgeOf(k, stop);
        const SolidKey solid{k.shape, k.parts, edge};
        Voxels voxels{VoxelGrid::around(grown(boxOf(solid, stop), k.gap), edge, 3), {}};
        voxels.inside.assign(voxels.grid.voxelCount(), 0);
        std::vector<int> thin = fill(solid, voxels, pool, stop);
        std::vector<const FrameBody*> bodies;
        const auto all = parts(k.shape, stop);
        for (const int part : k.parts)
            for (const FrameBody& body : (*all)[part])
                bodies.push_back(&body);
        std::vector<float> depths = depthsOf(voxels, VoxelMetric::Euclidean, pool, stop);
        refine(BodyTree(bodies, stop), voxels.grid, k.gap + 2 * edge, depths, pool, stop);
        for (float& depth : depths)
            depth += static_cast<float>(k.gap);
        ForceField field(voxels.grid, depths, std::vector<std::uint8_t>{}, pool, stop);
        if (stop.stop_requested())
            return nullptr;
        return std::make_shared<const Contact>(Contact{std::move(field), std::move(thin)});
    });
}

std::shared_ptr<const ForceField> FrameFields::contact(const ContactKey& key, WorkerPool& pool,
                                                       const std::stop_token& stop)
{
    const auto made = contactField(key, pool, stop);
    return made ? std::shared_ptr<const ForceField>(made, &made->field) : nullptr;
}

std::vector<int> FrameFields::thinParts(const ContactKey& key, WorkerPool& pool, const std::stop_token& stop)
{
    const auto made = contactField(key, pool, stop);
    return made ? made->thin : std::vector<int>();
}

void FrameFields::endRound()
{
    m_parts.endRound();
    m_solids.endRound();
    m_cushions.endRound();
    m_contacts.endRound();
}

} // namespace bolster
