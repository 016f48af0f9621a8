// Bodies for CAD: STEP, application protocol 214, with a flat face for each triangle.
#pragma once

#include "TriangleMesh.h"

#include <string>

namespace bolster {

/// ISO 10303-21 text with a solid (of flat faces) for each connected surface that faces outwards,
/// and voids in it for those that face inwards; millimetres, the design's axes. `solid` is closed: each edge lies
/// between two triangles. The same body gives the same text, about 300 bytes for a triangle.
std::string stepBody(const std::string& product, const TriangleMesh& solid);

} // namespace bolster
