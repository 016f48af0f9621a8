// A small picture of a mesh or a scan before it is imported: what it is, and whether it stands upright.
#pragma once

#include "Placement.h"
#include "PointCloud.h"
#include "TriangleMesh.h"

#include <QImage>

namespace bolster {

/// The parts that are wanted (all, when `wanted` is empty), from the front, its right and above, as large as fits;
/// transparent beside them. `colors`: 0xRRGGBB of each part, empty where none has one. Of more than 300,000
/// triangles some are left out. 0.1 s at most.
QImage framePicture(const TriangleMesh& mesh, const std::vector<bool>& wanted, const Quat& turn, QSize size,
                    const std::vector<std::uint32_t>& colors = {});

/// The same of points, in their colours, or else as a light would show them. Of more than 100,000 some are left
/// out. The farthest two hundredths along each axis may be beside it: scans have outliers.
QImage scanPicture(const PointCloud& cloud, const Quat& turn, QSize size);

} // namespace bolster
