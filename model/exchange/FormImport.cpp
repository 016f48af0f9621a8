#include "FormImport.h"

#include "FileFormats.h"
#include "MeshReaders.h"

namespace bolster {

ImportedForm importForm(const QString& path, const ImportWatch& watch)
{
    if (isFileOf(FileUse::Frame, path)) {
        ImportedMesh read = importMesh(path, watch);
        if (read.mesh && !read.mesh->triangles.empty())
            return {std::move(read.mesh), nullptr, {}};
        if (read.problem.key != holdsPointsOnly && !read.mesh)
            return {nullptr, nullptr, std::move(read.problem)};
    }
    ImportedCloud read = importCloud(path, watch);
    return {nullptr, std::move(read.cloud), std::move(read.problem)};
}

} // namespace bolster
