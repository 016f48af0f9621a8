// What can be dragged in the pattern view. Each drag is computed from the state at the press.
#pragma once

#include "Gesture.h"
#include "PatternTool.h"

#include <memory>

namespace bolster {

class PatternDrag {
public:
    explicit PatternDrag(PatternToolContext& context, const PatternPointer& from)
        : m_context(context)
        , m_from(from)
    {}
    virtual ~PatternDrag() = default; ///< takes the drag back unless it was finished

    virtual void update(const PatternPointer& pointer) = 0;
    virtual void finish() = 0;
    /// Numbers that are typed meanwhile; true: used.
    virtual bool keyPress(const QKeyEvent&) { return false; }
    virtual bool wants(int) const { return false; }
    /// Gives up what is typed; false when nothing is.
    virtual bool clearTyped() { return false; }
    virtual bool active() const { return true; } ///< false: somebody else ended it (undo)
    virtual QString prompt() const = 0;
    virtual Qt::CursorShape cursor() const = 0;
    virtual void paint(QPainter&, const ViewColors&) const {}

protected:
    /// From the press to the pointer, mm; with Shift only along the longer axis.
    Vec2 moved(const PatternPointer& pointer) const;

    PatternToolContext& m_context;
    PatternPointer m_from;
};

/// Moves these control points, given as in Selection.
std::unique_ptr<PatternDrag> dragPoints(PatternToolContext& context, const PatternPointer& from,
                                        std::set<std::pair<ElementId, int>> points);
/// Moves the selected patches in the layout.
std::unique_ptr<PatternDrag> dragPatches(PatternToolContext& context, const PatternPointer& from);
/// Turns the selected patches about the middle of their common box; with Shift in steps of 15 degrees.
std::unique_ptr<PatternDrag> turnPatches(PatternToolContext& context, const PatternPointer& from);
/// Scales the selected patches by dragging this corner of their common box; with Shift alike in both directions.
/// Typed: "300 x 200", "300" (wide, in proportion) or "120 %". So are the ways of the others, and their angle.
std::unique_ptr<PatternDrag> scalePatches(PatternToolContext& context, const PatternPointer& from,
                                          Box2::CornerType corner);
/// Selects the control points and patches in a box; with Shift it adds them.
std::unique_ptr<PatternDrag> selectBox(PatternToolContext& context, const PatternPointer& from);
/// The same in a loop that is drawn by hand.
std::unique_ptr<PatternDrag> selectLasso(PatternToolContext& context, const PatternPointer& from);

} // namespace bolster
