// What the 3D view shows, as a value that both of its canvases draw.
#pragma once

#include "CoverOcclusion.h"
#include "Scene.h"
#include "ViewColors.h"

#include <map>
#include <memory>
#include <vector>

namespace bolster {

/// A line of constant width in the picture.
struct SceneLine {
    std::vector<Eigen::Vector3f> points; ///< mm
    QColor color;
    float width = 1;  ///< pixels
    float hidden = 0; ///< share of its opacity behind the cover
    float casing = 0; ///< dark border at both sides, pixels
};

/// A round handle.
struct SceneDot {
    Eigen::Vector3f at = Eigen::Vector3f::Zero();
    QColor fill;
    QColor rim;
    float radius = 4; ///< pixels
    float hidden = 0.5F;
};

/// What a window beside the view shows in it.
struct GuestMarks {
    std::vector<SceneLine> lines;
    std::vector<SceneDot> dots;
    std::vector<std::vector<Vec3>> catching = {}; ///< mm: rows of places to which curves are drawn when near

    bool isEmpty() const { return lines.empty() && dots.empty() && catching.empty(); }
};

/// What is drawn, and what only a window draws over it.
struct ViewScene : Scene {
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

    /// In the colours of a light theme.
    ViewScene();
    /// The background's, too.
    void setColors(const ViewColors& of);

    std::map<ElementId, QColor> tints;               ///< of patches, with their opacity: hovered, selected
    SurfaceMeshPtr skinned;                          ///< the cover under which the frames are pressed
    std::vector<PointsLook> points;                  ///< of scans; cut already
    std::vector<SceneLine> lines;                    ///< cut already
    std::vector<SceneDot> dots;                      ///< likewise
    std::uint64_t marks = 0;                         ///< different when lines or dots are
    std::shared_ptr<const CoverOcclusion> occlusion; ///< may be null, or of another topology

    Box3 box;         ///< of cover, frames and curves
    double floor = 0; ///< height of the ground

    bool meshEdges = false;
    bool dimmed = false;
    ViewColors colors;

    /// What lies over everything that is not up to date.
    QColor veil() const;
};

/// Of a colour as the design writes it, "#rrggbb".
QColor colorOf(const std::string& written);

} // namespace bolster
