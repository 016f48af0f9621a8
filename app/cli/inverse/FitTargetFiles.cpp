#include "FitTargetFiles.h"

#include "FormImport.h"
#include "LengthUnits.h"

namespace bolster::cli {

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
    const ImportedForm read = importForm(path, {stop, {}, {}});
    if (read.mesh) {
        TriangleMesh mesh = *read.mesh;
        mesh.points = upright(std::move(mesh.points));
        FitTarget target = targetOf(mesh);
        if (target.empty())
            throw UsageError(path.toStdString() + ": it has no triangle with an area");
        return target;
    }
    if (!read.cloud)
        throw UsageError(read.problem.empty() ? "interrupted" : read.problem.english());
    PointCloud points = *read.cloud;
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
