// Handles that move and turn whatever has a place in space: frames, foam ...
#pragma once

#include "CoverTool.h"
#include "Gesture.h"

#include <QCoreApplication>

#include <memory>

namespace bolster {

/// Shown around the one selected element that has a Placement: an arrow and a ring for each of the world's axes,
/// and a square in the middle that moves it parallel to the picture. Ctrl snaps to 10 mm and 15 degrees. Always
/// computed from the placement at the press; Escape or destruction restores it.
class PlacementGizmo {
    Q_DECLARE_TR_FUNCTIONS(PlacementGizmo)

public:
    explicit PlacementGizmo(CoverToolContext& context)
        : m_context(context)
    {}

    /// True: a handle was grabbed.
    bool press(const CoverPointer& pointer);
    /// True: the pointer is on a handle, or drags one.
    bool move(const CoverPointer& pointer);
    void release(const CoverPointer& pointer);
    bool dragging() const { return m_drag != nullptr; }
    bool hovering() const { return m_hovered.kind != Handle::Kind::None; }
    void cancel();

    QString prompt() const;
    std::vector<SceneLine> guides() const;

private:
    struct Handle {
        enum class Kind { None, Arrow, Ring, Middle };
        Kind kind = Kind::None;
        int axis = 0;
        friend bool operator==(const Handle&, const Handle&) = default;
    };
    /// A handle as it is drawn and hit.
    struct Shape {
        Handle handle;
        std::vector<Vec3> points;
    };
    struct Drag {
        Drag(Document& document, ElementId subject, const Vec3& about, const CoverPointer& grabbed)
            : gesture(document)
            , element(subject)
            , pivot(about)
            , pressed(grabbed)
        {}
        Gesture gesture;
        ElementId element;
        Vec3 pivot;
        CoverPointer pressed;
        Vec3 moved = Vec3::Zero();
        double turned = 0; ///< radians
    };

    std::optional<ElementId> subject() const;
    Vec3 pivot(ElementId id) const;
    std::vector<Shape> shapes(const Vec3& pivot) const;
    Handle handleAt(QPointF pixel) const;
    void update(const CoverPointer& pointer);
    Vec3 wayOf(const CoverPointer& pointer) const;
    double angleOf(const CoverPointer& pointer) const;

    CoverToolContext& m_context;
    Handle m_hovered; ///< or dragged
    std::unique_ptr<Drag> m_drag;
};

} // namespace bolster
