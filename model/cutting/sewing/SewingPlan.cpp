#include "SewingPlan.h"

#include "CutMarks.h"
#include "SewingOrder.h"
#include "SewnPair.h"

#include <algorithm>

namespace bolster {

namespace {

int notchesAt(const CutPiece& piece, ElementId seam)
{
    return static_cast<int>(std::ranges::count(piece.notches, seam, &CutNotch::seam));
}

std::vector<PlannedSeam> plannedSeams(const Design& design, const CutPattern& pattern, const CutOptions& options)
{
    std::map<ElementId, const CutPiece*> pieces;
    for (const CutPiece& piece : pattern.pieces)
        pieces.try_emplace(piece.patch, &piece);
    const MarksByPatch marks = cutMarks(design);
    std::vector<PlannedSeam> seams;
    for (const SewingStep& step : sewingOrder(design)) {
        const Seam& seam = *design.find<Seam>(step.seam);
        const SewnPair pair(design, seam);
        if (!pair.usable() || !pieces.contains(seam.a.patch) || !pieces.contains(seam.b.patch))
            continue;
        const auto allowance = [&](const Stretch& side, double at) {
            return allowanceAt(design, marks, {side.patch, at}, options.allowance);
        };
        PlannedSeam planned;
        planned.seam = step.seam;
        planned.patchA = seam.a.patch;
        planned.patchB = seam.b.patch;
        planned.lengthA = pair.lengthA();
        planned.lengthB = pair.lengthB();
        const double shorter = std::min(planned.lengthA, planned.lengthB);
        planned.ease = shorter > 0 ? 100 * (planned.lengthB - planned.lengthA) / shorter : 0;
        planned.allowanceA = allowance(seam.a, pair.onA(0.5));
        planned.allowanceB = allowance(seam.b, pair.onB(0.5));
        planned.notches = notchesAt(*pieces[seam.a.patch], step.seam);
        planned.trim = seam.trim;
        planned.zip = seam.zip;
        planned.closes = step.closes;
        seams.push_back(std::move(planned));
    }
    return seams;
}

void addNeeds(SewingPlan& plan)
{
    for (const CutPiece& piece : plan.pattern.pieces) {
        auto need = std::ranges::find(plan.fabrics, piece.fabricName, &FabricNeed::name);
        if (need == plan.fabrics.end())
            need = plan.fabrics.insert(plan.fabrics.end(), {piece.fabricName, 0});
        need->area += std::abs(areaOf(piece.cut)) * piece.quantity * (piece.pair ? 2 : 1);
    }
    for (const PlannedSeam& seam : plan.seams) {
        const double length = (seam.lengthA + seam.lengthB) / 2;
        plan.thread[""] += threadPerSeam * length;
        const int rows =
            seam.trim.stitch == SeamTrim::Stitch::Twin ? 2 : seam.trim.stitch == SeamTrim::Stitch::Single;
        if (rows > 0)
            plan.thread[seam.trim.thread] += threadPerSeam * rows * length;
        if (seam.trim.hasPiping())
            plan.piping += length;
        if (seam.zip)
            plan.zips += length;
    }
}

} // namespace

SewingPlan sewingPlan(const Design& design, const CutOptions& options, const std::stop_token& stop)
{
    SewingPlan plan;
    plan.pattern = cutPattern(design, options, stop);
    if (stop.stop_requested())
        return plan;
    plan.seams = plannedSeams(design, plan.pattern, options);
    addNeeds(plan);
    return plan;
}

} // namespace bolster
