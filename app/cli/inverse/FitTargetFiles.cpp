#include "FitTargetFiles.h"

#include "CloudImport.h"
#include "LengthUnits.h"
#include "MeshImport.h"

namespace bolster::cli {

namespace {

std::string textOf(const Message& problem)
{
    return problem.empty() ? "interrupted" : problem.english();
}

} // namespace

FitTarget targetIn(const QString& path, const Arguments& arguments, const std::stop_token& stop)
{
    const double unit = saidUnit(arguments).value_or(1);
    const bool upIsY = saysUpIsY(arguments).value_or(false);
    const auto upright = [&](std::vector<Vec3> points) {
        for (Vec3& point : points) {
            point *= unit;
            if (upIsY)
                point = {point.x(), -point.z(), point.y()};
        }
        return points;
    };
    const ImportedMesh read = importMesh(path, {stop, {}, {}});
    if (read.mesh && !read.mesh->triangles.empty()) {
        TriangleMesh mesh = *read.mesh;
        mesh.points = upright(std::move(mesh.points));
        FitTarget target = targetOf(mesh);
        if (target.empty())
            throw UsageError(path.toStdString() + ": it has no triangle with an area");
        return target;
    }
    const ImportedCloud cloud = importCloud(path, {stop, {}, {}});
    if (!cloud.cloud)
        throw UsageError(path.toStdString() + ": " + textOf(read.mesh ? cloud.problem : read.problem));
    PointCloud points = *cloud.cloud;
    points.points = upright(std::move(points.points));
    return targetOf(Scan{}, points);
}

FitTarget scanOf(const OpenedDesign& opened, const std::string& option)
{
    FitTarget target;
    int count = 0;
    opened.design.each<Scan>([&](ElementId id, const Scan& scan) {
        const auto cloud = opened.files.clouds.find(id);
        if (cloud == opened.files.clouds.end())
            return;
        if (++count == 1)
            target = targetOf(scan, *cloud->second);
    });
    if (count != 1)
        throw UsageError(count == 0
                             ? "the design has no scan whose file can be read: give one with " + option + " FILE"
                             : "the design has several scans: give the file of one with " + option + " FILE");
    return target;
}

} // namespace bolster::cli
