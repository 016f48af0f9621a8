#include "SpokenName.h"

#include "Element.h"

namespace bolster {

std::string spokenName(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    if (!element)
        return {};
    const std::string& name = elementName(*element);
    return name.empty() ? elementLabel(id, *element) : shortened(name);
}

} // namespace bolster
