// The readers behind importMesh, one per format: untrusted bytes in, a mesh out. They throw FileRefused.
#pragma once

#include "TriangleMesh.h"

#include <string_view>

namespace bolster {

TriangleMesh readObj(std::string_view bytes); ///< Wavefront: v, f, and g or o as parts
TriangleMesh readPly(std::string_view bytes); ///< text and binary of both byte orders
TriangleMesh readStl(std::string_view bytes); ///< text and binary; corners at one place become one point
TriangleMesh readOff(std::string_view bytes); ///< text

} // namespace bolster
