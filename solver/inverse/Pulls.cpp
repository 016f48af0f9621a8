#include "Pulls.h"

namespace bolster {

Design withoutPulls(const Design& design)
{
    Design result = design;
    design.each<Scan>([&](ElementId id, const Scan& scan) {
        if (!scan.enabled)
            return;
        Scan still = scan;
        still.enabled = false;
        result = result.with({{}, {{id, design.element(id), makeElement(std::move(still))}}});
    });
    return result;
}

bool hasPulls(const Design& design)
{
    bool pulls = false;
    design.each<Scan>([&](ElementId, const Scan& scan) { pulls = pulls || scan.enabled; });
    return pulls;
}

bool hasSameCover(const Design& a, const Design& b)
{
    return a == b || withoutPulls(a) == withoutPulls(b);
}

} // namespace bolster
