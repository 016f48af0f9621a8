#include "FileContent.h"

#include "CloudImport.h"
#include "MeshImport.h"

#include <QFileInfo>

namespace bolster {

FileKind fileKind(const Element& element)
{
    return std::holds_alternative<Scan>(element) ? FileKind::Cloud : FileKind::Mesh;
}

FileUse fileUse(FileKind kind)
{
    return kind == FileKind::Mesh ? FileUse::Frame : FileUse::Scan;
}

const std::vector<Vec3>& FileContent::points() const
{
    static const std::vector<Vec3> none;
    return mesh ? mesh->points : cloud ? cloud->points : none;
}

Box3 FileContent::boundingBox() const
{
    Box3 box;
    for (const Vec3& point : points())
        box.extend(point);
    return box;
}

void FileContent::addTo(DesignFiles& files, ElementId element) const
{
    if (mesh)
        files.meshes.emplace(element, mesh);
    if (cloud)
        files.clouds.emplace(element, cloud);
}

ImportedFile importFile(FileKind kind, const QString& path, const ImportWatch& watch)
{
    ImportedFile imported = importFromElsewhere(kind, path, watch);
    if (imported.content && !imported.beside.empty())
        return {{},
                {QT_TRANSLATE_NOOP("Message",
                                   "\"%1\" needs the file \"%2\" beside it, and the frame of a design is one "
                                   "file; import it again, or export it as GLB"),
                 {QFileInfo(path).fileName().toStdString(), imported.beside}}};
    return imported;
}

ImportedFile importFromElsewhere(FileKind kind, const QString& path, const ImportWatch& watch)
{
    if (kind == FileKind::Cloud) {
        ImportedCloud imported = importCloud(path, watch);
        return {{nullptr, std::move(imported.cloud)}, std::move(imported.problem), std::move(imported.warning)};
    }
    ImportedMesh imported = importMesh(path, watch);
    return {{std::move(imported.mesh), nullptr},
            std::move(imported.problem),
            std::move(imported.warning),
            imported.said,
            std::move(imported.tree),
            std::move(imported.beside)};
}

} // namespace bolster
