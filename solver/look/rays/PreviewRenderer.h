// Pictures of a cover without a display: Embree rays, OpenImageIO output. The same picture on every run.
#pragma once

#include "Scene.h"
#include "Viewpoint.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

namespace bolster {

struct RayCamera : Viewpoint {
    RayCamera() = default;
    explicit RayCamera(const Viewpoint& from)
        : Viewpoint(from)
    {}

    Vec3 eye() const;
    /// From the front and a little to the side and above, so that the whole box is seen. `front` is the azimuth
    /// from which the front is seen (frontAzimuth of MeshShape.h).
    static RayCamera threeQuarter(const Box3& box, double aspect, double front = 0);
    /// The whole box from this direction; `aspect` is width over height of the picture.
    static RayCamera around(const Box3& box, double aspect, double azimuth, double elevation);
};

/// The whole scene from its front, a little to the side and above.
RayCamera threeQuarterView(const Scene& scene, double aspect);

struct PreviewImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 bytes per pixel, top row first; sRGB; colours not times the opacity
    std::vector<float> light; ///< on demand: the same as linear light, times the opacity; not bent to be displayed
    std::vector<float> depth; ///< on demand: mm along the view direction; infinite where only the background is

    bool empty() const { return rgba.empty(); }
};

inline constexpr int largestPictureSide = 16384; ///< pixels

struct PreviewOptions {
    int width = 1280;
    int height = 960;
    int samples = 4;          ///< rays per pixel, a square number (others: the next smaller one)
    int threads = 0;          ///< 0: as many as the machine has; the picture does not depend on it
    bool quick = false;       ///< without shadows, for a picture that follows the pointer
    bool depth = false;       ///< give the depths, too
    bool light = false;       ///< give linear light, too
    bool transparent = false; ///< no background: opaque where the cover is, and black where its shadow falls
    /// Called with the share that is done, 0 to 1, by one thread at a time, which need not be the caller's.
    std::function<void(double)> progress = {};
};

/// A scene that is looked at more than once: the constructor prepares it, `render` is const.
class PreviewRenderer {
public:
    explicit PreviewRenderer(const Scene& scene);
    ~PreviewRenderer();
    PreviewRenderer(PreviewRenderer&&) noexcept;
    PreviewRenderer& operator=(PreviewRenderer&&) noexcept;

    /// An empty image when cancelled, or when the size is not positive or over largestPictureSide.
    PreviewImage render(const RayCamera& view, const PreviewOptions& options, std::stop_token stop = {}) const;

private:
    class Prepared;
    std::unique_ptr<const Prepared> m_prepared;
};

/// The same in one call.
PreviewImage renderPreview(const Scene& scene, const RayCamera& view, const PreviewOptions& options,
                           std::stop_token stop = {});

} // namespace bolster
