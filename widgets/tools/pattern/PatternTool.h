// A tool of the pattern view: turns pointer and key events into edits.
#pragma once

#include "PatternScene.h"
#include "PatternTransform.h"
#include "Snapper.h"
#include "SurfaceMesh.h"
#include "ToolKey.h"

#include <QCursor>
#include <QString>

class QKeyEvent;
class QPainter;

namespace bolster {

struct BackgroundPicture;
class Document;
class Selection;
struct ViewColors;

/// What a tool may see of the view it works in.
class PatternToolContext {
public:
    virtual ~PatternToolContext() = default;

    virtual Document& document() = 0;
    virtual Selection& selection() = 0;
    virtual const PatternScene& scene() const = 0;
    virtual const PatternTransform& transform() const = 0;
    virtual PatternHit hit(QPointF pixel) const = 0;
    virtual bool pointsShown(ElementId id) const = 0;
    /// Prompt, cursor or what the tool draws has changed.
    virtual void refresh() = 0;
    virtual const SnapSettings& snapSettings() const = 0;
    /// A drag from nothing selects in a loop, not in a box.
    virtual bool lasso() const = 0;
    /// Behind the pattern; repaints after a change.
    virtual const BackgroundPicture& background() const = 0;
    virtual void setBackground(const BackgroundPicture& picture) = 0;
    /// What the solver made last, or null.
    virtual SurfaceMeshPtr surface() const = 0;
    /// The tool has done its work: back to selecting, when its event is over.
    virtual void endTool() = 0;
    /// Something that could not be done, in the user's words.
    virtual void report(const QString& problem) = 0;
};

/// The pointer of the left button.
struct PatternPointer {
    QPointF pixel;
    Vec2 layout = Vec2::Zero(); ///< mm
    Qt::KeyboardModifiers modifiers;
};

class PatternTool {
public:
    explicit PatternTool(PatternToolContext& context)
        : m_context(context)
    {}
    virtual ~PatternTool() = default;

    virtual void press(const PatternPointer& pointer) = 0;
    /// With the button down or not.
    virtual void move(const PatternPointer& pointer) = 0;
    virtual void release(const PatternPointer&) {}
    virtual void doubleClick(const PatternPointer&) {}
    virtual bool keyPress(const QKeyEvent&) { return false; } ///< true: used
    virtual bool keyRelease(const QKeyEvent&) { return false; }
    /// Keys that are the tool's even where a window gives them another meaning.
    virtual bool wants(int) const { return false; }
    /// What can be done with what has been begun; empty: nothing has.
    virtual ToolKeys keys() const { return {}; }
    /// One step back; false when there was none.
    virtual bool escape() = 0;
    /// The pointer has left the view, or the view the keyboard.
    virtual void leave() {}

    virtual QString prompt() const = 0;
    virtual QCursor cursor() const = 0;
    /// On top of the pattern, in pixels.
    virtual void paint(QPainter& painter, const ViewColors& colors) const = 0;

protected:
    PatternToolContext& m_context;
};

} // namespace bolster
