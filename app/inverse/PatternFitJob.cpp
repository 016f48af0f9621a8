#include "PatternFitJob.h"

#include "CloudImport.h"
#include "MeshImport.h"
#include "SolveFailure.h"

namespace bolster {

namespace {

/// False, and a reason, when it cannot be read.
bool readTarget(const FitForm& form, FitTarget& target, Message& problem, const std::stop_token& stop)
{
    if (form.scan && form.cloud) {
        target = targetOf(*form.scan, *form.cloud);
        return true;
    }
    if (form.file.isEmpty())
        return true;
    const ImportedMesh read = importMesh(form.file, {stop, {}, {}});
    if (read.mesh && !read.mesh->triangles.empty()) {
        target = targetOf(*read.mesh);
        return true;
    }
    const ImportedCloud cloud = importCloud(form.file, {stop, {}, {}});
    if (cloud.cloud)
        target = targetOf(Scan{}, *cloud.cloud);
    problem = read.mesh ? cloud.problem : read.problem;
    return cloud.cloud != nullptr;
}

} // namespace

FitFound fitTo(const FitWanted& wanted, const std::function<void(double, const FitRound&)>& progress,
               const std::stop_token& stop)
{
    FitFound found{wanted.number, wanted.order.freedoms, {}};
    found.result.design = wanted.input.design;
    try {
        FitOrder order = wanted.order;
        if (readTarget(wanted.form, order.goals.target, found.result.reason, stop))
            found.result = fitPattern(wanted.input, order, progress, stop);
    } catch (const std::exception& error) {
        found.result.reason = failureMessage(error);
    }
    return found;
}

} // namespace bolster
