#include "EarlierPieces.h"

#include "FreeNames.h"
#include "LayoutEdits.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace bolster::edits {

namespace {

/// Groups of files have "_" where names have spaces.
std::string spaced(std::string name)
{
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string stemOf(std::string name)
{
    return withoutNumber(spaced(std::move(name)));
}

template <class Named>
void addNames(const Design& design, const Design& made, Edit& edit)
{
    std::map<std::string, std::string> names;
    design.each<Named>([&](ElementId, const Named& named) { names.emplace(spaced(named.name), named.name); });
    made.each<Named>([&](ElementId id, const Named& named) {
        const auto known = names.find(spaced(named.name));
        if (known == names.end() || known->second == named.name)
            return;
        Named renamed = named;
        renamed.name = known->second;
        edit.changes.push_back({id, made.element(id), makeElement(std::move(renamed))});
    });
}

constexpr double muchLarger = 1.3; // times: it would lie on its neighbours

bool aboutAsLarge(const Box2& one, const Box2& other)
{
    return (one.sizes().array() < muchLarger * other.sizes().array()).all() &&
           (other.sizes().array() < muchLarger * one.sizes().array()).all();
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

Design withEarlierNames(const Design& design, const Design& made)
{
    Edit edit;
    addNames<Patch>(design, made, edit);
    addNames<FixationCurve>(design, made, edit);
    return edit.empty() ? made : made.with(edit);
}

std::optional<Design> withEarlierPlaces(const Design& design, const Design& made)
{
    std::map<std::string, Box2> boxes;
    design.each<Patch>([&](ElementId, const Patch& patch) { boxes.emplace(spaced(patch.name), layoutBox(patch)); });
    Edit edit;
    bool all = true;
    made.each<Patch>([&](ElementId id, const Patch& patch) {
        const auto earlier = boxes.find(spaced(patch.name));
        const Box2 now = layoutBox(patch);
        if (earlier == boxes.end() || !aboutAsLarge(now, earlier->second)) {
            all = false;
            return;
        }
        Patch placed = patch;
        placed.position += earlier->second.center() - now.center();
        edit.changes.push_back({id, made.element(id), makeElement(std::move(placed))});
    });
    if (!all)
        return std::nullopt;
    return made.with(edit);
}

} // namespace bolster::edits
