// Moves a scan onto the cover, rigidly (the iterative closest point method).
#pragma once

#include "ScanIndex.h"
#include "SurfaceMesh.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace bolster {

struct PlacementFit {
    Placement placement;
    double rms = 0; ///< mm, of the pairs that count, along the scan's normals
    int iterations = 0;
};

/// From where the scan lies: pairs every vertex with the point nearest to it, drops the farthest fifth, for what
/// the scan has not seen, and moves the scan so that its planes come nearer to the vertices. The scale stays.
/// Nothing when stopped, or when there are too few points. `progress` gets the iteration.
std::optional<PlacementFit> fitPlacement(const SurfaceMesh& surface, const Placement& from, const ScanIndex& index,
                                         const std::stop_token& stop = {},
                                         const std::function<void(int)>& progress = {});

} // namespace bolster
