#include "PatternSize.h"

#include <cmath>

namespace bolster {

namespace {

const double areaOfVertex = std::sqrt(0.75); // of the square of an edge

} // namespace

double patternArea(const Design& design)
{
    double area = 0;
    design.each<Patch>([&](ElementId, const Patch& patch) {
        area += patch.outline.empty() ? 0 : std::abs(patch.outline.signedArea());
    });
    return area;
}

double vertexCount(double area, double edgeLength)
{
    return area / (areaOfVertex * edgeLength * edgeLength);
}

double edgeLengthFor(double area, double vertices)
{
    return std::sqrt(area / (areaOfVertex * vertices));
}

} // namespace bolster
