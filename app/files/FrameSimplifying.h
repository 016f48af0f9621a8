// A frame with fewer triangles, as a file of its own.
#pragma once

#include "FileContent.h"
#include "Message.h"

#include <QString>

#include <memory>

class QTemporaryDir;

namespace bolster {

struct SimplifiedFrame {
    QString path;        ///< of the file; it is there as long as the folder is
    FileContent content; ///< what it holds; nothing when it could not be written or was stopped
    Message problem;     ///< why
    std::shared_ptr<QTemporaryDir> folder;
};

/// Writes the mesh of the file `path` without the `unwanted` parts, with about so many triangles, as OBJ into a
/// folder for a moment. Takes seconds: call it on a thread of its own.
SimplifiedFrame simplifiedFrame(const QString& path, const TriangleMesh& mesh,
                                const std::vector<std::string>& unwanted, std::size_t triangles,
                                const ImportWatch& watch);

} // namespace bolster
