// Where seams end inside of edges: between notches of one piece and notches, or corners, of another one. Private to
// the library.
#pragma once

#include "FreeEdges.h"

#include <stop_token>

namespace bolster {

/// Parameters that divide some of the edges, by patch: at two notches, or a notch and a corner, between which an
/// edge is as long as another one's part of the same kind, or as a whole one, with the same notches in between.
/// Those that have more notches in common have the say, then those that fit a whole edge, then those that fit
/// better.
EdgeBreaks notchBreaks(const Design& design, const std::vector<OutlineEdge>& edges, const std::vector<int>& chosen,
                       const std::stop_token& stop = {});

} // namespace bolster
