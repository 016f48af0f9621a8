// Frames from files, of any format that frames come in (FileFormats). Untrusted input: see the limits in the .cpp,
// and AssemblyImport.
#pragma once

#include "Assembly.h"
#include "FrameEdges.h"
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
    FileFacts said{};                         ///< what the file says of its numbers and axes
    std::vector<PartOutline> tree{};          ///< of formats with one: to which groups the parts belong
    std::string beside{};                     ///< a file of its own folder that belongs to it, if there is one
    std::vector<FrameEdge> edges{};           ///< of CAD faces, in file units, where they were asked for
};

/// The format is that of the file's ending; polygons are split into triangles. CAD faces are as fine as
/// usualTolerance.
ImportedMesh importMesh(const QString& path, const ImportWatch& watch = {}, bool withEdges = false);

} // namespace bolster
