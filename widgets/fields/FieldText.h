// How the fields of the text form, and their values, are called in the window.
#pragma once

#include "Design.h"

#include <QString>

#include <string>

namespace bolster {

/// Of an element like this: "Bending length"; the key itself where its kind has no such field.
QString fieldText(const Element& element, const std::string& key);
/// A value in JSON, in the words of a design: elements by their names, lengths and angles with their units. What is
/// not there is "usual".
QString fieldValueText(const Design& design, const Element& element, const std::string& key,
                       const std::string& json);

} // namespace bolster
