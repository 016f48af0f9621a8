// Sentences of design and solver in the language of the window.
#pragma once

#include "Problem.h"

#include <QString>

namespace bolster {

/// The translation that is installed in the application, or English; numbers in the arguments stay as they are.
QString translated(const Message& message);

/// "patch 2 "Seat", outline.points: the outline crosses itself ...", as Problem::english.
QString translated(const Problem& problem);

} // namespace bolster
