// Compares a design with the one that was meant.
#pragma once

#include "Design.h"

#include <QString>
#include <QStringList>

namespace bolster {

/// What is different, in words; nothing when the designs are alike: the same elements in the same order, whatever
/// their ids, with the same values; coordinates within `tolerance` (mm), files by their name alone.
QStringList differences(const Design& design, const Design& expected, double tolerance);

} // namespace bolster
