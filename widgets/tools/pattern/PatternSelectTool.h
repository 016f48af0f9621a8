// Selects, moves and turns in the pattern view.
#pragma once

#include "DartDrag.h"
#include "NudgeSeries.h"
#include "StretchEndDrag.h"

#include <QCoreApplication>

#include <optional>

namespace bolster {

/// Click selects, Shift adds, a drag from nothing selects a box. A click on an outline selects the edge there with
/// its patch or seam; a selected edge is dragged. Control points are dragged together, patches by their inside,
/// turned by the handle above the selection, ends of selected seams along the outline, selected darts by their tip
/// and mouth, labels of pieces where cut lines are shown. A double click on an outline or line inserts a control
/// point, arrow keys move by 1 mm (Shift: 10 mm).
class PatternSelectTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(PatternSelectTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer& pointer) override;
    void doubleClick(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& event) override;
    bool wants(int key) const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

    /// Where the handle for turning is, in pixels, if there is one.
    std::optional<QPointF> turnHandle() const;
    /// Where a handle for scaling is, in pixels, if there is one: beside that corner of the selection's box.
    std::optional<QPointF> scaleHandle(Box2::CornerType corner) const;

private:
    void select(const PatternPointer& pointer);
    bool isOnlySelected(const PatternHit& hit) const;
    void selectClicked();
    std::unique_ptr<PatternDrag> newDrag() const;
    std::set<std::pair<ElementId, int>> allPoints(ElementId line) const;
    bool keyDuringDrag(const QKeyEvent& event);
    void paintEdges(QPainter& painter, const ViewColors& colors) const;
    void hover(QPointF pixel);
    ElementId labelUnder(const PatternHit& hit, QPointF pixel) const;
    Box2 selectedBox() const;
    bool onTurnHandle(QPointF pixel) const;
    std::optional<Box2::CornerType> scaleHandleAt(QPointF pixel) const;

    PatternHit m_hover;
    bool m_overHandle = false;
    std::optional<Box2::CornerType> m_overCorner;
    std::optional<StretchEndHandle> m_overEnd;
    std::optional<DartHandle> m_overDart;
    ElementId m_overLabel = noElement; ///< of this patch

    std::optional<PatternPointer> m_pressed;
    PatternHit m_pressedHit;
    bool m_pressedHandle = false;
    std::optional<Box2::CornerType> m_pressedCorner;
    std::optional<StretchEndHandle> m_pressedEnd;
    std::optional<DartHandle> m_pressedDart;
    ElementId m_pressedLabel = noElement;
    bool m_onSelectedEdge = false;
    std::optional<QPointF> m_lastClick; ///< where the button was let go without a drag
    bool m_clickedAgain = false;        ///< at the same place
    bool m_alreadySelected = false;     ///< a click without a drag then selects only this
    std::unique_ptr<PatternDrag> m_drag;

    NudgeSeries<Vec2> m_nudges;
};

} // namespace bolster
