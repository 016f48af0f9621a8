// Which parts of a frame lie under which cover.
#pragma once

#include "FrameBodies.h"
#include "SewnMesh.h"

#include <stop_token>

namespace bolster {

/// For each sewn component the parts that belong to it, increasing. A part goes to the component that has most of
/// its fixed vertices nearest to it; or else, to the component whose fixed vertices are nearest. So no part lies
/// under two covers: a field of touching bodies would push a cover into its neighbour. But a component that would
/// get none gets the part that most of its fixed vertices are nearest to, and one without fixations all that is
/// left. When stopped it means nothing.
std::vector<std::vector<int>> guessParts(const FrameParts& parts, const Placement& frame, const SewnMesh& mesh,
                                         const std::stop_token& stop = {});

} // namespace bolster
