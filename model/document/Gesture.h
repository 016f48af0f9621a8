// One drag: provisional edits while the pointer moves, one commit on release, restored on Escape or destruction.
#pragma once

#include "Design.h"

namespace bolster {

class Document;

/// Every provisional edit is computed from `start()`, so there is no command merging. Only one gesture runs at a
/// time: beginning a second one cancels the first, whose calls then do nothing.
class Gesture {
public:
    enum class Purpose {
        Drag,   ///< what it shows is passing: the surface follows it
        Preview ///< what it shows is looked at: its surface is the one that a commit would have
    };
    explicit Gesture(Document& document, Purpose purpose = Purpose::Drag);
    ~Gesture(); ///< cancels unless committed
    Gesture(const Gesture&) = delete;
    Gesture& operator=(const Gesture&) = delete;

    bool active() const { return m_document != nullptr; }
    /// The design at the press.
    const Design& start() const { return m_start; }
    /// Shows start() with this edit and what it means for mirror twins.
    void update(Edit edit);
    /// Commits the last provisional edit; nothing if there was none. One that would break something
    /// (Document::breakage) is taken back instead, and Document::refused says why.
    void commit();
    void cancel();

    /// Nobody holds it now, but it may be taken up again: whatever would cancel it commits it (Document).
    void letGo() { m_letGo = true; }
    void takeUp() { m_letGo = false; }
    bool isLetGo() const { return m_letGo; }
    bool isPreview() const { return m_purpose == Purpose::Preview; }

private:
    friend class Document;
    Document* m_document;
    Design m_start;
    Edit m_edit;
    Purpose m_purpose;
    bool m_letGo = false;
};

} // namespace bolster
