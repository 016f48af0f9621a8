// A second program with the same window and the same home, which edits and is killed in the middle of its work.
#pragma once

#include <QStringList>

namespace bolster::ProgramThatDies {

/// Opens the design, makes so many edits, takes so many back, makes others and is killed. True when it came that
/// far.
bool run(const QString& design, int edits, int undone, int editsThen = 0);

/// In the second program: what it is to do, or nothing in the first one.
QStringList wanted();
int workAndDie(const QStringList& wanted);

} // namespace bolster::ProgramThatDies
