// Names of parts, as files have them and as people can use them.
#pragma once

#include "Assembly.h"

namespace bolster {

/// Names of groups come in any encoding; those that are not UTF-8 are taken for Latin-1.
std::string cleanName(const std::string& name);

/// Cleans all names, and makes those of parts with triangles different from each other: "Leg", "Leg (2)". A part
/// without a name is called after what it belongs to, or "Part".
void namePartsApart(Assembly& assembly);

} // namespace bolster
