// What elements refer to, and what becomes of them without it: from their descriptions.
#pragma once

#include "Element.h"
#include "Field.h"

#include <functional>
#include <vector>

namespace bolster {

struct Reference {
    ElementId id{};
    std::size_t kind = 0; ///< place in Element of what it must be; of twins std::variant_npos
    Need need = Need::Needed;

    friend bool operator==(const Reference&, const Reference&) = default;
};

/// In the order of the fields; those that name nothing are left out.
std::vector<Reference> references(const Element& element);
/// Whether it cannot be without this: fabric, patches, curve, frame, cushion.
inline bool isNeeded(const Reference& reference)
{
    return reference.need == Need::Needed || reference.need == Need::Listed;
}

/// Whether what the reference names is gone.
using IsGone = std::function<bool(const Reference&)>;
/// Whether an element goes along with what is gone: it needs that, or has lost the last of a list.
bool goesAlong(const Element& element, const IsGone& isGone);
/// What is left of an element that does without it: lists and entries lose it, what is only seen is the usual
/// again. The element itself where nothing changes.
ElementPtr without(const ElementPtr& element, const IsGone& isGone);
/// The element with other ids; the function gets what needs and shows something, not twins.
Element renumbered(Element element, const std::function<ElementId(const Reference&)>& newId);

} // namespace bolster
