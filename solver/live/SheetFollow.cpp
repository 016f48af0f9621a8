#include "SheetFollow.h"

#include "DesignCheck.h"
#include "Relief.h"

#include <algorithm>

namespace bolster {

namespace {

bool bend(PreparedSheet& sheet, std::optional<PatternWarp>& warp, const OutlineSampling& sampling, WorkerPool& pool)
{
    if (!warp)
        warp.emplace(sheet.mesh);
    std::optional<std::vector<Vec2>> pattern = warp->warped(sheet.mesh, sampling, pool);
    if (pattern)
        reshape(sheet.mesh, std::move(*pattern), pool);
    return pattern.has_value();
}

} // namespace

bool sameElements(const Design& a, const Design& b)
{
    return std::equal(a.elements().begin(), a.elements().end(), b.elements().begin(), b.elements().end(),
                      [](const auto& x, const auto& y) { return x.first == y.first; });
}

bool followDesign(PreparedSheet& sheet, std::optional<PatternWarp>& warp, const SolveInput& input, SolvePlan plan,
                  WorkerPool& pool, Problems& problems)
{
    problems = checkDesign(input.design);
    const Design usable = usablePart(input.design, problems);
    if (!sameElements(usable, sheet.design))
        return false;
    OutlineSampling sampling = sheet.sampling;
    if (plan == SolvePlan::Warp) {
        if (!resample(sampling, usable) || !bend(sheet, warp, sampling, pool))
            return false;
    } else {
        retarget(sampling, usable);
        if (!sampling.problems.empty())
            return false;
    }
    sheet.sampling = std::move(sampling);
    sheet.design = usable;
    sheet.files = input.files;
    updateTargets(sheet.mesh, sheet.sampling);
    updateMaterials(sheet.mesh, usable);
    if (plan == SolvePlan::Warp)
        sheet.mesh.reliefs = makeReliefs(sheet.mesh, sheet.sampling, usable);
    else
        updateReliefs(sheet.mesh, usable);
    return true;
}

} // namespace bolster
