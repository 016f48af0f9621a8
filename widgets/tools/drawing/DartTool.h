// Cuts a dart by three clicks: both ends of its mouth, then its tip.
#pragma once

#include "DartEdits.h"
#include "PatternTool.h"
#include "TypedEntry.h"

#include <QCoreApplication>

namespace bolster {

/// The ends of the mouth lie on one outline, best in corners and middles of edges, and a whole number of
/// millimetres apart; the tip snaps to where both legs are of one length. Ctrl and Alt let go, Shift keeps the legs
/// equal. What is typed is the width of the mouth, then the depth. Backspace and Escape take back a click, then the
/// tool.
class DartTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(DartTool)

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
    /// What it has been begun on, or what the pointer is at; null when it is gone.
    const Patch* patch() const;
    ElementId outlineAtPointer() const;
    void pointerMoved();
    void findMouth();
    void findTip();
    void accept();
    void add();
    void takeBack();
    std::optional<edits::DartShape> shape() const;

    std::optional<PatternPointer> m_pointer; ///< while it is over the view
    TypedEntry m_typed;
    bool m_typedGood = false;
    ElementId m_patch{};          ///< of the first click; before it what the pointer is at
    std::vector<double> m_ends;   ///< of the mouth, clicked: parameters of the outline
    std::optional<double> m_next; ///< the end that a click would set
    std::optional<Vec2> m_tip;    ///< that a click would set, outline coordinates
    Message m_problem;            ///< why there can be no such dart
};

} // namespace bolster
