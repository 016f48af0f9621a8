// How large a pattern is, and how many triangles that makes.
#pragma once

#include "Design.h"

namespace bolster {

/// Of all patches, mm^2.
double patternArea(const Design& design);

/// That equilateral triangles of this edge length (mm) have on an area (mm^2), about; there are twice as many
/// triangles.
double vertexCount(double area, double edgeLength);
/// mm, that makes so many vertices of it.
double edgeLengthFor(double area, double vertices);

} // namespace bolster
