// Frames from OBJ, PLY, STL and OFF files. Untrusted input: see the limits in the .cpp.
#pragma once

#include "ImportWatch.h"
#include "Message.h"
#include "TriangleMesh.h"

#include <QString>

#include <memory>

namespace bolster {

struct ImportedMesh {
    std::shared_ptr<const TriangleMesh> mesh; ///< null when refused or stopped
    Message problem;                          ///< why, with file and line or offset; empty when stopped
    Message warning{};                        ///< what is odd about it, though it was read
};

/// The format is that of the file's ending; polygons are split into triangles.
ImportedMesh importMesh(const QString& path, const ImportWatch& watch = {});

/// Endings without the dot: "obj", "ply", "stl", "off".
QStringList meshFileEndings();

} // namespace bolster
