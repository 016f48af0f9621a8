// The text form of a design: docs/design-json.md.
#pragma once

#include "Design.h"

#include <string>
#include <string_view>

namespace bolster {

struct ReadDesign {
    Design design;         ///< unreadable elements are in it as Quarantined
    Problems problems;     ///< of reading; the rules of checkDesign are not applied here
    bool readable = false; ///< false: not a design at all (wrong JSON, format or version); `design` is empty
};

/// Never throws on bad text; deep nesting, huge numbers and duplicate keys are problems, not accidents.
ReadDesign readDesign(std::string_view text);

/// That a design may have.
inline constexpr std::size_t mostElements = 100'000;

/// Canonical: the same design gives the same bytes; elements by id, keys in the documented order, shortest
/// numbers that read back to the same double, optional keys left out where they have their default.
std::string writeDesign(const Design& design);
/// One element, or the settings for settingsId, as writeDesign writes it.
std::string writeElement(ElementId id, const Element& element);

} // namespace bolster
