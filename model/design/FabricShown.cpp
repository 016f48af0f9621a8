#include "FabricShown.h"

#include <algorithm>
#include <numbers>

namespace bolster {

ElementId fabricShown(const Design& design, ElementId patch)
{
    return fabricShown(design, patch, design.settings().colourway);
}

ElementId fabricShown(const Design& design, ElementId patch, ElementId colourway)
{
    const auto* own = design.find<Patch>(patch);
    if (!own)
        return noElement;
    if (const auto* shown = design.find<Colourway>(colourway)) {
        const auto entry = std::ranges::find(shown->fabrics, patch, &Colourway::Entry::patch);
        if (entry != shown->fabrics.end() && design.find<Fabric>(entry->fabric))
            return entry->fabric;
    }
    return own->fabric;
}

double clothTurn(const Patch& patch, const Fabric& fabric)
{
    return (patch.grain - 90 + fabric.look.rotation) * std::numbers::pi / 180;
}

} // namespace bolster
