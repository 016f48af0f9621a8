// The JSON schema of the text form, made from the descriptions of the kinds (docs/design.schema.json).
#pragma once

#include <string>

namespace bolster {

/// Draft 2020-12. What needs more than one element, or geometry, it leaves to checkDesign.
std::string designSchema();

} // namespace bolster
