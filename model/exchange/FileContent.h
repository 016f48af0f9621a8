// What an element's file holds: a mesh, or the points of a scan.
#pragma once

#include "Assembly.h"
#include "DesignFiles.h"
#include "Element.h"
#include "FileFormats.h"
#include "ImportWatch.h"

#include <QString>

namespace bolster {

enum class FileKind { Mesh, Cloud };

/// What the element reads its file as; the element must be of a kind with one.
FileKind fileKind(const Element& element);
FileUse fileUse(FileKind kind);

/// One of the two is there, or none when the file could not be read.
struct FileContent {
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const PointCloud> cloud;

    explicit operator bool() const { return mesh || cloud; }
    /// File units.
    const std::vector<Vec3>& points() const;
    Box3 boundingBox() const;
    void addTo(DesignFiles& files, ElementId element) const;
};

struct ImportedFile {
    FileContent content;             ///< nothing when refused or stopped
    Message problem;                 ///< why, with file and line or offset; empty when stopped
    Message warning{};               ///< what is odd about it, though it was read
    FileFacts said{};                ///< what the file says of its numbers and axes
    std::vector<PartOutline> tree{}; ///< of formats with one: to which groups the parts of the mesh belong
    std::string beside{}; ///< a file of its own folder that it cannot be read without (importFromElsewhere)
};

/// As a design reads its files: one that needs another one beside it is refused.
ImportedFile importFile(FileKind kind, const QString& path, const ImportWatch& watch = {});
/// Where it may need one: what becomes of it in a design has to be written as one file.
ImportedFile importFromElsewhere(FileKind kind, const QString& path, const ImportWatch& watch = {});

} // namespace bolster
