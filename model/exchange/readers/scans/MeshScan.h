// A mesh as a scan: what stands on its surface, also where its triangles are large.
#pragma once

#include "FileBytes.h"
#include "PointCloud.h"
#include "TriangleMesh.h"

namespace bolster {

/// Adds points on triangles that are large against the mesh: their corners alone would say nothing of what is
/// between them, so a cover would not be pulled there, and a scan not be found by it. As many to each area, evenly,
/// the same for the same mesh. A scanner's mesh has a corner every few millimetres, and gets none.
void fillLargeTriangles(PointCloud& cloud, const TriangleMesh& mesh, const ImportWatch& watch);

} // namespace bolster
