// The body between a cover and its frame, for the foam cutter.
#pragma once

#include "Design.h"
#include "DesignFiles.h"
#include "SurfaceMesh.h"
#include "TriangleMesh.h"

#include <stop_token>

namespace bolster {

struct FoamOrder {
    double edge = 5;  ///< of the grid that it is measured on, mm
    double below = 1; ///< how far it ends below the cover's outside, mm: the material
};

/// What lies inside of the cover - whose openings are closed by lids from their borders to the middle (CoverLids) -
/// and outside of all frames: closed, each edge between two triangles, which face outwards; mm, the design's axes.
/// Exact to a small part of the grid's edge where surfaces are smooth; edges are rounded by it. No triangles where
/// there is nothing, or when it was stopped.
TriangleMesh foamSolid(const SurfaceMesh& cover, const Design& design, const DesignFiles& files,
                       const FoamOrder& order, const std::stop_token& stop = {});

} // namespace bolster
