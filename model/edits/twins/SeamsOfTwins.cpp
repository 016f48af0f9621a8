#include "SeamsOfTwins.h"

#include "ElementStretches.h"
#include "SewnMirror.h"
#include "Twins.h"

namespace bolster::edits {

namespace {

/// Calls visit(id, stretches before, stretches now) for each seam that the edit has left in the design.
template <class Visit>
void eachKept(const Design& before, const Design& now, const Visit& visit)
{
    for (const auto& [id, element] : now.elements()) {
        const std::vector<Stretch> after = stretchesOf(*element);
        const ElementPtr old = after.empty() ? nullptr : before.element(id);
        if (old && old->index() == element->index())
            visit(id, stretchesOf(*old), after);
    }
}

/// What the edit has done to the stretches on a patch. Where an outline is put together anew, one end can be that
/// of a stretch that has moved and of another one that has stayed.
struct Moves {
    std::map<std::pair<double, double>, std::pair<double, double>> stretches; ///< new parameters by old ones
    std::map<double, double> ends;
};

Moves movesOn(ElementId patch, const Design& before, const Design& now)
{
    Moves moves;
    eachKept(before, now, [&](ElementId, const std::vector<Stretch>& old, const std::vector<Stretch>& after) {
        for (std::size_t i = 0; i < old.size(); ++i)
            if (old[i].patch == patch && after[i].patch == patch) {
                moves.stretches.emplace(std::pair(old[i].from, old[i].to), std::pair(after[i].from, after[i].to));
                if (old[i] == after[i])
                    continue;
                moves.ends.emplace(old[i].from, after[i].from);
                moves.ends.emplace(old[i].to, after[i].to);
            }
    });
    return moves;
}

Design withMoves(const Moves& moves, ElementId patch, const Design& before, const Design& now)
{
    Edit edit;
    const auto moved = [&](double parameter) {
        const auto found = moves.ends.find(parameter);
        return found == moves.ends.end() ? parameter : found->second;
    };
    const auto movedStretch = [&](const Stretch& stretch) {
        const auto found = moves.stretches.find({stretch.from, stretch.to});
        return found == moves.stretches.end() ? Stretch{patch, moved(stretch.from), moved(stretch.to)}
                                              : Stretch{patch, found->second.first, found->second.second};
    };
    eachKept(before, now, [&](ElementId id, const std::vector<Stretch>& old, std::vector<Stretch> after) {
        const std::vector<Stretch> given = after;
        for (std::size_t i = 0; i < old.size(); ++i)
            if (after[i].patch == patch && old[i] == after[i])
                after[i] = movedStretch(after[i]);
        if (after != given)
            edit.changes.push_back({id, nullptr, withStretches(*now.element(id), after)});
    });
    return now.with(edit);
}

} // namespace

Design withTwinSeams(const Design& before, const Design& now)
{
    Design result = now;
    // New twins have got their seams from what made them twins.
    for (const auto& [follower, original] : heldPairs(now, before))
        for (const auto& [patch, twin] : {std::pair(original, follower), std::pair(follower, original)}) {
            const auto* old = before.find<Patch>(patch);
            const auto* edited = now.find<Patch>(patch);
            if (old && edited && old->outline.knots() != edited->outline.knots())
                result = withMoves(movesOn(patch, before, now), twin, before, result);
        }
    return result;
}

} // namespace bolster::edits
