// Frames as OBJ, PLY and STL for other programs.
#pragma once

#include "Message.h"
#include "TriangleMesh.h"

#include <QString>

namespace bolster {

/// Whether writeMesh writes files with this ending (lower case, without the dot).
bool isMeshExport(const QString& ending);

inline constexpr const char* usualMeshNote = "millimetres, z up";

/// The format is that of the file's ending: OBJ with a group for each part, whose characters other than letters,
/// digits,
/// "-" and "." become "_"; binary little-endian PLY with the number of the part for each face; binary STL. Written
/// to a temporary file and renamed. `note` is in its head. Returns what went wrong, or an empty message.
Message writeMesh(const TriangleMesh& mesh, const QString& path, const std::string& note = usualMeshNote);

} // namespace bolster
