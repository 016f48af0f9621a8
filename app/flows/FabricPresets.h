// Fabrics that come with the program, to begin from.
#pragma once

#include "Fabric.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace bolster {

/// With names in the user's language. Kind and colour set each apart; stretch limits are those usual for the kind.
std::vector<Fabric> fabricPresets();
/// What settings know them by, in the same order: their English names.
QStringList fabricPresetKeys();
/// Nothing when there is none of that key.
std::optional<Fabric> fabricPreset(const QString& key);

} // namespace bolster
