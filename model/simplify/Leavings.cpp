#include "Leavings.h"

#include "HalfEdges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <tuple>

namespace bolster {
namespace {

constexpr std::size_t mostOfPocket = 8; // triangles
constexpr std::size_t fewOf = 100;      // a hundredth of the triangles are few

void erase(Corners& corners, const std::vector<bool>& gone)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < gone.size(); ++t)
        if (!gone[t])
            for (std::size_t side = 0; side < 3; ++side)
                corners[kept++] = corners[3 * t + side];
    corners.resize(kept);
}

void eraseFins(Corners& corners)
{
    struct Triangle {
        std::array<std::uint32_t, 3> sorted;
        bool turned; ///< its corners run the other way
        std::size_t number;
    };
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < corners.size() / 3; ++t) {
        const std::array<std::uint32_t, 3> as{corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
        std::array<std::uint32_t, 3> sorted = as;
        std::ranges::sort(sorted);
        const auto least = static_cast<std::size_t>(std::ranges::min_element(as) - as.begin());
        triangles.push_back({sorted, as[(least + 1) % 3] != sorted[1], t});
    }
    std::ranges::sort(triangles, {}, [](const Triangle& t) { return std::tuple(t.sorted, t.turned, t.number); });
    std::vector<bool> gone(triangles.size(), false);
    std::size_t pairs = 0;
    for (std::size_t k = 1; k < triangles.size(); ++k)
        if (triangles[k].sorted == triangles[k - 1].sorted && triangles[k].turned != triangles[k - 1].turned) {
            gone[triangles[k].number] = gone[triangles[k - 1].number] = true;
            ++pairs;
        }
    if (pairs > 0 && pairs <= triangles.size() / fewOf)
        erase(corners, gone);
}

/// Triangles behind edges that more than two of them share.
class Pockets {
public:
    explicit Pockets(const Corners& corners)
    {
        std::vector<std::array<std::uint32_t, 3>> triangles(corners.size() / 3);
        for (std::size_t t = 0; t < triangles.size(); ++t)
            std::copy_n(corners.begin() + static_cast<std::ptrdiff_t>(3 * t), 3, triangles[t].begin());
        gone.assign(triangles.size(), false);
        m_halves = halfEdges(triangles);
        std::vector<int> starts; // at the edges that have too many
        std::size_t crowded = 0;
        m_edges.resize(triangles.size());
        eachEdge(m_halves, [&](const HalfEdge* first, const HalfEdge* last) {
            for (const HalfEdge* half = first; half != last; ++half)
                m_edges[static_cast<std::size_t>(half->triangle)][half->side] = {first, last};
            if (last - first <= 2)
                return;
            ++crowded;
            for (const HalfEdge* half = first; half != last; ++half)
                starts.push_back(half->triangle);
        });
        if (crowded > triangles.size() / fewOf)
            return;
        for (const int start : starts)
            lookBehind(start);
    }

    std::vector<bool> gone;

private:
    struct Edge {
        const HalfEdge *first = nullptr, *last = nullptr;
    };

    /// How many of an edge are still there.
    std::ptrdiff_t left(const Edge& edge) const
    {
        return std::count_if(edge.first, edge.last, [&](const HalfEdge& half) { return !isGone(half.triangle); });
    }
    bool isGone(int triangle) const { return gone[static_cast<std::size_t>(triangle)]; }

    /// Takes away what hangs together with this triangle without crossing such an edge, if that is little, and
    /// leaves no hole.
    void lookBehind(int start)
    {
        if (isGone(start))
            return;
        std::vector<int> own{start};
        std::map<const HalfEdge*, std::ptrdiff_t> border; // crowded edges, and how many of it are its own
        for (std::size_t k = 0; k < own.size(); ++k)
            for (const Edge& edge : m_edges[static_cast<std::size_t>(own[k])]) {
                const std::ptrdiff_t there = left(edge);
                if (there == 1)
                    return; // at the border of the mesh
                if (there > 2) {
                    ++border[edge.first];
                    continue;
                }
                for (const HalfEdge* half = edge.first; half != edge.last; ++half)
                    if (!isGone(half->triangle) && std::ranges::find(own, half->triangle) == own.end())
                        own.push_back(half->triangle);
                if (own.size() > mostOfPocket)
                    return;
            }
        for (const auto& [first, count] : border) {
            const HalfEdge* last = first;
            while (last != m_halves.data() + m_halves.size() && last->sameEdge(*first))
                ++last;
            if (const std::ptrdiff_t rest = left({first, last}) - count; rest == 1)
                return;
        }
        for (const int triangle : own)
            gone[static_cast<std::size_t>(triangle)] = true;
    }

    std::vector<HalfEdge> m_halves;
    std::vector<std::array<Edge, 3>> m_edges; // of each triangle
};

} // namespace

Corners withoutLeavings(Corners corners)
{
    eraseFins(corners);
    erase(corners, Pockets(corners).gone);
    return corners;
}

} // namespace bolster
