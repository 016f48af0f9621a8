// The Surface menu: the solver.
#pragma once

#include <QCoreApplication>
#include <QObject>

class QWidget;

namespace bolster {

class Commands;
class CoverAtRest;
class SolverLink;

class SurfaceCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(SurfaceCommands)

public:
    SurfaceCommands(Commands& commands, SolverLink& solver, CoverAtRest& cover, QWidget& window);
};

} // namespace bolster
