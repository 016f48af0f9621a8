#include "Document.h"

#include "FollowEdits.h"
#include "Gesture.h"

#include <algorithm>
#include <utility>

namespace bolster {

Document::Document(QObject* parent)
    : QObject(parent)
{}

Document::~Document()
{
    if (m_gesture)
        m_gesture->m_document = nullptr;
}

void Document::reset(Design design)
{
    begin(std::move(design), History(), false);
}

void Document::reset(Design design, History history)
{
    begin(std::move(design), std::move(history), true);
}

void Document::begin(Design design, History history, bool project)
{
    cancelGesture();
    m_history = std::move(history);
    m_held = {m_history.mark(), !project};
    m_names = m_held.mark.names;
    m_spent = noElement;
    setBase(std::move(design));
    show(m_base);
    emit historyReplaced();
    emit historyChanged();
    announceDirty();
}

void Document::commit(Edit edit)
{
    cancelGesture();
    if (!edit.note.empty())
        emit noted(edit.note);
    // What counts is what the edit does to this design: `before` is taken from here, so undo is always exact.
    edit = edits::withFollowers(m_base, std::move(edit));
    Design next = m_base.with(edit);
    edit = editBetween(m_base, next, std::move(edit.verb));
    if (edit.empty()) {
        show(m_base);
        return;
    }
    if (const Message why = m_refusal ? m_refusal(edit) : Message(); !why.empty()) {
        show(m_base);
        emit refused(why);
        return;
    }
    m_history.append(std::move(edit));
    setBase(std::move(next));
    show(m_base);
    emit historyChanged();
    announceDirty();
}

void Document::commit(edits::Outcome outcome)
{
    if (outcome.edit.empty())
        return;
    cancelGesture();
    const Design before = m_base;
    const NodeId node = m_history.current();
    commit(std::move(outcome.edit));
    if (!outcome.dropped.empty() && m_history.current() != node)
        emit dropped(before, outcome.dropped);
}

void Document::spendIds(ElementId upTo)
{
    m_spent = std::max(m_spent, upTo);
    m_base.spendIds(m_spent);
    m_design.spendIds(m_spent);
}

void Document::setBase(Design design)
{
    m_base = std::move(design);
    spendIds(m_base.largestId());
}

void Document::undo()
{
    finishGesture();
    if (m_gesture)
        cancelGesture(); // that was the last thing done
    else if (m_history.canUndo())
        jumpTo(m_history.node(m_history.current()).parent);
}

void Document::redo()
{
    finishGesture();
    if (m_gesture)
        cancelGesture();
    else if (m_history.canRedo())
        jumpTo(m_history.node(m_history.current()).lastVisitedChild);
}

void Document::jumpTo(NodeId node)
{
    cancelGesture();
    if (node < 0 || node >= m_history.count() || node == m_history.current())
        return;
    std::optional<Design> there = m_history.moveTo(node, m_base);
    if (!there)
        return;
    setBase(std::move(*there));
    show(m_base);
    emit historyChanged();
    announceDirty();
}

void Document::takeIn(std::vector<History::Node> nodes, std::shared_ptr<StoredEdits> edits)
{
    m_history.takeIn(std::move(nodes), std::move(edits));
    namesChanged();
}

void Document::nameVersion(NodeId node, std::string name)
{
    if (node < 0 || node >= m_history.count() || m_history.node(node).name == name)
        return;
    m_history.setName(node, std::move(name));
    emit named(node);
    namesChanged();
}

void Document::nameBranch(NodeId node, std::string name)
{
    if (node < 0 || node >= m_history.count() || m_history.node(node).branch == name)
        return;
    m_history.setBranch(node, std::move(name));
    emit named(node);
    namesChanged();
}

void Document::namesChanged()
{
    m_names = m_history.mark().names;
    emit historyChanged();
    announceDirty();
}

/// Of a text, saving it again would not help against what it cannot hold.
bool Document::dirty() const
{
    return m_history.current() != m_held.mark.current || (!m_held.designAlone && hasUnsavedWork());
}

void Document::setHeld(HeldHistory held)
{
    m_held = std::move(held);
    announceDirty();
}

void Document::finishGesture()
{
    if (m_gesture && m_gesture->isLetGo())
        m_gesture->commit();
}

bool Document::dragging() const
{
    return m_gesture && !m_gesture->isPreview();
}

void Document::cancelGesture()
{
    finishGesture();
    if (!m_gesture)
        return;
    std::exchange(m_gesture, nullptr)->m_document = nullptr;
    m_breakage.reset();
    show(m_base);
    emit gestureEnded();
}

void Document::show(Design design)
{
    const ChangeSet ids = differences(m_design, design);
    m_design = std::move(design);
    if (ids.empty())
        return;
    ++m_revision;
    emit changed(ids);
}

void Document::announceDirty()
{
    if (std::exchange(m_wasDirty, dirty()) != dirty())
        emit dirtyChanged(dirty());
}

} // namespace bolster
