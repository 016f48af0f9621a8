// Designs on disk in their text form, with the frames they refer to.
#pragma once

#include "Design.h"
#include "TriangleMesh.h"

#include <QString>

#include <map>
#include <memory>

namespace bolster {

using FrameMeshes = std::map<ElementId, std::shared_ptr<const TriangleMesh>>;

struct OpenedDesign {
    Design design;
    FrameMeshes frames; ///< of the frames that could be read
    Problems problems;  ///< of reading and of checkDesign, missing frame files ...
    bool readable = false;
};

/// Reads a design and the frame files beside it (or in `frameFolder`, for a copy that lies elsewhere). Never
/// throws; a missing file is a problem like any other: that of the design names no element, that of a frame its
/// field "file".
OpenedDesign openDesign(const QString& path, const QString& frameFolder = {});

/// Reads the mesh of one frame; `folder` is the design's. Links are followed, but not out of the folder.
std::shared_ptr<const TriangleMesh> readFrame(const Frame& frame, const QString& folder, Message* problem);

/// Writes to a temporary file in the same folder, syncs it and renames it over `path`. Returns what went wrong,
/// or an empty message; the old file is untouched then.
Message saveDesign(const Design& design, const QString& path);

} // namespace bolster
