// Scans from the files of scanners, and from meshes. Untrusted input: see the limits in CloudBuilder.
#pragma once

#include "ImportWatch.h"
#include "Message.h"
#include "PointCloud.h"

#include <QString>

#include <memory>

namespace bolster {

struct ImportedCloud {
    std::shared_ptr<const PointCloud> cloud; ///< null when refused or stopped
    Message problem;                         ///< why, with file and line or offset; empty when stopped
    Message warning{};                       ///< what is odd about it, though it was read
};

/// The format is that of the file's ending. Points that are not finite, as scanners write them where they saw
/// nothing, are left out. The file is read a piece at a time; of more than 5 million points only one in each cube
/// of a grid is kept (PointCloud::spacing).
ImportedCloud importCloud(const QString& path, const ImportWatch& watch = {});

} // namespace bolster
