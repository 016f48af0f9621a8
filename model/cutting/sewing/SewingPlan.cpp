#include "SewingPlan.h"

#include "SewnPair.h"

#include <algorithm>

namespace bolster {

namespace {

/// Parts of the cover that hang together.
class Parts {
public:
    ElementId of(ElementId patch)
    {
        ElementId& parent = m_parent.try_emplace(patch, patch).first->second;
        return parent == patch ? patch : parent = of(parent);
    }
    int pieces(ElementId patch) { return m_pieces.try_emplace(of(patch), 1).first->second; }
    void join(ElementId a, ElementId b)
    {
        const int together = pieces(a) + pieces(b);
        const ElementId into = of(a);
        m_parent[of(b)] = into;
        m_pieces[into] = together;
    }

private:
    std::map<ElementId, ElementId> m_parent;
    std::map<ElementId, int> m_pieces;
};

double allowanceAt(const Design& design, const Patch& patch, const CutOptions& options, const OutlinePlace& place)
{
    double width = allowanceOf(design, patch, options.allowance).width;
    design.each<EdgeAllowance>([&](ElementId, const EdgeAllowance& edge) {
        if (edge.stretch.patch != place.patch)
            return;
        const double period = patch.outline.period();
        const double end = unwrappedEnd(edge.stretch.from, edge.stretch.to, patch.outline.domainStart(),
                                        patch.outline.domainEnd());
        const double t = place.at - period * std::floor((place.at - edge.stretch.from) / period);
        if (t < end)
            width = edge.width;
    });
    return width;
}

std::vector<PlannedSeam> allSeams(const Design& design, const CutPattern& pattern, const CutOptions& options)
{
    std::map<ElementId, const CutPiece*> pieces;
    for (const CutPiece& piece : pattern.pieces)
        pieces.try_emplace(piece.patch, &piece);
    std::vector<PlannedSeam> seams;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const SewnPair pair(design, seam);
        if (!pair.usable() || !pieces.contains(seam.a.patch) || !pieces.contains(seam.b.patch))
            return;
        PlannedSeam planned;
        planned.seam = id;
        planned.patchA = seam.a.patch;
        planned.patchB = seam.b.patch;
        planned.lengthA = pair.lengthA();
        planned.lengthB = pair.lengthB();
        planned.ease = pair.lengthA() > 0 ? 100 * (pair.lengthB() / pair.lengthA() - 1) : 0;
        planned.allowanceA =
            allowanceAt(design, *design.find<Patch>(seam.a.patch), options, {seam.a.patch, pair.onA(0.5)});
        planned.allowanceB =
            allowanceAt(design, *design.find<Patch>(seam.b.patch), options, {seam.b.patch, pair.onB(0.5)});
        for (const CutNotch& notch : pieces[seam.a.patch]->notches)
            planned.notches += notch.seam == id;
        planned.trim = seam.trim;
        seams.push_back(std::move(planned));
    });
    return seams;
}

/// What comes next; smaller is sooner.
std::tuple<int, int, double> rank(const PlannedSeam& seam, Parts& parts, int all)
{
    if (seam.patchA == seam.patchB)
        return {0, 0, seam.lengthA};
    const bool together = parts.of(seam.patchA) == parts.of(seam.patchB);
    const int pieces = together ? parts.pieces(seam.patchA) : parts.pieces(seam.patchA) + parts.pieces(seam.patchB);
    if (together && pieces >= all)
        return {3, 0, seam.lengthA};
    return {together ? 1 : 2, pieces, seam.lengthA};
}

std::vector<PlannedSeam> inOrder(std::vector<PlannedSeam> seams, std::size_t pieces)
{
    Parts parts;
    std::vector<PlannedSeam> ordered;
    while (!seams.empty()) {
        const auto next = std::ranges::min_element(
            seams, {}, [&](const PlannedSeam& seam) { return rank(seam, parts, static_cast<int>(pieces)); });
        next->closes = next->patchA != next->patchB && parts.of(next->patchA) == parts.of(next->patchB);
        if (parts.of(next->patchA) != parts.of(next->patchB))
            parts.join(next->patchA, next->patchB);
        ordered.push_back(std::move(*next));
        seams.erase(next);
    }
    return ordered;
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
    }
}

} // namespace

SewingPlan sewingPlan(const Design& design, const CutOptions& options)
{
    SewingPlan plan;
    plan.pattern = cutPattern(design, options);
    plan.seams = inOrder(allSeams(design, plan.pattern, options), plan.pattern.pieces.size());
    addNeeds(plan);
    return plan;
}

} // namespace bolster
