// Bodies for printers and cutters: STL and 3MF, millimetres.
#pragma once

#include "TriangleMesh.h"

#include <string>

namespace bolster {

/// Binary STL. Numbers have single precision: points that differ by less become one.
std::string stlFile(const TriangleMesh& solid);
/// 3MF core specification 1.3, one object for each part of the mesh, whose name is a plain word; the same bytes
/// every time.
std::string threeMfFile(const TriangleMesh& solid);

} // namespace bolster
