// What the Help menu and Surface > Figures show.
#pragma once

#include "SolveReport.h"

class QWidget;

namespace bolster {

class Actions;

void showAbout(QWidget* parent);
/// Keys of all actions, and what the mouse does in the views.
void showShortcuts(QWidget* parent, const Actions& actions);
void showFigures(QWidget* parent, const SolveReport& report);

} // namespace bolster
