// A drag of control points of curves through space.
#pragma once

#include "Gesture.h"
#include "SurfaceTool.h"

#include <set>

namespace bolster {

/// Moves control points (given as in Selection) of several curves in space by `delta`, mm.
Edit moveCurvePointsTogether(const Design& design, const std::set<std::pair<ElementId, int>>& points,
                             const Vec3& delta);

/// In the plane through the grabbed point parallel to the screen, or along an axis. Always computed from the design
/// at the press.
class SurfacePointDrag {
public:
    enum class Axis { None, X, Y, Z };

    SurfacePointDrag(SurfaceToolContext& context, const SurfacePointer& pressed, const Vec3& grabbed);

    bool active() const { return m_gesture.active(); }
    void update(const SurfacePointer& pointer);
    /// The same key again frees the drag.
    void constrain(Axis axis);
    void finish() { m_gesture.commit(); }

    /// Along which the point moves now.
    Axis axis() const { return m_axis; }
    Vec3 delta() const { return m_delta; }
    QString prompt() const;
    std::vector<SurfaceLine> guides() const;

private:
    void apply();
    Vec3 alongAxis(Axis axis) const;
    Vec3 grabbedNow() const { return m_grabbed + m_delta; }

    SurfaceToolContext& m_context;
    Gesture m_gesture;
    std::set<std::pair<ElementId, int>> m_points;
    SurfacePointer m_pressed;
    SurfacePointer m_now;
    Vec3 m_grabbed;
    Axis m_wanted = Axis::None; ///< by a key
    Axis m_axis = Axis::None;
    Vec3 m_delta = Vec3::Zero();
};

} // namespace bolster
