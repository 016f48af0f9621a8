// Draws handle curves, fancy seams and internal lines into a patch.
#pragma once

#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// What PatternDrawTool makes of a curve.
enum class DrawnKind { HandleCurve, FancySeam, InternalLine };

/// Clicks set control points, within reach of the outline on it; Shift keeps to an axis. A double click or Enter
/// ends the curve, a click on its first point closes it. B switches between straight and smooth, Backspace takes
/// back a point, Escape the curve, then the tool.
class PatternDrawTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(PatternDrawTool)

public:
    PatternDrawTool(PatternToolContext& context, DrawnKind kind)
        : PatternTool(context)
        , m_kind(kind)
        , m_smooth(kind == DrawnKind::HandleCurve)
    {}

    DrawnKind kind() const { return m_kind; }

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void doubleClick(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    const Patch* patch() const;
    Snapped snapped(const PatternPointer& pointer) const;
    bool closes(const PatternPointer& pointer) const;
    void finish(bool closed);
    Edit edit(BSpline2 curve) const;

    DrawnKind m_kind;
    bool m_smooth;
    ElementId m_patch{};
    std::vector<Vec2> m_points;    ///< in the layout, mm
    std::optional<Vec2> m_next;    ///< under the pointer
    std::vector<SnapHint> m_hints; ///< why it is there
    bool m_closing = false;        ///< a click now closes the curve
};

} // namespace bolster
