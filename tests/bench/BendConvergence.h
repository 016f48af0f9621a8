// How long the way from the flat strip to the bent one is.
#pragma once

#include "CgalPeer.h"
#include "Race.h"
#include "Rig.h"

namespace bolster::bench {

/// A lap is the way from the start to convergence: the estimated distance to the method's own limit is below 1e-4
/// of D three times in a row (the solver's Convergence, for all alike). The number of iterations is found out
/// beforehand.
Lap convergenceOf(const std::shared_ptr<Rig>& rig);
/// As many iterations at the pace of the lap: the whole way would take too long to repeat.
Lap convergenceOf(const HeldSurface& surface, CgalPeer::Energy energy);

} // namespace bolster::bench
