// Aligns a scan with what stands in the design, rigidly: by pairs of points, then on its own (iterative closest
// points).
#pragma once

#include "AlignTarget.h"
#include "ScanIndex.h"

#include <functional>
#include <optional>
#include <stop_token>

namespace bolster {

/// Two places that are to be one.
struct ScanPair {
    Vec3 onScan = Vec3::Zero();   ///< file units
    Vec3 onTarget = Vec3::Zero(); ///< mm
};

/// Moves and turns so that the sum of the squared distances is least; the scale stays. Nothing with fewer than
/// three pairs, or where those of a side lie on a line. Source: Kabsch, "A solution for the best rotation to relate
/// two sets of vectors", 1976.
std::optional<Placement> placementByPairs(const std::vector<ScanPair>& pairs, const Placement& from);
/// How far those of a pair are from each other: root mean square, mm.
double pairResidual(const std::vector<ScanPair>& pairs, const Placement& placement);

struct ScanAlignment {
    Placement placement;
    double rms = 0;     ///< mm, of the points that were matched, along the target's normals
    double reach = 0;   ///< mm: what is farther from the target was not matched
    double matched = 0; ///< share of the scan's points that were
};

/// From a placement that may be some centimetres and about twenty degrees off. Points that belong to nothing, and
/// parts of the target that the scan has not seen, do not count: the farther a point is, the less it weighs, and
/// what is too far weighs nothing; how far that is follows the noise. The same on any number of threads. Nothing
/// when stopped, or when the scan has no points near the target. `progress` gets the step, from 0.
std::optional<ScanAlignment> alignScan(const AlignTarget& target, const ScanIndex& index, const Placement& from,
                                       const std::stop_token& stop = {},
                                       const std::function<void(int)>& progress = {});

} // namespace bolster
