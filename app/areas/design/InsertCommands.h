// The Insert menu: foam and cushioning.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class DesignSession;
class Selection;
class SolverLink;
class StatusLine;

class InsertCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(InsertCommands)

public:
    InsertCommands(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
                   StatusLine& status);

private:
    void insertCushion();

    DesignSession& m_session;
    Selection& m_selection;
    SolverLink& m_solver;
    StatusLine& m_status;
};

} // namespace bolster
