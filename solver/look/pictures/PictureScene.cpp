#include "PictureScene.h"

#include "ColourwayEdits.h"
#include "FabricShown.h"
#include "FoamShape.h"
#include "FramePieces.h"
#include "SeamRelief.h"
#include "SeamTrims.h"
#include "SurfaceRefiner.h"

#include <map>
#include <stdexcept>

namespace bolster {

namespace {

PreviewScene sceneOf(const SurfaceMeshPtr& surface, CoverMeshPtr cover)
{
    PreviewScene scene;
    scene.surface = surface;
    scene.cover = std::move(cover);
    scene.checker = false;
    return scene;
}

/// In the colours of the fabrics that the patches show.
PreviewScene sceneInColors(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design,
                           ElementId colourway)
{
    PreviewScene scene = sceneOf(surface, std::move(cover));
    design.each<Patch>([&](ElementId id, const Patch&) {
        const Fabric* fabric = design.find<Fabric>(fabricShown(design, id, colourway));
        scene.looks.push_back({id, fabric ? fabric->color : Fabric{}.color});
    });
    if (scene.cover) {
        scene.trims = SeamTrims().make(design.with(edits::showColourway(design, colourway)), *scene.cover);
        if (!scene.cover->relief)
            scene.cover = withSeams(scene.cover, design);
    }
    return scene;
}

} // namespace

CoverMeshPtr refinedForPicture(const SurfaceMeshPtr& surface)
{
    try {
        return SurfaceRefiner().refine(surface, 2);
    } catch (const std::runtime_error&) { // positions that are not finite, or triangles that OpenSubdiv refuses
        return nullptr;
    }
}

CoverMeshPtr withSeams(const CoverMeshPtr& cover, const Design& design)
{
    if (!cover)
        return nullptr;
    auto sewn = std::make_shared<CoverMesh>(*cover);
    sewn->relief = seamRelief(design, *sewn->topology);
    return sewn;
}

std::vector<PreviewScene::FrameLook> framesForPicture(const Design& design, const DesignFiles& files,
                                                      const SurfaceMesh* surface)
{
    const FrameSkins skins(surface);
    std::vector<PreviewScene::FrameLook> frames;
    const auto add = [&](std::shared_ptr<const TriangleMesh> mesh, const Placement& placement,
                         const FrameMaterial& material) {
        if (mesh)
            frames.push_back({mesh, placement, material, skins.skin(*mesh, placement)});
    };
    const auto fileOf = [&](ElementId id) {
        const auto found = files.meshes.find(id);
        return found != files.meshes.end() ? found->second : nullptr;
    };
    design.each<Frame>([&](ElementId id, const Frame& frame) {
        add(shownMesh(fileOf(id), frame.hiddenParts), frame, frame.material);
    });
    design.each<Foam>([&](ElementId id, const Foam& foam) {
        if (foam.cut)
            return;
        add(foam.shape == Foam::Shape::Mesh ? fileOf(id)
                                            : std::make_shared<const TriangleMesh>(foamMesh(foam.shape, foam.size)),
            foam, {FrameMaterial::Kind::Foam});
    });
    return frames;
}

PreviewScene sceneInFabrics(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design,
                            ElementId colourway, const FabricBaker& bake)
{
    PreviewScene scene = sceneInColors(surface, std::move(cover), design, colourway);
    std::map<ElementId, FabricMapsPtr> baked;
    const auto mapsOf = [&](ElementId id, const Fabric& fabric) {
        if (!baked.contains(id))
            baked.emplace(id, bake ? bake(id, fabric) : nullptr);
        return baked.at(id);
    };
    for (PreviewScene::PatchLook& look : scene.looks) {
        const ElementId shown = fabricShown(design, look.patch, colourway);
        const Fabric* fabric = design.find<Fabric>(shown);
        if (!fabric)
            continue;
        look.maps = mapsOf(shown, *fabric);
        look.turn = clothTurn(*design.find<Patch>(look.patch), *fabric);
    }
    if (scene.trims)
        for (const TrimMesh::Part& part : scene.trims->parts)
            if (const Fabric* fabric = design.find<Fabric>(part.fabric))
                scene.piping[part.fabric] = mapsOf(part.fabric, *fabric);
    return scene;
}

PreviewScene sceneWithChecker(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design,
                              ElementId colourway)
{
    PreviewScene scene = sceneInColors(surface, std::move(cover), design, colourway);
    scene.checker = true;
    return scene;
}

PreviewScene sceneWithMap(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const CoverMap& map)
{
    PreviewScene scene = sceneOf(surface, std::move(cover));
    scene.vertexColors = map.colors();
    for (const SurfaceTopology::PatchRange& range : surface->topology->patches)
        scene.looks.push_back({range.patch, "#b9bcc0"}); // where nothing is known
    return scene;
}

} // namespace bolster
