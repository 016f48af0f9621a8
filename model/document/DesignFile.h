// Designs on disk in their text form, with what is in the files they refer to.
#pragma once

#include "DesignJson.h"
#include "FileContent.h"

#include <stop_token>

namespace bolster {

struct OpenedDesign {
    Design design;
    DesignFiles files; ///< what could be read of them
    Problems problems; ///< of reading and of checkDesign, missing files ...
    bool readable = false;
};

/// Reads a design and the files beside it (or in `filesFolder`, for a copy that lies elsewhere). Never throws; a
/// missing file is a problem like any other: that of the design names no element, that of an element its field
/// "file".
OpenedDesign openDesign(const QString& path, const QString& filesFolder = {}, const std::stop_token& stop = {});

/// The text alone. The problems of one that cannot be read name the file.
ReadDesign readDesignFile(const QString& path);

/// The same as openDesign from a design that has been read: checks it and reads the files in the folder, each once.
/// When it is stopped some are missing. Throws std::bad_alloc.
OpenedDesign openReadDesign(ReadDesign read, const QString& filesFolder, const std::stop_token& stop = {});

/// The element's file with links resolved; empty, and a problem, when it is not there or not inside the folder.
QString elementFilePath(const Element& element, const QString& folder, Message& problem);

/// Reads the file of one element; `folder` is the design's. Links are followed, but not out of the folder.
ImportedFile readElementFile(const Element& element, const QString& folder);

/// Writes to a temporary file in the same folder, syncs it and renames it over `path`. Returns what went wrong,
/// or an empty message; the old file is untouched then.
Message saveDesign(const Design& design, const QString& path);

} // namespace bolster
