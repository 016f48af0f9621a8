// Where a sheet falls into two halves. Private to the library.
#pragma once

#include "FormSheet.h"

#include <stop_token>
#include <vector>

namespace bolster {

/// Numbers that are negative in one half and positive in the other one.
struct Halves {
    std::vector<double> ofTriangles, ofPoints;
};

/// Each is at least a tenth of the area, if triangles are small; they part where the sheet bends, or where it is
/// narrow. Empty when stopped, or where it cannot be found.
/// Source: Fiedler, "A property of eigenvectors of nonnegative symmetric matrices", 1975; of the triangles, where
/// it is as far across an edge as along an arc that bends as much and is as long as the sheet is large.
Halves halvesOf(const FormSheet& sheet, const std::stop_token& stop);

} // namespace bolster
