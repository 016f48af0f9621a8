// The stretches of outlines that an element is about.
#pragma once

#include "Design.h"

#include <vector>

namespace bolster {

/// None for other kinds than seams, fixations and stretches of outlines.
std::vector<Stretch> stretchesOf(const Element& element);
/// With other ones, as many.
ElementPtr withStretches(const Element& element, const std::vector<Stretch>& stretches);

} // namespace bolster
