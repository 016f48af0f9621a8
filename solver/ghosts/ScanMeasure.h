// How far a cover lies from a scan.
#pragma once

#include "MakeGhosts.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"
#include "WorkerPool.h"

#include <utility>
#include <vector>

namespace bolster {

struct ScanDeviation {
    /// mm, per vertex, along the normal: positive where the cover lies outside the scan; NaN where the scan has no
    /// point within its threshold, or a hole.
    std::vector<float> ofVertex;
    /// The point of the scan, mm, for each vertex that has a deviation.
    std::vector<std::pair<std::uint32_t, Vec3>> pairs;
    ScanFigures figures;
};

ScanDeviation measureScan(const SurfaceMesh& surface, const Scan& scan, std::shared_ptr<const ScanIndex> index,
                          WorkerPool& pool);

/// Of what `areas` of vertices, mm^2, is more than 0.
ScanFigures scanFigures(const std::vector<float>& deviations, const std::vector<double>& areas);

/// Of all scans whose points are there, enabled or not.
std::vector<SolveReport::ScanFit> measureScans(const SolveInput& input, const SurfaceMesh& surface,
                                               ScanIndexCache& cache, WorkerPool& pool);

} // namespace bolster
