// Draws the outline of a new patch: polygon, spline or mixed.
#pragma once

#include "OutlineDraft.h"
#include "PatchDrawingTool.h"

namespace bolster {

/// A click sets a corner; press and drag sets a smooth point with its tangent (Shift: in steps of 45 degrees). A
/// click on the first point, Enter or a double click closes the outline. Typed numbers set the next corner.
/// Backspace takes back a point, Escape what is typed, then the outline, then the tool.
class OutlineTool : public PatchDrawingTool {
    Q_DECLARE_TR_FUNCTIONS(OutlineTool)

public:
    using PatchDrawingTool::PatchDrawingTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer& pointer) override;
    void doubleClick(const PatternPointer& pointer) override;

    QString prompt() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    bool begun() const override { return !m_points.empty(); }
    void giveUp() override;
    void takeBack() override;
    void enter() override;
    void pointerMoved() override;

    bool closes() const;
    void close();
    void pullHandle(const PatternPointer& pointer);
    void findProblem();
    std::vector<DraftPoint> shown() const;
    void paintHandles(QPainter& painter, const ViewColors& colors) const;
    void paintNotes(QPainter& painter, const ViewColors& colors) const;

    std::vector<DraftPoint> m_points; ///< in the layout, mm
    std::optional<Snapped> m_next;    ///< where the next point would come
    bool m_closing = false;           ///< a click now closes the outline
    bool m_typedGood = false;
    std::optional<QPointF> m_pressed; ///< the button is down on the last point
    QString m_problem;                ///< with what is drawn so far
};

} // namespace bolster
