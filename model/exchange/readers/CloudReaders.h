// The readers behind importCloud, one per format: untrusted bytes in, points out. They throw FileRefused.
#pragma once

#include "FileBytes.h"
#include "PointCloud.h"

namespace bolster {

PointCloud readPlyCloud(const FileBytes& bytes); ///< the points of any PLY, with or without faces
PointCloud readXyz(const FileBytes& bytes); ///< text: x y z, perhaps colours, and anything else, a point a line
PointCloud readPts(const FileBytes& bytes); ///< the same behind the number of points, several times
PointCloud readPcd(const FileBytes& bytes); ///< of the Point Cloud Library: text, binary and compressed
/// All scans of the file, each by its pose. Points that it calls invalid are left out, and where the scanner has
/// seen nothing (0, 0, 0 in a PTX file). Brightness is taken for a colour when no scan has any.
PointCloud readE57(const FileBytes& bytes); ///< ASTM E2807
PointCloud readPtx(const FileBytes& bytes); ///< text
/// Versions 1.0 to 1.4; refuses compressed ones (LAZ). Without what is withheld, or classified as noise.
PointCloud readLas(const FileBytes& bytes);

/// Meshes as scans: their corners, and where triangles are large points between these.
PointCloud readObjScan(const FileBytes& bytes);
PointCloud readPlyScan(const FileBytes& bytes);
PointCloud readStlScan(const FileBytes& bytes);
PointCloud readOffScan(const FileBytes& bytes);

} // namespace bolster
