// What the 3D view shows, as a value that both of its canvases draw.
#pragma once

#include "CoverMesh.h"
#include "FabricMaps.h"
#include "SectionPlane.h"
#include "SoftwareRenderer.h"
#include "SurfaceMap.h"
#include "SurfaceOcclusion.h"
#include "TrimMesh.h"
#include "ViewColors.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace bolster {

/// A line of constant width in the picture.
struct SurfaceLine {
    std::vector<Eigen::Vector3f> points; ///< mm
    QColor color;
    float width = 1;  ///< pixels
    float hidden = 0; ///< share of its opacity behind the cover
    float casing = 0; ///< dark border at both sides, pixels
};

/// A round handle.
struct SurfaceDot {
    Eigen::Vector3f at = Eigen::Vector3f::Zero();
    QColor fill;
    QColor rim;
    float radius = 4; ///< pixels
    float hidden = 0.5F;
};

struct SurfaceScene {
    struct PatchLook {
        ElementId patch{};
        QColor fabric;
        QColor tint;        ///< with its opacity: hovered, selected
        FabricMapsPtr maps; ///< instead of the plain colour, unless null
        double turn = 0;    ///< of the maps' x direction in outline coordinates, radians, counter-clockwise
    };
    /// Dots of constant size in the picture.
    struct PointsLook {
        std::shared_ptr<const std::vector<Eigen::Vector3f>> points; ///< mm
        QColor color;
        float size = 2;                                             ///< pixels
        std::shared_ptr<const std::vector<std::uint32_t>> own = {}; ///< 0xRRGGBB of each; null: all in `color`

        /// As opaque as `color`.
        QColor colorOf(std::size_t point) const;

        friend bool operator==(const PointsLook&, const PointsLook&) = default;
    };
    using FrameLook = SoftwareRenderer::Request::FrameLook;

    SurfaceMeshPtr surface; ///< null: no cover
    CoverMeshPtr cover;     ///< drawn in its place, with the same patches; null: not refined yet
    TrimMeshPtr trims;      ///< stitches and piping on it; may be null
    std::vector<PatchLook> patches;
    std::map<ElementId, FabricMapsPtr> fabrics; ///< what piping is made of; others are plain
    std::vector<FrameLook> frames;
    std::vector<FrameSkinPtr> frameSkins; ///< of each frame; null until it is made
    SurfaceMeshPtr skinned;               ///< the cover under which they are pressed
    std::vector<PointsLook> points;       ///< of scans
    SurfaceMapPtr map;                    ///< null, or of another topology: plain cloth
    std::vector<SurfaceLine> lines;
    std::vector<SurfaceDot> dots;
    std::uint64_t marks = 0;                           ///< different when lines or dots are
    std::shared_ptr<const SurfaceOcclusion> occlusion; ///< may be null, or of another topology

    Box3 box;         ///< of cover, frames and curves
    double floor = 0; ///< height of the ground

    std::optional<SectionPlane> section; ///< of cover and frames; lines, dots and points are cut already
    double frameOpacity = 1;             ///< where there is a cover; without one they are solid

    bool checker = true;
    bool meshEdges = false;
    bool ground = true;
    bool dimmed = false;
    ViewColors colors;

    /// The look of a patch, or null.
    const PatchLook* look(ElementId patch) const;
    QColor backgroundTop() const;
    QColor backgroundBottom() const;
};

/// The frames' points where they stand, mm.
std::vector<Vec3> placedPoints(const SurfaceScene::FrameLook& frame);

} // namespace bolster
