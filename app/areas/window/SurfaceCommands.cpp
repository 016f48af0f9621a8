#include "SurfaceCommands.h"

#include "Commands.h"
#include "CoverAtRest.h"
#include "HelpDialogs.h"
#include "SolverLink.h"

namespace bolster {

SurfaceCommands::SurfaceCommands(Commands& commands, SolverLink& solver, CoverAtRest& cover, QWidget& window)
{
    commands.add(
        {{.id = "surface.pause",
          .formerly = "pause",
          .text = tr("&Pause"),
          .icon = "pause",
          .keys = {Qt::CTRL | Qt::Key_Period, Qt::Key_Pause},
          .places = {"surface/1"},
          .bar = 401,
          .checked = [&solver] { return solver.paused(); },
          .does =
              [&solver] {
                  solver.setPaused(!solver.paused());
                  emit solver.statusChanged(solver.status());
              }},
         {.id = "surface.figures",
          .formerly = "figures",
          .text = tr("&Figures \u2026"),
          .places = {"surface/2"},
          .enabled = [&solver] { return solver.report().vertices > 0; },
          .does = [&solver, &cover,
                   &window] { cover.then([&solver, &window] { showFigures(&window, solver.report()); }); }}});
    connect(&solver, &SolverLink::statusChanged, this, [&commands] { commands.update({"surface.figures"}); });
}

} // namespace bolster
