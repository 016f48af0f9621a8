// Cuts a patch in two along a line.
#pragma once

#include "EditOutcome.h"
#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// Clicks set the points of the line, within reach of an outline on it, best in its corners; Shift keeps to an
/// axis. A double click or Enter splits the patch that the line's middle lies in, Backspace takes back a point,
/// Escape the line, then the tool.
class PatternSplitTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(PatternSplitTool)

public:
    using PatternTool::PatternTool;

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
    Vec2 snapped(const PatternPointer& pointer) const;
    edits::Outcome outcome(const std::vector<Vec2>& line) const;
    void changeLine();
    void finish();
    void paintLine(QPainter& painter, const QPolygonF& line, const ViewColors& colors) const;

    std::vector<Vec2> m_points; ///< in the layout, mm
    std::optional<Vec2> m_next; ///< under the pointer
    ElementId m_splits{};       ///< the patch that the line to the pointer would split, or none
};

} // namespace bolster
