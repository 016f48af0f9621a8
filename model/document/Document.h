// The current design, its history, and one signal.
#pragma once

#include "EditCheck.h"
#include "EditOutcome.h"
#include "HeldHistory.h"

#include <QObject>

#include <functional>
#include <optional>
#include <set>

namespace bolster {

class Gesture;

/// Ids of the elements that are different now.
using ChangeSet = std::set<ElementId>;

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// The design with the running gesture's edit, if there is one.
    const Design& design() const { return m_design; }
    /// The design at the history's current node, without a gesture's edit.
    const Design& committed() const { return m_base; }
    /// Increases with every change of design().
    std::uint64_t revision() const { return m_revision; }
    const History& history() const { return m_history; }

    /// A new design with a new history (open, new).
    void reset(Design design);
    /// That of a project, which holds all of it; `design` is that of the history's current node.
    void reset(Design design, History history);
    /// The edit takes along mirror twins and what lies on outlines. Does nothing with an empty edit. Cancels a
    /// running gesture first.
    void commit(Edit edit);
    /// The same, and says what it takes away besides; does nothing with one that is refused.
    void commit(edits::Outcome outcome);
    /// Asked before each edit; one that comes back with a reason is not made, see refused().
    void setRefusal(std::function<Message(const Edit&)> refusal) { m_refusal = std::move(refusal); }
    /// A running gesture is what undo and redo take back first, and nothing else.
    void undo();
    void redo();
    /// Does nothing when the way there cannot be read any more.
    void jumpTo(NodeId node);
    /// Versions that somebody else has made: History::takeIn. Whoever stores the history has them already.
    void takeIn(std::vector<History::Node> nodes, std::shared_ptr<StoredEdits> edits);
    /// New elements get larger ids than this, as they do than all that were seen: an id stands for one thing in all
    /// branches.
    void spendIds(ElementId upTo);
    /// A label in the history, "" for none. The design stays as it is.
    void nameVersion(NodeId node, std::string name);
    /// The same for the branch that begins with `node`.
    void nameBranch(NodeId node, std::string name);

    /// The file shows another design, or lacks something of what is here: versions, names. Saving it helps.
    bool dirty() const;
    /// Something that was made would be lost without asking. Merely standing elsewhere is nothing of that kind.
    bool hasUnsavedWork() const { return !holdsAllWork(m_held, m_history, mark()); }
    UnsavedWork unsavedWork() const { return bolster::unsavedWork(m_held, m_history, mark()); }
    /// history().mark(), at no cost.
    HistoryMark mark() const { return {m_history.current(), m_history.count(), m_names}; }
    /// What the file holds: all of an opened project, the design alone of anything else.
    const HeldHistory& held() const { return m_held; }
    /// Where the file stands.
    NodeId saved() const { return m_held.mark.current; }
    /// That is what the file holds from now on: as the document was when a save in the background began.
    void setHeld(HeldHistory held);
    /// The file is a project that holds all that is here now.
    void markSaved() { setHeld({mark(), false}); }

    bool gestureRunning() const { return m_gesture != nullptr; }
    /// The running gesture's edit is passing: something is being dragged.
    bool dragging() const;
    /// What the running gesture's edit would break, if anything: it is to be seen as invalid, not to be solved,
    /// and is taken back on release.
    const std::optional<edits::Breakage>& breakage() const { return m_breakage; }
    /// Takes back the running gesture, if there is one (undo during a drag, Escape). One that was let go is
    /// committed.
    void cancelGesture();
    /// Commits a gesture that was let go, and leaves any other.
    void finishGesture();

signals:
    void changed(const bolster::ChangeSet& ids);
    /// Nodes were added or named, or the current node moved.
    void historyChanged();
    /// A version, or the branch that begins with it. Comes before historyChanged.
    void named(bolster::NodeId node);
    /// The history is another one now. Comes before historyChanged.
    void historyReplaced();
    void dirtyChanged(bool dirty);
    /// A gesture was committed, taken back or came to nothing: design() is committed() again. Comes last, also when
    /// nothing has changed.
    void gestureEnded();
    /// An edit was not made: a gesture that would have broken something, or what cannot be stored.
    void refused(const bolster::Message& why);
    /// An edit was made, or came to nothing, with a note to its maker.
    void noted(const bolster::Message& note);
    /// An edit was made that took these away because they make no sense any more: its maker has not asked for that.
    /// `before` is the design that has them.
    void dropped(const bolster::Design& before, const std::vector<bolster::ElementId>& ids);

private:
    friend class Gesture;
    void begin(Design design, History history, bool project);
    void setBase(Design design);
    void show(Design design);
    void namesChanged();
    void announceDirty();

    Design m_base;
    ElementId m_spent{};
    Design m_design; // m_base, or with the running gesture's edit
    std::uint64_t m_revision = 0;
    History m_history;
    HeldHistory m_held;
    QByteArray m_names; // of m_history's mark
    bool m_wasDirty = false;
    Gesture* m_gesture = nullptr;
    std::optional<edits::Breakage> m_breakage;
    std::function<Message(const Edit&)> m_refusal;
};

} // namespace bolster
