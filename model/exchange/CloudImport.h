// Scans from PLY, XYZ and PCD files. Untrusted input: see the limits in CloudBuilder.
#pragma once

#include "Message.h"
#include "PointCloud.h"

#include <QString>

#include <memory>

namespace bolster {

struct ImportedCloud {
    std::shared_ptr<const PointCloud> cloud; ///< null when refused
    Message problem;                         ///< why, with file and line or offset
};

/// The format is that of the file's ending. Points that are not finite, as scanners write them where they saw
/// nothing, are left out.
ImportedCloud importCloud(const QString& path);

/// Endings without the dot: "ply", "xyz", "pcd".
QStringList cloudFileEndings();

} // namespace bolster
