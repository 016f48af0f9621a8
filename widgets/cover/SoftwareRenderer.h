// What draws the cover where there is no OpenGL. The program hands one in: the views know no ray caster.
#pragma once

#include "Camera.h"
#include "CoverMesh.h"
#include "FabricMaps.h"
#include "Frame.h"
#include "FrameSkin.h"
#include "SectionPlane.h"
#include "SurfaceMap.h"
#include "SurfaceMesh.h"
#include "TriangleMesh.h"
#include "TrimMesh.h"

#include <QColor>
#include <QImage>

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace bolster {

class SoftwareRenderer {
public:
    struct Request {
        struct PatchLook {
            ElementId patch{};
            QColor color;
            FabricMapsPtr maps = nullptr; ///< instead of the colour, unless null
            double turn = 0; ///< of the maps' x direction in outline coordinates, radians, counter-clockwise

            friend bool operator==(const PatchLook&, const PatchLook&) = default;
        };
        struct FrameLook {
            std::shared_ptr<const TriangleMesh> mesh;
            Placement placement;
            FrameMaterial material = {};
            double opacity = 1;          ///< times that of all
            FrameSkinPtr skin = nullptr; ///< drawn in its place; null until it is known how the cover lies on it

            friend bool operator==(const FrameLook&, const FrameLook&) = default;
        };

        SurfaceMeshPtr surface; ///< may be null
        TrimMeshPtr trims;      ///< stitches and piping on it; may be null
        CoverMeshPtr cover;     ///< drawn in its place, with the same patches; null: not refined yet
        std::vector<PatchLook> looks;
        std::map<ElementId, FabricMapsPtr> fabrics; ///< what piping is made of; others are plain
        SurfaceMapPtr map;                          ///< null, or of another topology: plain cloth
        std::vector<FrameLook> frames;
        double frameOpacity = 1; ///< where there is a cover; without one they are solid
        std::optional<SectionPlane> section;
        Camera camera; ///< its size is the size of the picture
        QColor backgroundTop;
        QColor backgroundBottom;
        bool checker = true;
        bool ground = true;
        bool moving = false; ///< something moves: quick before beautiful

        friend bool operator==(const Request&, const Request&) = default;
    };
    struct Picture {
        QImage image; ///< null when stopped
        std::vector<float>
            depth; ///< Camera::depth of each pixel, row by row from the top; infinite where nothing is
    };

    virtual ~SoftwareRenderer() = default;
    /// Called on a worker thread, one call at a time.
    virtual Picture render(const Request& request, std::stop_token stop) = 0;
};

} // namespace bolster
