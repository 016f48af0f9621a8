// What is drawn: one value that all renderers take.
#pragma once

#include "CoverMesh.h"
#include "Design.h"
#include "FabricMaps.h"
#include "FrameSkin.h"
#include "SectionPlane.h"
#include "TrimMesh.h"
#include "VertexMap.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace bolster {

struct Scene {
    struct PatchLook {
        ElementId patch{};
        std::string color = Fabric{}.color; ///< "#rrggbb"
        FabricMapsPtr maps = nullptr;       ///< instead of the colour, unless null or not complete
        double turn = 0; ///< of the maps' x direction in outline coordinates, radians, counter-clockwise

        friend bool operator==(const PatchLook&, const PatchLook&) = default;
    };
    struct FrameLook {
        std::shared_ptr<const TriangleMesh> mesh;
        Placement placement = {};
        FrameMaterial material = {};
        double opacity = 1;          ///< times that of all
        FrameSkinPtr skin = nullptr; ///< drawn in its place; null until it is known how the cover lies on it
        std::string name = {};       ///< for who exports it; may be empty

        /// But for the skin, which follows from the rest and from the cover.
        bool sameFrame(const FrameLook& other) const;
        friend bool operator==(const FrameLook&, const FrameLook&) = default;
    };

    SurfaceMeshPtr surface;         ///< null: no cover
    CoverMeshPtr cover;             ///< the same refined, drawn in its place with the same patches; may be null
    TrimMeshPtr trims;              ///< stitches and piping on it; may be null
    std::vector<PatchLook> patches; ///< those that are not listed are leather brown
    std::map<ElementId, FabricMapsPtr> fabrics; ///< what piping is made of; others are plain
    VertexMapPtr map;                           ///< null, or of another topology: plain cloth
    std::vector<FrameLook> frames;
    double frameOpacity = 1; ///< less than 1: see-through where there is a cover; without one they are solid
    std::optional<SectionPlane> section; ///< of cover and frames
    bool checker = true;                 ///< instead of the fabrics' maps, in their colours
    double checkerSize = 20;             ///< mm
    bool ground = true;                  ///< a shadow on the floor below everything
    std::string backgroundTop = "#dfe3e8";
    std::string backgroundBottom = "#fafafa";

    /// The look of a patch, or null.
    const PatchLook* look(ElementId patch) const;
    /// Of cover and frames as far as they can be drawn: points that are not finite are left out.
    Box3 boundingBox() const;

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// The maps of a fabric, or null for its plain colour. May take its time.
using FabricBaker = std::function<FabricMapsPtr(ElementId, const Fabric&)>;

/// All patches of a design in the fabrics that they show. `colourway`: noElement for their own fabrics. `bake` is
/// asked once for each fabric; no function: all in their plain colours.
std::vector<Scene::PatchLook> patchLooks(const Design& design, ElementId colourway, const FabricBaker& bake = {});

/// The frames' points where they stand, mm.
std::vector<Vec3> placedPoints(const Scene::FrameLook& frame);

} // namespace bolster
