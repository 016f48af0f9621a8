// The commands on the history and on whatever is selected.
#pragma once

#include <QCoreApplication>
#include <QObject>

#include <functional>

namespace bolster {

class Commands;
class Docks;
class Document;
class ElementsView;
class FabricCommands;
class HistoryPanel;
class Selection;
class StatusLine;

class EditCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(EditCommands)

public:
    /// `takeBack`: a step of what a tool has begun, which comes before steps of the history; false when none has.
    EditCommands(Commands& commands, Document& document, Selection& selection, Docks& docks, ElementsView& elements,
                 HistoryPanel& history, FabricCommands& fabrics, StatusLine& status,
                 std::function<bool()> takeBack);

private:
    void addHistory(Commands& commands);
    void addSelection(Commands& commands);
    QString undoText() const;
    QString redoText() const;
    void nameBranch();
    void remove();
    void rename();
    void selectAll();

    Document& m_document;
    Selection& m_selection;
    Docks& m_docks;
    ElementsView& m_elements;
    HistoryPanel& m_history;
    FabricCommands& m_fabrics;
    StatusLine& m_status;
    std::function<bool()> m_takeBack;
};

} // namespace bolster
