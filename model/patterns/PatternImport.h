// Drawings from files: DXF and SVG. Untrusted input.
#pragma once

#include "Drawing.h"
#include "ImportWatch.h"
#include "Message.h"

#include <QString>

namespace bolster {

struct ImportedDrawing {
    std::optional<Drawing> drawing; ///< nothing when refused or stopped
    Message problem;                ///< why, with file and line; empty when stopped
};

/// The format is that of the file's ending.
ImportedDrawing importDrawing(const QString& path, const ImportWatch& watch = {});

} // namespace bolster
