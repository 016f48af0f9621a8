#include "Assembly.h"

#include <cmath>

namespace bolster {

Quat rotationFor(UpAxis up)
{
    switch (up) {
    case UpAxis::Y:
        return {std::sqrt(0.5), std::sqrt(0.5), 0, 0};
    case UpAxis::X:
        return {std::sqrt(0.5), 0, -std::sqrt(0.5), 0};
    case UpAxis::Z:
        break;
    }
    return Quat::Identity();
}

std::vector<PartOutline> outlinesOf(const Assembly& assembly)
{
    std::vector<PartOutline> outlines;
    for (const Assembly::Part& part : assembly.parts)
        outlines.push_back({part.name, part.parent, part.triangles.size(), part.color});
    return outlines;
}

} // namespace bolster
