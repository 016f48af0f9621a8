// Drawings from files of unknown origin. Throw FileRefused, ImportStopped. No network, no other files.
#pragma once

#include "Drawing.h"
#include "FileBytes.h"

namespace bolster {

/// DXF from R12 on, ASCII or binary, and what AAMA and ASTM make of it: POLYLINE with bulges, LWPOLYLINE, LINE,
/// ARC, CIRCLE, ELLIPSE, SPLINE, POINT, TEXT, MTEXT, and INSERT of blocks with these.
Drawing readDxf(const FileBytes& bytes);

/// SVG 1.1: paths and shapes, groups, transforms, units, viewports, symbols that are used; what is hidden is not
/// drawn. Of CSS only what moves or hides something.
Drawing readSvg(const FileBytes& bytes);

} // namespace bolster
