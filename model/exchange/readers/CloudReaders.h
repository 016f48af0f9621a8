// The readers behind importCloud, one per format: untrusted bytes in, points out. They throw FileRefused.
#pragma once

#include "FileBytes.h"
#include "PointCloud.h"

namespace bolster {

PointCloud readPlyCloud(const FileBytes& bytes); ///< the points of any PLY, with or without faces
PointCloud readXyz(const FileBytes& bytes); ///< text: x y z, perhaps colours, and anything else, a point a line
PointCloud readPcd(const FileBytes& bytes); ///< of the Point Cloud Library: text, binary and compressed

} // namespace bolster
