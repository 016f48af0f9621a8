// How the keys of the text form are called in the window.
#pragma once

#include <QString>

#include <string>

namespace bolster {

/// "Bending length"; the key itself where it has no other name.
QString fieldText(const std::string& key);
/// A value in JSON for a list: numbers and texts as they are, the rest in short.
QString fieldValueText(const std::string& json);

} // namespace bolster
