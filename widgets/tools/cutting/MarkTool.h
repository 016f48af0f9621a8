// Places what a cutter needs: notches, drill holes, allowances of edges, corners of the cut line.
#pragma once

#include "PatternDrags.h"
#include "Stretch.h"
#include "TypedEntry.h"

#include <QCoreApplication>

namespace bolster {

enum class MarkKind { Notch, DrillHole, EdgeAllowance, CutCorner };

/// A click places one; one that is there is selected instead, and can be dragged. Typed: how far a notch is from
/// the nearer corner, where in its patch a hole lies, how wide an allowance is, of a new one or of the one under
/// the pointer; Enter takes it. The properties say what it is like.
class MarkTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(bolster::MarkTool)

public:
    MarkTool(PatternToolContext& context, MarkKind kind)
        : PatternTool(context)
        , m_kind(kind)
    {}

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    bool escape() override;
    void leave() override;
    QString prompt() const override;
    QCursor cursor() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    /// What a click would mean.
    struct Target {
        ElementId mark = noElement;  ///< one that is there; then the others say nothing
        ElementId patch = noElement; ///< a new one on it
        double at = 0;               ///< of the outline
        Vec2 place = Vec2::Zero();   ///< in the layout
        std::optional<Stretch> stretch;
    };

    Target targetAt(const PatternPointer& pointer) const;
    Edit edit(const Target& target, Message& problem) const;
    /// What the pointer is at, or what is typed.
    void find();
    void readTyped();
    /// What is typed says something of what the pointer is at.
    bool takesTyped() const;
    QString typedProblem() const;
    /// A number that is typed now would have nothing to be of, but the pointer is here.
    bool missesTarget(int key) const;
    QString pointFirst() const;
    void findEdge(const PatternPointer& pointer, const PatternHit& hit, Target& target) const;
    std::optional<Stretch> stretchOfCutLine(const PatternPointer& pointer) const;
    /// What a click or Enter means now: the mark that is there then, or none.
    ElementId place();
    QString hint() const;

    MarkKind m_kind;
    Target m_hover;
    std::optional<PatternPointer> m_pointer; ///< while it is over the view
    TypedEntry m_typed;
    bool m_typedGood = false;
    double m_typedWidth = 0;             ///< mm, of an allowance
    std::unique_ptr<PatternDrag> m_drag; ///< of what was pressed
    QPointF m_pressedAt;
    bool m_moved = false; ///< far enough to be a drag
};

} // namespace bolster
