// From what the cover shall be to the pattern.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QPointer>

class QDialog;

namespace bolster {

class Commands;
class DesignSession;
class PatternView;
class Selection;
class SolverLink;

class InverseCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(InverseCommands)

public:
    InverseCommands(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
                    PatternView& pattern, QWidget& window);
    ~InverseCommands() override;

private:
    void fit();
    void fromForm();

    DesignSession& m_session;
    Selection& m_selection;
    SolverLink& m_solver;
    PatternView& m_pattern;
    QWidget& m_window;
    QPointer<QDialog> m_fit;
    QPointer<QDialog> m_form;
};

} // namespace bolster
