// The scans that the 3D view shows.
#pragma once

#include "ScanPoints.h"

#include <utility>
#include <vector>

namespace bolster {

class Selection;
class SceneVisibility;

/// Fills in the points of a scene.
class ShownScans {
public:
    /// The scene must outlive it.
    explicit ShownScans(ViewScene& scene)
        : m_scene(scene)
    {}

    void setOpacity(double opacity) { m_opacity = opacity; } ///< 0 to 1; until the next update: as before
    /// On the cover, and of the scan, mm.
    void setPairs(std::vector<std::pair<Vec3, Vec3>> pairs) { m_pairs = std::move(pairs); }

    /// Cut where the scene's section cuts. Beside a map there are none: it says more, and would be hidden.
    void update(const Design& design, const DesignFiles& files, const Selection& selection,
                const SceneVisibility& visibility);
    /// Lines from the places to their points, uncut.
    void addPairs();

    const ScanPoints& points() const { return m_points; }

private:
    ViewScene& m_scene;
    ScanPoints m_points;
    std::vector<std::pair<Vec3, Vec3>> m_pairs;
    double m_opacity = 1;
};

} // namespace bolster
