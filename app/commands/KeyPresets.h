// Keys for who comes from other programs.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include <utility>
#include <vector>

namespace bolster {

/// What differs from Bolster's own keys: by the commands' ids. An empty sequence takes the keys away.
struct KeyPreset {
    const char* id;   ///< for good: settings have it
    const char* name; ///< to be translated in the context KeyPresets
    std::vector<std::pair<const char*, QKeySequence>> keys;
};
/// Bolster's own comes first.
const std::vector<KeyPreset>& keyPresets();
/// The first one when there is none of this id.
const KeyPreset& keyPreset(const QString& id);

} // namespace bolster
