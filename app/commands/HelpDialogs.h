// What the Help menu and Surface > Figures show.
#pragma once

#include "SolveReport.h"

class QWidget;

namespace bolster {

class Commands;

void showAbout(QWidget* parent);
/// Keys of all commands, and what the mouse does in the views.
void showShortcuts(QWidget* parent, const Commands& commands);
void showFigures(QWidget* parent, const SolveReport& report);

} // namespace bolster
