// What the views show: View > Layers, and the grid.
#pragma once

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class PatternView;
class SolverLink;
class CoverView;

class LayerCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(LayerCommands)

public:
    LayerCommands(Commands& commands, PatternView& pattern, CoverView& coverView, SolverLink& solver);

    /// Shows what is checked.
    void apply();

private:
    void add();
    void addOfScans();
    bool on(const char* id);

    Commands& m_commands;
    PatternView& m_pattern;
    CoverView& m_coverView;
    SolverLink& m_solver;
};

} // namespace bolster
