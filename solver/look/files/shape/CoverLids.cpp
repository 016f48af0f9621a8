#include "CoverLids.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace bolster {

namespace {

/// From a sewn vertex to those that a lid goes on to.
using Rims = std::multimap<std::uint32_t, std::uint32_t>;

std::uint32_t sewnVertex(const SurfaceTopology& topology, std::uint32_t vertex)
{
    return topology.unknown.size() == topology.pattern.size() ? topology.unknown[vertex] : vertex;
}

/// The other way round than the triangles of the cover have them: as many as it takes to have each edge as often in
/// one direction as in the other.
Rims rimsOf(const SurfaceTopology& topology)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> surplus;
    for (const auto& t : topology.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = sewnVertex(topology, t[i]), b = sewnVertex(topology, t[(i + 1) % 3]);
            if (a != b)
                surplus[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    Rims rims;
    for (const auto& [edge, count] : surplus)
        for (int i = 0; i < std::abs(count); ++i)
            count > 0 ? rims.emplace(edge.second, edge.first) : rims.emplace(edge.first, edge.second);
    return rims;
}

/// Takes a way along rims until it is closed.
std::vector<std::uint32_t> takeLoop(Rims& rims)
{
    std::vector<std::uint32_t> loop;
    std::uint32_t at = rims.begin()->first;
    for (auto next = rims.begin(); next != rims.end(); next = rims.find(at)) {
        loop.push_back(at);
        at = next->second;
        rims.erase(next);
        if (at == loop.front())
            break;
    }
    return loop;
}

} // namespace

std::vector<std::array<Vec3, 3>> coverLids(const SurfaceMesh& cover)
{
    const SurfaceTopology& topology = *cover.topology;
    std::map<std::uint32_t, Vec3> places;
    for (std::uint32_t v = 0; v < topology.vertexCount(); ++v)
        places[sewnVertex(topology, v)] = cover.positions[v];
    std::vector<std::array<Vec3, 3>> lids;
    for (Rims rims = rimsOf(topology); !rims.empty();) {
        const std::vector<std::uint32_t> loop = takeLoop(rims);
        Vec3 middle = Vec3::Zero();
        for (const std::uint32_t v : loop)
            middle += places[v] / static_cast<double>(loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i)
            lids.push_back({places[loop[i]], places[loop[(i + 1) % loop.size()]], middle});
    }
    return lids;
}

} // namespace bolster
