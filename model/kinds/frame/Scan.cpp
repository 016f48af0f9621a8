#include "Scan.h"

#include <algorithm>

namespace bolster {

bool ScanCut::removes(const Vec3& filePoint) const
{
    const bool inside = std::ranges::all_of(halfSpaces, [&](const HalfSpace& h) { return h.contains(filePoint); });
    return inside != keep;
}

bool Scan::isCutAway(const Vec3& filePoint) const
{
    return std::ranges::any_of(cuts, [&](const ScanCut& cut) { return cut.removes(filePoint); });
}

} // namespace bolster
