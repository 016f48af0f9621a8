// The readers behind importMesh, one per format: untrusted bytes in, a mesh out. They throw FileRefused.
#pragma once

#include "FileBytes.h"
#include "TriangleMesh.h"

namespace bolster {

TriangleMesh readObj(const FileBytes& bytes); ///< Wavefront: v, f, and g or o as parts
TriangleMesh readPly(const FileBytes& bytes); ///< text and binary of both byte orders
TriangleMesh readStl(const FileBytes& bytes); ///< text and binary; corners at one place become one point
TriangleMesh readOff(const FileBytes& bytes); ///< text

} // namespace bolster
