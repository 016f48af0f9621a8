// Held normals as rows of L2 (paper, section 3.2: orientation constraints).
#pragma once

#include "SheetMoment.h"

#include <vector>

namespace bolster {

/// The rows W_v |q_v - q*_v|^2, where q*_v is the present frame, turned the shortest way until its normal is as it
/// is held. So a frame stays free to turn in its plane, and W_v is constant. A closed fit at half a ring says
/// little about how a cover leans where it is also smoothed: hence W_v is large against both, weight * 10 (A + 2
/// lambda^2).
double orientationWeight(const SewnMesh& mesh, const SewnMesh::Oriented& held);

/// Adds W_v (q*_v - q_v) to the right-hand sides of L2 (one column per vertex).
void addOrientations(const SheetMoment& sheet, Columns& right);

} // namespace bolster
