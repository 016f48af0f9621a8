// A drag of control points of curves through space.
#pragma once

#include "CoverTool.h"
#include "Gesture.h"

#include <set>

namespace bolster {

/// Moves control points (given as in Selection) of several curves in space by `delta`, mm.
Edit moveCurvePointsTogether(const Design& design, const std::set<std::pair<ElementId, int>>& points,
                             const Vec3& delta);

/// On the surface of the frame when the grabbed point of a fixation curve lies within 2 mm of it, else in the plane
/// through the point parallel to the screen; or along an axis. Ctrl or Alt lifts off the frame along its normal.
/// Always computed from the design at the press.
class CoverPointDrag {
public:
    enum class Axis { None, X, Y, Z };

    CoverPointDrag(CoverToolContext& context, const CoverPointer& pressed, const Vec3& grabbed);

    bool active() const { return m_gesture.active(); }
    void update(const CoverPointer& pointer);
    /// The same key again frees the drag.
    void constrain(Axis axis);
    /// Keeps to the frame, at the distance that the point has from it, or lets go of it.
    void toggleSurface();
    void finish() { m_gesture.commit(); }

    /// Along which the point moves now.
    Axis axis() const { return m_axis; }
    bool onSurface() const { return m_onSurface; }
    Vec3 delta() const { return m_delta; }
    QString prompt() const;
    std::vector<SceneLine> guides() const;

private:
    struct Lift {
        CoverPointer from;
        Vec3 delta = Vec3::Zero();
        Vec3 normal = Vec3::UnitZ();
    };

    void apply();
    Vec3 wanted();
    Edit edit() const;
    bool liftWanted() const { return m_now.modifiers & (Qt::ControlModifier | Qt::AltModifier); }
    Vec3 parallel() const;
    std::optional<Vec3> alongSurface() const;
    Vec3 lifted() const;
    Vec3 alongAxis(Axis axis) const;
    QString hint() const;
    Vec3 grabbedNow() const { return m_grabbed + m_delta; }

    CoverToolContext& m_context;
    Gesture m_gesture;
    std::set<std::pair<ElementId, int>> m_points;
    CoverPointer m_pressed;
    CoverPointer m_now;
    Vec3 m_grabbed;
    Axis m_wanted = Axis::None; ///< by a key
    Axis m_axis = Axis::None;
    Vec3 m_delta = Vec3::Zero();
    bool m_onSurface = false;
    bool m_visible = false;     ///< the frame under the grabbed point: rays through the pointer find it
    double m_height = 0;        ///< of the grabbed point above the frame that is kept, mm
    std::optional<Lift> m_lift; ///< while a modifier is held down
};

} // namespace bolster
