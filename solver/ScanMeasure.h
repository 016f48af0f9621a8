// How far a cover lies from a scan.
#pragma once

#include "MakeGhosts.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"
#include "WorkerPool.h"

#include <optional>

namespace bolster {

struct ScanDeviation {
    /// mm, per vertex, along the normal: positive where the cover lies outside the scan; NaN where the scan has no
    /// point within its threshold, or a hole.
    std::vector<float> ofVertex;
    SolveReport::ScanFit figures; ///< without element and name
};

ScanDeviation measureScan(const SurfaceMesh& surface, const Scan& scan, std::shared_ptr<const ScanIndex> index,
                          WorkerPool& pool);

/// Of all scans whose points are there, enabled or not.
std::vector<SolveReport::ScanFit> measureScans(const SolveInput& input, const SurfaceMesh& surface,
                                               ScanIndexCache& cache, WorkerPool& pool);

} // namespace bolster
