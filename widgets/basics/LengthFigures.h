// Lengths that are read together.
#pragma once

#include <QStringList>

#include <vector>

namespace bolster {

/// As lengthFigure writes them, but all in one notation: inches as fractions if that says each of them, else none.
QStringList lengthFigures(const std::vector<double>& millimetres, int decimals = 1);

} // namespace bolster
