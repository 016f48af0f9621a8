// The arrow in the 3D view that moves the section.
#pragma once

#include "Camera.h"
#include "ViewScene.h"

#include <QCoreApplication>
#include <QPointF>

#include <array>

namespace bolster {

/// Two arrows across the plane, of constant size, at its upper edge if that is in the picture; with the button down
/// or the pointer on it, the plane's frame, too. Dragging moves the plane along its normal, with Ctrl it turns by
/// steps of 15 degrees. Always computed from the plane at the press.
class SectionHandle {
    Q_DECLARE_TR_FUNCTIONS(SectionHandle)

public:
    /// Both must outlive it. Nothing is there while the scene has no section.
    SectionHandle(const ViewScene& scene, const Camera& camera)
        : m_scene(scene)
        , m_camera(camera)
    {}

    /// The pointer without a button; true: it is on the handle.
    bool hover(QPointF pixel);
    bool hovering() const { return m_hovered || m_drag; }
    bool dragging() const { return m_drag.has_value(); }
    /// True: the handle was grabbed.
    bool press(QPointF pixel);
    /// While dragging: where the plane is to be.
    SectionPlane dragged(QPointF pixel, Qt::KeyboardModifiers modifiers) const;
    void release() { m_drag.reset(); }
    /// Ends the drag; where the plane was.
    SectionPlane cancel();
    void leave() { m_hovered = false; }

    QString prompt() const;
    std::vector<SceneLine> lines() const;

private:
    struct Drag {
        SectionPlane start;
        Vec3 anchor; ///< mm, in the plane
        QPointF pressed;
    };

    /// Where the arrows are, in the plane.
    Vec3 anchor() const;
    /// Along the normal; upwards in the picture when that points at the eye. Unit.
    Vec3 direction(const Vec3& anchor, const Vec3& normal) const;
    std::array<std::vector<Vec3>, 2> arrows() const;
    SectionPlane moved(QPointF pixel) const;
    SectionPlane turned(QPointF pixel) const;

    const ViewScene& m_scene;
    const Camera& m_camera;
    bool m_hovered = false;
    std::optional<Drag> m_drag;
};

} // namespace bolster
