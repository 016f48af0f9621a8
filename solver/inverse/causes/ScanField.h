// How far a scan lies outside of a cover, from all of its points.
#pragma once

#include "FitGoals.h"
#include "SurfaceMesh.h"
#include "WorkerPool.h"

#include <Eigen/SparseCore>

#include <vector>

namespace bolster {

/// Each point of the scan counts where the cover is nearest to it, for the corners of the triangle there. So noise
/// averages out, and creases are measured, too; measureScan takes one point for each vertex.
struct ScanField {
    std::vector<double> outside; ///< mm, per vertex; NaN where the scan shows nothing
    /// What the same mean makes of a field that is known at the vertices: scan and field compare.
    Eigen::SparseMatrix<double, Eigen::RowMajor> mean;
};

/// Points farther than the scan's threshold, and those beside the cover's border, count for nothing.
ScanField scanField(const SurfaceMesh& cover, const FitTarget& scan, WorkerPool& pool);

} // namespace bolster
