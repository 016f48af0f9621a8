// Selects in the 3D view and moves control points of curves.
#pragma once

#include "NudgeSeries.h"
#include "PlacementGizmo.h"
#include "SurfacePointDrag.h"

#include <QCoreApplication>

#include <memory>

namespace bolster {

/// Click selects, Shift adds. What has a place in space gets handles when it is selected. Control points are
/// dragged together; a double click on a curve inserts one, Delete removes the selected ones, arrow keys move them
/// by 1 mm (Shift: 10 mm) along the axes that run across the screen, Page Up and Page Down along the third.
class SurfaceSelectTool : public SurfaceTool {
    Q_DECLARE_TR_FUNCTIONS(SurfaceSelectTool)

public:
    using SurfaceTool::SurfaceTool;

    void press(const SurfacePointer& pointer) override;
    bool move(const SurfacePointer& pointer) override;
    void release(const SurfacePointer& pointer) override;
    void doubleClick(const SurfacePointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override;
    std::optional<std::pair<ElementId, int>> hoveredPoint() const override;
    std::vector<SurfaceLine> guides() const override;

private:
    void select(const SurfacePointer& pointer);
    bool drag(const SurfacePointer& pointer);
    void removePoints();
    bool startNudge(const QKeyEvent& event);

    SurfaceHit m_hover;
    std::optional<SurfacePointer> m_pressed;
    SurfaceHit m_pressedHit;
    bool m_alreadySelected = false; ///< a click without a drag then selects only this
    std::unique_ptr<SurfacePointDrag> m_drag;
    PlacementGizmo m_gizmo{m_context};

    NudgeSeries<Vec3> m_nudges;
};

} // namespace bolster
