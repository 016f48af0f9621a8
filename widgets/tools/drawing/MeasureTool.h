// Measures distances in the layout and lengths of edges.
#pragma once

#include "PatchPoint.h"
#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// Two clicks measure from point to point; over an outline it says how long the edge between two corners is. A
/// third click begins anew. Enter keeps the measure in the design, where both points are of patches. Escape gives
/// it up, then the tool.
class MeasureTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(MeasureTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    struct Edge {
        QPainterPath path; ///< in the layout, mm
        double length = 0; ///< mm
    };
    std::optional<Edge> edgeAt(const PatternPointer& pointer) const;
    std::optional<Vec2> end() const;
    QStringList figures() const;
    std::optional<PatchPoint> inPatch(const Vec2& layout) const;
    std::optional<std::pair<PatchPoint, PatchPoint>> kept() const;

    std::optional<Vec2> m_first;
    std::optional<Vec2> m_second;
    std::optional<Snapped> m_next;
    std::optional<PatternPointer> m_pointer;
    std::optional<Edge> m_edge;
};

} // namespace bolster
