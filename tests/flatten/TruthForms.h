// The true surfaces of the armchair's body and the car seat, as forms with a group for each piece.
#pragma once

#include "TriangleMesh.h"

namespace bolster::test {

TriangleMesh armchairForm();
TriangleMesh carSeatForm();

} // namespace bolster::test
