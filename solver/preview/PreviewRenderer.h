// Pictures of a cover without a display: Embree rays, OpenImageIO output. The same picture on every run.
#pragma once

#include "SurfaceMesh.h"
#include "TriangleMesh.h"

#include <cstdint>
#include <optional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace bolster {

/// How the scene is looked at; z is up. Angles in radians.
struct PreviewView {
    Vec3 target = Vec3::Zero(); ///< mm
    double distance = 2000;     ///< from eye to target, mm
    double azimuth = -0.7;      ///< of the eye about z; 0 is the front (from -y), positive to the right (+x)
    double elevation = 0.35;    ///< of the eye above the horizontal plane
    double fieldOfView = 0.6;   ///< vertical
    bool perspective = true;

    Vec3 eye() const;
    /// From the front and a little to the side and above, so that the whole box is seen.
    static PreviewView threeQuarter(const Box3& box, double aspect);
};

struct PreviewScene {
    SurfaceMeshPtr surface;
    struct PatchLook {
        ElementId patch{};
        std::string color = "#7a4a2b";
    };
    std::vector<PatchLook> looks;
    struct FrameLook {
        std::shared_ptr<const TriangleMesh> mesh;
        double scale = 1;
        Vec3 position = Vec3::Zero();
        Quat rotation = Quat::Identity();
    };
    std::vector<FrameLook> frames; ///< drawn only where the renderer is asked to
    bool checker = true;
    double checkerSize = 20; ///< mm
    bool ground = true;
};

struct PreviewImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 bytes per pixel, top row first
};

struct PreviewOptions {
    int width = 1280;
    int height = 960;
    int samples = 4; ///< rays per pixel, a square number
    int threads = 0; ///< the picture does not depend on it
};

/// An empty image when cancelled.
PreviewImage renderPreview(const PreviewScene& scene, const PreviewView& view, const PreviewOptions& options,
                           std::stop_token stop = {});

/// Writes a PNG. Returns what went wrong, or "".
std::string writePng(const PreviewImage& image, const std::string& path);

} // namespace bolster
