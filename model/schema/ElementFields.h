// An element as the keys of its text form: what the project file stores, and finds the differences of.
#pragma once

#include "Element.h"

#include <map>
#include <string>

namespace bolster {

/// Keys of the text form (docs/design-json.md) with their values as JSON text, without "id". A quarantined element
/// has one empty key with its whole text. No keys mean that there is no element.
using ElementFields = std::map<std::string, std::string>;

/// Empty for null. The settings have the id settingsId.
ElementFields elementFields(ElementId id, const ElementPtr& element);

/// What cannot be read comes back as Quarantined. Null for no fields, and for settings that cannot be read.
ElementPtr elementFromFields(ElementId id, const ElementFields& fields);

} // namespace bolster
