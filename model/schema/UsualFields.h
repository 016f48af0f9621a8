// What is wrong with an element and shapes nothing, set back to what is usual.
#pragma once

#include "Element.h"

#include <string>
#include <vector>

namespace bolster {

/// The element with the usual values in these fields (paths of the text form: "look.relief"). Null when one of them
/// shapes the cover (its SolveCost says so), or is a place or a reference that the element cannot be without.
ElementPtr withUsualFields(const Element& element, const std::vector<std::string>& fields);

} // namespace bolster
