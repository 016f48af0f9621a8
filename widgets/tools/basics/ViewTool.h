// What the tools of both views have in common.
#pragma once

#include "ToolKey.h"

#include <QCursor>
#include <QString>

class QKeyEvent;

namespace bolster {

class Document;
class Selection;

/// What any tool may see of the view it works in.
class ViewToolContext {
public:
    virtual ~ViewToolContext() = default;

    virtual Document& document() = 0;
    virtual Selection& selection() = 0;
    /// Prompt, cursor or what the tool draws has changed.
    virtual void refresh() = 0;
    /// Something that could not be done, in the user's words.
    virtual void report(const QString& problem) = 0;
    /// The tool has done its work: back to selecting, when its event is over.
    virtual void endTool() = 0;
};

class ViewTool {
public:
    virtual ~ViewTool() = default;

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
};

} // namespace bolster
