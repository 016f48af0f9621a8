// Any number of an element, by its key in the text form.
#pragma once

#include "Element.h"

#include <optional>
#include <string>
#include <utility>

namespace bolster {

/// `path`: keys of docs/design-json.md with dots between them, coordinates by their place: "dilation_mm",
/// "size_mm.2", "limits.along". Nothing where the kind has no such number. Numbers in lists have no path.
std::optional<double> numberAt(const Element& element, const std::string& path);
/// What it may be; nothing where there is no such number.
std::optional<std::pair<double, double>> numberLimits(const Element& element, const std::string& path);
/// The element with another number there; null where there is none. Limits are not looked at.
ElementPtr withNumber(const Element& element, const std::string& path, double value);

} // namespace bolster
