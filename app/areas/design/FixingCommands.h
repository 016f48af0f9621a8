// Fixation curves that are made of what is selected.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Document;
class Selection;
class SolverLink;
class StatusLine;

class FixingCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(FixingCommands)

public:
    FixingCommands(Commands& commands, Document& document, Selection& selection, SolverLink& solver,
                   StatusLine& status);

private:
    void create();

    Document& m_document;
    Selection& m_selection;
    SolverLink& m_solver;
    StatusLine& m_status;
};

} // namespace bolster
