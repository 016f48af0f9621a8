// One element from its JSON object. Private to the library.
#pragma once

#include "Element.h"
#include "JsonFields.h"

namespace bolster::json {

/// Number, kind and name of an element as far as they can be read: good for messages.
struct Heading {
    ElementId id{}; ///< 0 when it has no valid one
    std::string label;
};
/// `position` is that in the list of elements.
Heading headingOf(const Value& element, std::size_t position);

/// Null when the report is not clean.
ElementPtr readElement(const Value& object, Report& report);
Settings readSettings(const Value& object, Report& report);

} // namespace bolster::json
