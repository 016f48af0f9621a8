// Fixes stretches of outlines to the selected fixation curves.
#pragma once

#include "Document.h"
#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// A click takes the stretch through the selected points, the stretch of a seam or fixation, or the edge between
/// two corners, whichever lies there first. Shift collects several stretches that share a curve in a row; with
/// several curves selected one stretch is divided among them. Enter attaches what is collected, or the selected
/// stretch. Goes on until Escape: other edges, and other curves once they are selected.
class AttachTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(AttachTool)

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
    QCursor cursor() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    const Design& design() const { return m_context.document().design(); }
    std::vector<ElementId> curves() const;
    QString problemOf(const Stretch& stretch) const;
    void attach(const std::vector<Stretch>& stretches);
    Edit edit(const std::vector<Stretch>& stretches) const;

    std::optional<Stretch> m_hover;
    std::vector<Stretch> m_collected;
};

} // namespace bolster
