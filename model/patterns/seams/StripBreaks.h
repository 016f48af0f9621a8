// Where a long edge changes its partner: a strip around a cushion runs past several edges of it. Private to the
// library.
#pragma once

#include "FreeEdges.h"

#include <stop_token>

namespace bolster {

/// Parameters that divide edges, by patch: where the edges around another piece are together as long as that of a
/// strip, which fits no single one; or some of them in a row, where the strip has notches at their corners.
EdgeBreaks stripBreaks(const Design& design, const std::vector<OutlineEdge>& edges,
                       const std::stop_token& stop = {});

} // namespace bolster
