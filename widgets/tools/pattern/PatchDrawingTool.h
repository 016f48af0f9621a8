// What the tools that draw patches have in common.
#pragma once

#include "PatternTool.h"
#include "TypedEntry.h"

#include <QCoreApplication>

namespace bolster {

/// Where the pointer comes to lie in the layout: snapped to what is near, unless Ctrl or Alt is held down.
Snapped snappedPointer(const PatternToolContext& context, const PatternPointer& pointer, SnapQuery query = {});

/// Snaps the pointer, reads typed numbers and makes a patch of an outline.
class PatchDrawingTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(PatchDrawingTool)

public:
    using PatternTool::PatternTool;

    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;
    QCursor cursor() const override { return Qt::CrossCursor; }

protected:
    virtual bool begun() const = 0;
    virtual void giveUp() = 0;       ///< what was begun
    virtual void takeBack() = 0;     ///< the last point
    virtual void enter() = 0;        ///< what was typed, or the end of the drawing
    virtual void pointerMoved() = 0; ///< m_pointer or what was typed has changed

    /// Adds the patch, selects it and ends the tool; says why not, if not.
    bool finish(const std::optional<BSpline2>& outline);
    /// The name of the next patch that nobody has yet.
    std::string freeName() const;

    std::optional<PatternPointer> m_pointer; ///< while it is over the view
    TypedEntry m_typed;
};

} // namespace bolster
