// Files of covers on the disk.
#pragma once

#include "CoverFiles.h"

#include <QString>

#include <functional>

namespace bolster {

/// Writes a file and what belongs beside it, each as a whole; the file itself comes last. `isInput` says of a path
/// that is there whether the design needs what is in it: then nothing is written over it. The problem of the file
/// that was made is given back where there is one.
Message writeCoverFile(const CoverFile& file, const QString& path,
                       const std::function<bool(const QString&)>& isInput);

} // namespace bolster
