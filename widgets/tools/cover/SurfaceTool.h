// A tool of the 3D view: turns pointer and key events into edits.
#pragma once

#include "SurfaceHit.h"
#include "ToolKey.h"

#include <QCursor>
#include <QString>

class QKeyEvent;

namespace bolster {

class Document;

/// What a tool may see of the view it works in.
class SurfaceToolContext {
public:
    virtual ~SurfaceToolContext() = default;

    virtual Document& document() = 0;
    virtual Selection& selection() = 0;
    virtual const Camera& toolCamera() const = 0;
    virtual const ViewColors& colors() const = 0;
    virtual SurfaceHit hit(QPointF pixel) const = 0;
    /// What a curve drawn there would lie on: a frame, or the cover where there is none.
    virtual SurfaceHit ground(QPointF pixel) const = 0;
    /// The nearest place on a frame or on the cover (`on`).
    virtual std::optional<SurfaceFoot> nearest(const Vec3& point, SurfaceHit::Kind on) const = 0;
    /// Of what is shown of an element with a placement; its position when nothing is.
    virtual Vec3 middleOf(ElementId id) const = 0;
    /// Prompt, cursor or what the tool draws has changed.
    virtual void refresh() = 0;
    /// Something that could not be done, in the user's words.
    virtual void report(const QString& problem) = 0;
    /// The tool has done its work: back to selecting, when its event is over.
    virtual void endTool() = 0;
};

/// The pointer of the left button.
struct SurfacePointer {
    QPointF pixel;
    Qt::KeyboardModifiers modifiers;
};

/// What a tool writes beside the pointer.
struct SurfaceNote {
    QString text;
    QPointF beside;     ///< pixels
    bool typed = false; ///< a field in which the user types
    bool good = true;   ///< it can be understood

    friend bool operator==(const SurfaceNote&, const SurfaceNote&) = default;
};

class SurfaceTool {
public:
    explicit SurfaceTool(SurfaceToolContext& context)
        : m_context(context)
    {}
    virtual ~SurfaceTool() = default;

    virtual void press(const SurfacePointer& pointer) = 0;
    /// With the button down or not. False: a drag that is none of the tool's, so it may turn the view.
    virtual bool move(const SurfacePointer& pointer) = 0;
    virtual void release(const SurfacePointer& pointer) = 0;
    virtual void doubleClick(const SurfacePointer&) {}
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
    /// The control point under the pointer.
    virtual std::optional<std::pair<ElementId, int>> hoveredPoint() const { return std::nullopt; }
    virtual std::optional<SurfaceNote> note() const { return std::nullopt; }
    /// Drawn with the scene.
    virtual std::vector<SurfaceLine> guides() const { return {}; }

protected:
    SurfaceToolContext& m_context;
};

} // namespace bolster
