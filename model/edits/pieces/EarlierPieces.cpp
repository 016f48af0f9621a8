#include "EarlierPieces.h"

#include <algorithm>
#include <set>
#include <string>

namespace bolster::edits {

namespace {

/// "Seat" of "Seat 2".
std::string withoutNumber(const std::string& name)
{
    const std::size_t space = name.find_last_of(' ');
    const bool numbered = space != std::string::npos && space > 0 && space + 1 < name.size() &&
                          name.find_first_not_of("0123456789", space + 1) == std::string::npos;
    return numbered ? name.substr(0, space) : name;
}

} // namespace

std::vector<ElementId> earlierPieces(const Design& design, const Design& made)
{
    std::set<std::string> names;
    made.each<Patch>([&](ElementId, const Patch& patch) { names.insert(withoutNumber(patch.name)); });
    std::set<ElementId> found, held, usedElsewhere;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (names.contains(withoutNumber(patch.name)))
            found.insert(id);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& fixation) {
        (found.contains(fixation.stretch.patch) ? held : usedElsewhere).insert(fixation.curve);
    });
    std::vector<ElementId> earlier(found.begin(), found.end());
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        if (held.contains(id) && !usedElsewhere.contains(id) && names.contains(withoutNumber(curve.name)))
            earlier.push_back(id);
    });
    return earlier;
}

} // namespace bolster::edits
