#include "FitTargetFiles.h"

#include "FileFormats.h"
#include "FileGuess.h"
#include "FormImport.h"
#include "LengthUnits.h"
#include "Output.h"
#include "Pulls.h"

namespace bolster::cli {

Placement placementOf(const Arguments& arguments, const QString& file, FileFacts said)
{
    if (const std::optional<double> unit = saidUnit(arguments))
        said.millimetresPerUnit = unit;
    if (const std::optional<bool> y = saysUpIsY(arguments))
        said.up = *y ? UpAxis::Y : UpAxis::Z;
    return saidPlacement(said, endingOf(file));
}

FitTarget targetIn(const QString& path, const Arguments& arguments, const std::stop_token& stop)
{
    ImportedForm read = importForm(path, {stop, {}, {}});
    if (!read.mesh && !read.cloud)
        throw UsageError(read.problem.empty() ? "interrupted" : read.problem.english());
    read = placed(read, placementOf(arguments, path, read.said));
    FitTarget target = read.mesh ? targetOf(*read.mesh) : targetOf(Scan{}, *read.cloud);
    if (read.mesh && target.empty())
        throw UsageError(path.toStdString() + ": it has no triangle with an area");
    return target;
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

void sayOfPulls(const Design& design)
{
    if (hasPulls(design))
        printError(
            "warning: the cover of this design is pulled to a scan (\"enabled\"); here it counts as the pattern "
            "alone makes it");
}

} // namespace bolster::cli
