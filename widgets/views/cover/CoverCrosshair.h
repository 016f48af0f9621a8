// The cross-hair on the cover: where the pattern view's pointer is.
#pragma once

#include "CoverPlaces.h"

class QWidget;

namespace bolster {

class Camera;
class Crosshair;
class ShownScene;

class CoverCrosshair {
public:
    /// All must outlive it.
    CoverCrosshair(ShownScene& shown, const Camera& camera, QWidget& view);

    /// Where the point lies on the cover; nothing takes it away.
    void show(const std::optional<CoverPoint>& point);
    /// Camera or section have changed.
    void place();
    /// The cover has moved: it stays with it.
    void follow() { show(m_point); }

private:
    ShownScene& m_shown;
    const Camera& m_camera;
    Crosshair* m_crosshair;            ///< the view's
    std::optional<CoverPoint> m_point; ///< its place in its patch
    std::optional<Vec3> m_place;       ///< and on the cover, mm
};

} // namespace bolster
