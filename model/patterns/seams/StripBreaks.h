// Where a long edge changes its partner: a strip around a cushion runs past several edges of it. Private to the
// library.
#pragma once

#include "FreeEdges.h"

namespace bolster {

/// Parameters that divide edges, by patch: where edges in a row on another piece are together as long as an edge
/// that fits no single one, or whose notches lie where the corners of that row come.
EdgeBreaks stripBreaks(const Design& design, const std::vector<OutlineEdge>& edges);

} // namespace bolster
