// A tool of the pattern view: turns pointer and key events into edits.
#pragma once

#include "PatternScene.h"
#include "PatternTransform.h"
#include "Snapper.h"
#include "SurfaceMesh.h"
#include "ViewTool.h"

class QPainter;

namespace bolster {

struct BackgroundPicture;
struct CutPattern;
struct ViewColors;

/// What a tool may see of the view it works in.
class PatternToolContext : public ViewToolContext {
public:
    virtual const PatternScene& scene() const = 0;
    virtual const PatternTransform& transform() const = 0;
    virtual PatternHit hit(QPointF pixel) const = 0;
    virtual bool pointsShown(ElementId id) const = 0;
    virtual const SnapSettings& snapSettings() const = 0;
    /// A drag from nothing selects in a loop, not in a box.
    virtual bool lasso() const = 0;
    /// Behind the pattern; repaints after a change.
    virtual const BackgroundPicture& background() const = 0;
    virtual void setBackground(const BackgroundPicture& picture) = 0;
    /// What the solver made last, or null.
    virtual SurfaceMeshPtr surface() const = 0;
    /// The production pattern while its layer is shown, or null.
    virtual const CutPattern* cut() const = 0;
};

/// The pointer of the left button.
struct PatternPointer {
    QPointF pixel;
    Vec2 layout = Vec2::Zero(); ///< mm
    Qt::KeyboardModifiers modifiers;
};

class PatternTool : public ViewTool {
public:
    explicit PatternTool(PatternToolContext& context)
        : m_context(context)
    {}

    virtual void press(const PatternPointer& pointer) = 0;
    /// With the button down or not.
    virtual void move(const PatternPointer& pointer) = 0;
    virtual void release(const PatternPointer&) {}
    virtual void doubleClick(const PatternPointer&) {}

    /// On top of the pattern, in pixels.
    virtual void paint(QPainter& painter, const ViewColors& colors) const = 0;

protected:
    PatternToolContext& m_context;
};

} // namespace bolster
