#include "HalfEdges.h"

#include "SortUnlessStopped.h"

#include <tuple>

namespace bolster {

void sortByEdge(std::vector<HalfEdge>& halves, const std::stop_token& stop)
{
    const auto less = [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    };
    sortUnlessStopped(halves, less, stop);
}

} // namespace bolster
