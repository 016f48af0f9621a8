#include "DesignCheck.h"

namespace bolster {

Problems checkDesign(const Design&)
{
    return {};
}

Design usablePart(const Design& design, const Problems&, Problems*)
{
    return design;
}

double seamEase(const Design&, const Seam&)
{
    return 0;
}

std::optional<Vec2> selfIntersection(const BSpline2&)
{
    return std::nullopt;
}

} // namespace bolster
