#include "EditCommands.h"

#include "Commands.h"
#include "Docks.h"
#include "Document.h"
#include "ElementsView.h"
#include "FabricCommands.h"
#include "HistoryModel.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StatusLine.h"
#include "Translated.h"

namespace bolster {

EditCommands::EditCommands(Commands& commands, Document& document, Selection& selection, Docks& docks,
                           ElementsView& elements, HistoryPanel& history, FabricCommands& fabrics,
                           StatusLine& status, std::function<bool()> takeBack)
    : m_document(document)
    , m_selection(selection)
    , m_docks(docks)
    , m_elements(elements)
    , m_history(history)
    , m_fabrics(fabrics)
    , m_status(status)
    , m_takeBack(std::move(takeBack))
{
    addHistory(commands);
    addSelection(commands);
    connect(&document, &Document::changed, this, [&commands] { commands.update({"edit.undo"}); });
}

void EditCommands::addHistory(Commands& commands)
{
    commands.add(
        {{.id = "edit.undo",
          .formerly = "undo",
          .text = tr("&Undo"),
          .icon = "undo",
          .keys = {QKeySequence::Undo},
          .places = {"edit/1"},
          .bar = 201,
          .enabled =
              [this] { return m_document.history().canUndo() || m_document.gestureRunning(); }, // a drag first
          .textNow = [this] { return undoText(); },
          .does =
              [this] {
                  if (m_document.gestureRunning() || !m_takeBack())
                      m_document.undo();
              }},
         {.id = "edit.redo",
          .formerly = "redo",
          .text = tr("&Redo"),
          .icon = "redo",
          .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y},
          .places = {"edit/1"},
          .bar = 202,
          .enabled = [this] { return m_document.history().canRedo(); },
          .textNow = [this] { return redoText(); },
          .does = [this] { m_document.redo(); }},
         {.id = "edit.name-branch",
          .formerly = "name-this-branch",
          .text = tr("Name this &branch \u2026"),
          .keys = {Qt::SHIFT | Qt::Key_F2},
          .tip = tr("Name the way that the history has gone since it forked"),
          .places = {"edit/1"},
          .enabled = [this] { return m_document.history().branchOf(m_document.history().current()).has_value(); },
          .does = [this] { nameBranch(); }}});
}

void EditCommands::addSelection(Commands& commands)
{
    const auto any = [this] { return !m_selection.elements().empty(); };
    commands.add({{.id = "edit.rename",
                   .formerly = "rename",
                   .text = tr("Re&name"),
                   .keys = {Qt::Key_F2},
                   .places = {"edit/3"},
                   .enabled =
                       [this] {
                           const bool one = m_selection.elements().size() == 1;
                           const ElementPtr element =
                               one ? m_document.design().element(*m_selection.elements().begin()) : nullptr;
                           return element && hasName(*element); // seams are called after their patches
                       },
                   .does = [this] { rename(); }},
                  {.id = "edit.delete",
                   .formerly = "delete",
                   .text = tr("&Delete"),
                   .icon = "delete",
                   .keys = {QKeySequence::Delete},
                   .places = {"edit/3"},
                   .bar = 203,
                   .enabled = any,
                   .does = [this] { remove(); }},
                  {.id = "edit.select-all",
                   .formerly = "select-all-patches",
                   .text = tr("Select &all patches"),
                   .keys = {QKeySequence::SelectAll},
                   .places = {"edit/4"},
                   .does = [this] { selectAll(); }},
                  {.id = "edit.select-nothing",
                   .formerly = "select-nothing",
                   .text = tr("Select n&othing"),
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_A},
                   .places = {"edit/4"},
                   .enabled = any,
                   .does = [this] { m_selection.clear(); }}});
}

QString EditCommands::undoText() const
{
    const History& history = m_document.history();
    return history.canUndo() ? tr("&Undo: %1").arg(translated(history.node(history.current()).edit.verb))
                             : tr("&Undo");
}

QString EditCommands::redoText() const
{
    const History& history = m_document.history();
    if (!history.canRedo())
        return tr("&Redo");
    const NodeId next = history.node(history.current()).lastVisitedChild;
    return tr("&Redo: %1").arg(translated(history.node(next).edit.verb));
}

void EditCommands::nameBranch()
{
    Docks::reveal(m_docks.history);
    HistoryView& view = m_history.view();
    view.nameBranchOf(view.hasFocus() ? view.currentIndex().data(HistoryModel::NodeRole).toInt()
                                      : m_document.history().current());
}

void EditCommands::remove()
{
    m_document.cancelGesture();
    const std::vector<ElementId> fabrics = selectedOf<Fabric>(m_document.design(), m_selection.elements());
    if (fabrics.size() == 1 && m_selection.elements().size() == 1) {
        m_fabrics.remove(); // asks what patches get instead
        return;
    }
    QString problem;
    const std::size_t selected = m_selection.elements().size();
    const Edit edit = removeSelected(m_document.design(), m_selection, &problem);
    if (edit.empty())
        m_status.flash(problem);
    else
        removeAndForget(m_document, m_selection, edit);
    if (edit.changes.size() > selected)
        m_status.flash(translated(edit.verb)); // more than was asked for
}

void EditCommands::rename()
{
    Docks::reveal(m_docks.elements);
    m_elements.rename(*m_selection.elements().begin());
}

void EditCommands::selectAll()
{
    Selection::Elements all;
    m_document.design().each<Patch>([&](ElementId id, const Patch&) { all.insert(id); });
    m_selection.set(std::move(all));
}

} // namespace bolster
