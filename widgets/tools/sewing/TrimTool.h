// Gives seams, fixed stretches and free edges stitches.
#pragma once

#include "PatternTool.h"
#include "Stretch.h"

#include <QCoreApplication>

#include <optional>

namespace bolster {

/// A click on an edge that has no trim gives it a row of stitches; what is clicked is selected, so that the
/// inspector shows its stitches and piping.
class TrimTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(bolster::TrimTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    bool escape() override;
    void leave() override;
    QString prompt() const override;
    QCursor cursor() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    /// What is under the pointer: an element that can have a trim, or a stretch for a new one.
    struct Target {
        ElementId element = noElement;
        std::optional<Stretch> stretch;
    };

    Target targetAt(QPointF pixel) const;

    Target m_hover;
};

} // namespace bolster
