// The cover as OBJ and PLY for other programs: millimetres and the design's axes.
#pragma once

#include "Design.h"
#include "SurfaceMesh.h"

#include <QString>

namespace bolster {

/// OBJ with texture coordinates (outline millimetres), normals and a group per patch, sewn vertices at identical
/// positions. Written to a temporary file and renamed. Returns what went wrong, or an empty message.
Message exportObj(const SurfaceMesh& surface, const Design& design, const QString& path);
/// Binary little-endian PLY with normals, texture coordinates (s, t) and the patch id per face.
Message exportPly(const SurfaceMesh& surface, const Design& design, const QString& path);

} // namespace bolster
