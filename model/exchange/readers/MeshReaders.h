// The readers behind importMesh, one per format: untrusted bytes in, a mesh out. They throw FileRefused.
#pragma once

#include "FileBytes.h"
#include "Message.h"
#include "TriangleMesh.h"

namespace bolster {

/// Why a file that may hold a mesh is refused though it can be read.
inline constexpr auto* holdsPointsOnly =
    QT_TRANSLATE_NOOP("Message", "%1 holds points only; a frame needs faces between them");

TriangleMesh readObj(const FileBytes& bytes); ///< Wavefront: v, f, and g or o as parts
TriangleMesh readPly(const FileBytes& bytes); ///< text and binary of both byte orders
TriangleMesh readStl(const FileBytes& bytes); ///< text and binary; corners at one place become one point
TriangleMesh readOff(const FileBytes& bytes); ///< text

} // namespace bolster
