// Rotates the selected dart: it closes, and the pattern opens where somebody clicks.
#pragma once

#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// Shows the outline as it would be; corners and middles of edges catch, Ctrl and Alt let go.
class DartRotateTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(DartRotateTool)

public:
    explicit DartRotateTool(PatternToolContext& context);

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    ElementId m_seam; ///< of the dart
    std::optional<double> m_to;
    Edit m_edit; ///< what a click would do; empty: nothing
    Message m_problem;
};

} // namespace bolster
