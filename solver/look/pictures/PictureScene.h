// What a picture of a cover shows: the refined surface in the fabrics of a colourway, with a checker or with a map.
#pragma once

#include "CoverMap.h"
#include "PreviewRenderer.h"

namespace bolster {

/// Refined by two levels for a smooth silhouette; null where it cannot be: then the surface itself is drawn.
CoverMeshPtr refinedForPicture(const SurfaceMeshPtr& surface);
/// With valleys and allowances along its seams, as the design trims them; colourways don't change them. Scenes in
/// fabrics or with a checker make them of a cover that has none.
CoverMeshPtr withSeams(const CoverMeshPtr& cover, const Design& design);

/// The design's frames, and the foam that is added to them, in their materials and as the cover lies on them. Those
/// whose files are missing are left out.
std::vector<Scene::FrameLook> framesForPicture(const Design& design, const DesignFiles& files,
                                               const SurfaceMesh* surface);

/// `colourway`: noElement for the patches' own fabrics.
Scene sceneInFabrics(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design, ElementId colourway,
                     const FabricBaker& bake);
/// The fabrics' colours with squares of 20 mm.
Scene sceneWithChecker(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const Design& design,
                       ElementId colourway);
/// `map` must be of this surface.
Scene sceneWithMap(const SurfaceMeshPtr& surface, CoverMeshPtr cover, const CoverMap& map);

} // namespace bolster
