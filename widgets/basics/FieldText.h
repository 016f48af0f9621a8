// How the keys of the text form are called in the window.
#pragma once

#include "Design.h"

#include <QString>

#include <string>

namespace bolster {

/// "Bending length"; the key itself where it has no other name.
QString fieldText(const std::string& key);
/// A value in JSON for a list: numbers and texts as they are, the rest in short.
QString fieldValueText(const std::string& json);
/// The same in the words of a design: elements by their names, lengths and angles with their units.
QString fieldValueText(const Design& design, const std::string& key, const std::string& json);

} // namespace bolster
