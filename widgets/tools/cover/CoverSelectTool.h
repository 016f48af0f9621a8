// Selects in the 3D view and moves control points of curves.
#pragma once

#include "CoverPointDrag.h"
#include "NudgeSeries.h"
#include "PlacementGizmo.h"

#include <QCoreApplication>

#include <memory>

namespace bolster {

/// Click selects, Shift adds. What has a place in space gets handles when it is selected. Control points are
/// dragged together; a double click on a curve inserts one, Delete removes the selected ones, arrow keys move them
/// by 1 mm (Shift: 10 mm) along the axes that run across the screen, Page Up and Page Down along the third.
class CoverSelectTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(CoverSelectTool)

public:
    using CoverTool::CoverTool;

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    void doubleClick(const CoverPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override;
    std::optional<std::pair<ElementId, int>> hoveredPoint() const override;
    std::vector<SceneLine> guides() const override;

private:
    void select(const CoverPointer& pointer);
    bool drag(const CoverPointer& pointer);
    void removePoints();
    bool startNudge(const QKeyEvent& event);

    CoverHit m_hover;
    std::optional<CoverPointer> m_pressed;
    CoverHit m_pressedHit;
    bool m_alreadySelected = false; ///< a click without a drag then selects only this
    std::unique_ptr<CoverPointDrag> m_drag;
    PlacementGizmo m_gizmo{m_context};

    NudgeSeries<Vec3> m_nudges;
};

} // namespace bolster
