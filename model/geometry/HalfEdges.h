// The sides of triangles, sorted by edge: for triangles that need not form a surface, as any number of them may
// share an edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace bolster {

/// A side of a triangle.
struct HalfEdge {
    int low = 0; ///< the lesser end
    int high = 0;
    int triangle = 0;
    std::uint8_t side = 0; ///< from this corner of the triangle to the next one
    bool forward = false;  ///< from low to high

    bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

void sortByEdge(std::vector<HalfEdge>& halves, const std::stop_token& stop);

/// Sorted, so that those of one edge follow each other. When stopped the order means nothing.
template <class Index>
std::vector<HalfEdge> halfEdges(const std::vector<std::array<Index, 3>>& triangles,
                                const std::stop_token& stop = {})
{
    std::vector<HalfEdge> halves;
    halves.reserve(3 * triangles.size());
    for (int t = 0; t < std::ssize(triangles); ++t)
        for (std::uint8_t side = 0; side < 3; ++side) {
            const int a = static_cast<int>(triangles[t][side]), b = static_cast<int>(triangles[t][(side + 1) % 3]);
            halves.push_back({std::min(a, b), std::max(a, b), t, side, a < b});
        }
    sortByEdge(halves, stop);
    return halves;
}

/// Calls visit(first, last) for the half edges of each edge: pointers to the first and behind the last.
template <class Visit>
void eachEdge(const std::vector<HalfEdge>& halves, Visit visit)
{
    const HalfEdge* const end = halves.data() + halves.size();
    for (const HalfEdge *first = halves.data(), *last = first; first != end; first = last) {
        while (last != end && last->sameEdge(*first))
            ++last;
        visit(first, last);
    }
}

} // namespace bolster
