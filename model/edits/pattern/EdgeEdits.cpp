// Edges of outlines by their lengths.
#include "EdgeFit.h"
#include "LengthEdits.h"

#include <algorithm>
#include <array>

namespace bolster::edits {

namespace {

constexpr double shortestEdge = 1e-3; // mm
constexpr double longestEdge = 1e6;   // mm

const Message notAnEdge{QT_TRANSLATE_NOOP("Message", "A side of this seam does not end at corners: its length "
                                                     "cannot be changed alone."),
                        {}};

/// `fill` tells a fit what is wanted, false when there are no such edges. Those that hang together so that what
/// lies beside them cannot keep its shape give way on both sides.
template <class Fill>
Edit firstFit(const Design& design, std::span<const EdgeFit::Way> ways, const Fill& fill, const Message& verb,
              Message* problem)
{
    Message why = notAnEdge;
    for (const EdgeFit::Way way : ways) {
        EdgeFit fit(design);
        if (!fill(fit, way))
            break;
        if (fit.solve(way))
            return fit.result(verb);
        why = {QT_TRANSLATE_NOOP("Message", "These edges cannot have this length: they hang together."), {}};
    }
    if (problem)
        *problem = why;
    return {};
}

constexpr std::array truingFirst{EdgeFit::Way::Truing, EdgeFit::Way::Bending};

Message edgesVerb(const Design& design, std::span<const Stretch> edges, const char* one, const char* many)
{
    if (edges.size() == 1)
        return {one, {displayName(design, edges.front().patch)}};
    return {many, {std::to_string(edges.size())}};
}

} // namespace

std::vector<int> pointsOfEdge(const Design& design, const Stretch& edge)
{
    const Patch* patch = design.find<Patch>(edge.patch);
    return patch && !patch->outline.empty() ? edgePoints(patch->outline, edge) : std::vector<int>();
}

double edgeLength(const Design& design, const Stretch& edge)
{
    const Patch* patch = design.find<Patch>(edge.patch);
    return patch && !patch->outline.empty() ? lengthOfEdge(patch->outline, edge) : 0;
}

Edit setEdgeLengths(const Design& design, std::span<const Stretch> edges, double length, Message* problem)
{
    if (!(length >= shortestEdge && length <= longestEdge))
        return {};
    const auto fill = [&](EdgeFit& fit, EdgeFit::Way) {
        return std::ranges::all_of(edges, [&](const Stretch& edge) { return fit.add(edge, length); });
    };
    return firstFit(design, std::array{EdgeFit::Way::AboutMiddles, EdgeFit::Way::Bending}, fill,
                    edgesVerb(design, edges, QT_TRANSLATE_NOOP("Message", "Change the length of an edge of %1"),
                              QT_TRANSLATE_NOOP("Message", "Change the length of %1 edges")),
                    problem);
}

Edit makeEdgesEqual(const Design& design, std::span<const Stretch> edges, Message* problem)
{
    if (edges.size() < 2)
        return {};
    const double length = edgeLength(design, edges.front());
    const auto fill = [&](EdgeFit& fit, EdgeFit::Way) {
        return fit.pin(edges.front()) &&
               std::ranges::all_of(edges, [&](const Stretch& edge) { return fit.add(edge, length); });
    };
    return firstFit(design, truingFirst, fill,
                    {QT_TRANSLATE_NOOP("Message", "Make %1 edges equally long"), {std::to_string(edges.size())}},
                    problem);
}

Edit makeSeamSidesEqual(const Design& design, std::span<const ElementId> seams, Message* problem)
{
    bool turned = false;
    const auto fill = [&](EdgeFit& fit, EdgeFit::Way way) {
        bool all = !seams.empty();
        for (const ElementId id : seams)
            if (const Seam* seam = design.find<Seam>(id)) {
                const bool second = fit.takes(seam->b) || !fit.takes(seam->a);
                const Stretch &changed = second ? seam->b : seam->a, &kept = second ? seam->a : seam->b;
                const double length = edgeLength(design, kept);
                all = fit.add(changed, length) && all;
                turned = turned || !second;
                // It stays where it is; where corners are in common, at least as long as it is.
                if (way == EdgeFit::Way::Truing)
                    fit.pin(kept);
                else if (fit.takes(kept))
                    fit.add(kept, length);
            }
        return all;
    };
    const Message verb = seams.size() == 1
                             ? Message{QT_TRANSLATE_NOOP("Message", "Make the sides of a seam equally long"), {}}
                             : Message{QT_TRANSLATE_NOOP("Message", "Make the sides of %1 seams equally long"),
                                       {std::to_string(seams.size())}};
    Edit edit = firstFit(design, truingFirst, fill, verb, problem);
    if (turned && !edit.empty())
        edit.note = {
            QT_TRANSLATE_NOOP("Message", "The second side ends inside an edge, so the first one was changed."), {}};
    return edit;
}

} // namespace bolster::edits
