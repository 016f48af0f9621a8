#include "EarlierPieces.h"

#include "FreeNames.h"

#include <algorithm>
#include <set>
#include <string>

namespace bolster::edits {

namespace {

/// Groups of files have "_" where names have spaces.
std::string stemOf(std::string name)
{
    std::ranges::replace(name, '_', ' ');
    return withoutNumber(name);
}

} // namespace

std::vector<ElementId> earlierPieces(const Design& design, const Design& made)
{
    std::set<std::string> names;
    made.each<Patch>([&](ElementId, const Patch& patch) { names.insert(stemOf(patch.name)); });
    std::set<ElementId> found, held, usedElsewhere;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (names.contains(stemOf(patch.name)))
            found.insert(id);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& fixation) {
        (found.contains(fixation.stretch.patch) ? held : usedElsewhere).insert(fixation.curve);
    });
    std::vector<ElementId> earlier(found.begin(), found.end());
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        if (held.contains(id) && !usedElsewhere.contains(id) && names.contains(stemOf(curve.name)))
            earlier.push_back(id);
    });
    return earlier;
}

} // namespace bolster::edits
