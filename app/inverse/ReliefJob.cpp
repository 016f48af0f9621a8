#include "ReliefJob.h"

#include "CoverMap.h"
#include "CoverPicture.h"
#include "SolveFailure.h"

namespace bolster {

namespace {

VertexMap strainMap(const SurfaceMesh& cover, const Design& design)
{
    CoverMap measured = coverMap(CoverMap::Kind::Strain, cover, design, {});
    VertexMap map;
    map.topology = cover.topology;
    map.values = std::move(measured.ofVertex);
    map.allowed = std::move(measured.allowed);
    map.kind = measured.scale.kind;
    map.limit = measured.scale.limit;
    return map;
}

} // namespace

ReliefFound findReliefs(const ReliefWanted& wanted, const std::function<void(double)>& progress,
                        const std::stop_token& stop)
{
    ReliefFound found{wanted.number, {}, {}, {}};
    try {
        found.list = proposeReliefs(wanted.input, wanted.order, progress, stop);
        if (!found.list.cover || stop.stop_requested())
            return found;
        const Design& design = wanted.input.design;
        const VertexMap now = strainMap(*found.list.cover, design);
        const auto picture = [&](const SurfaceMeshPtr& cover, const Design& shown, VertexMap map) {
            if (wanted.order.limit)
                map.allowed.assign(map.values.size(), static_cast<float>(*wanted.order.limit));
            map.limit = now.limit; // the same colours in all of them
            Scene scene = coverScene(cover, shown);
            scene.map = std::make_shared<const VertexMap>(std::move(map));
            return coverPicture(scene, wanted.camera, wanted.pictureSize);
        };
        found.now = picture(found.list.cover, design, now);
        for (const Relief& relief : found.list.reliefs) {
            if (!relief.solved || stop.stop_requested())
                break;
            const Design changed = design.with(relief.edit);
            found.pictures.push_back(picture(relief.cover, changed, strainMap(*relief.cover, changed)));
        }
    } catch (const std::exception& error) {
        found.list.problem = failureMessage(error);
    }
    return found;
}

} // namespace bolster
