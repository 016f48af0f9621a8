#include "FormImport.h"

#include "FileFormats.h"
#include "MeshReaders.h"

namespace bolster {

ImportedForm importForm(const QString& path, const ImportWatch& watch)
{
    if (isFileOf(FileUse::Frame, path)) {
        ImportedMesh read = importMesh(path, watch);
        if (read.mesh && !read.mesh->triangles.empty())
            return {std::move(read.mesh), nullptr, {}, read.said};
        if (read.problem.key != holdsPointsOnly && !read.mesh)
            return {nullptr, nullptr, std::move(read.problem)};
    }
    ImportedCloud read = importCloud(path, watch);
    return {nullptr, std::move(read.cloud), std::move(read.problem)};
}

ImportedForm placed(const ImportedForm& form, const Placement& placement)
{
    ImportedForm there = form;
    const auto place = [&]<class Points>(const std::shared_ptr<const Points>& from) {
        auto points = std::make_shared<Points>(*from);
        for (Vec3& point : points->points)
            point = placement.placed(point);
        return points;
    };
    if (form.mesh)
        there.mesh = place(form.mesh);
    if (form.cloud)
        there.cloud = place(form.cloud);
    return there;
}

} // namespace bolster
