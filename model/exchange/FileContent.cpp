#include "FileContent.h"

#include "CloudImport.h"
#include "MeshImport.h"

namespace bolster {

FileKind fileKind(const Element& element)
{
    return std::holds_alternative<Scan>(element) ? FileKind::Cloud : FileKind::Mesh;
}

QStringList fileEndings(FileKind kind)
{
    return kind == FileKind::Mesh ? meshFileEndings() : cloudFileEndings();
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
    if (kind == FileKind::Cloud) {
        ImportedCloud imported = importCloud(path, watch);
        return {{nullptr, std::move(imported.cloud)}, std::move(imported.problem), std::move(imported.warning)};
    }
    ImportedMesh imported = importMesh(path, watch);
    return {{std::move(imported.mesh), nullptr}, std::move(imported.problem), std::move(imported.warning)};
}

} // namespace bolster
