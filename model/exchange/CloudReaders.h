// The readers behind importCloud, one per format: untrusted bytes in, points out. They throw FileRefused.
#pragma once

#include "PointCloud.h"

#include <string_view>

namespace bolster {

PointCloud readPlyCloud(std::string_view bytes); ///< the points of any PLY, with or without faces
PointCloud readXyz(std::string_view bytes);      ///< text: x y z and anything else, a point a line
PointCloud readPcd(std::string_view bytes);      ///< of the Point Cloud Library: text, binary and compressed

} // namespace bolster
