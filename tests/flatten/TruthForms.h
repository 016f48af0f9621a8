// The true surfaces of the armchair's body and the car seat, as forms with a group for each piece; designs of
// files.
#pragma once

#include "Design.h"
#include "TriangleMesh.h"

#include <string>

namespace bolster::test {

TriangleMesh armchairForm();
TriangleMesh carSeatForm();

/// Of a file in the text form.
Design designIn(const std::string& path);

} // namespace bolster::test
