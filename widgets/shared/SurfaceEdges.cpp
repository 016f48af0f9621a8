#include "SurfaceEdges.h"

#include <algorithm>

namespace bolster {

namespace {

using PatchRange = SurfaceTopology::PatchRange;

/// The vertex of the outline after `v`.
std::uint32_t after(const PatchRange& patch, std::uint32_t v)
{
    return v + 1 < patch.firstVertex + patch.outlineCount ? v + 1 : patch.firstVertex;
}

bool onOutline(const PatchRange& patch, std::uint32_t v)
{
    return v - patch.firstVertex < patch.outlineCount;
}

/// For each vertex of an outline whether the edge from it to the next one is sewn.
std::vector<char> sewnEdges(const SurfaceTopology& topology)
{
    std::vector<char> sewn(topology.vertexCount(), 0);
    const auto mark = [&](const SurfaceRun& side) {
        const auto patch = std::ranges::find_if(topology.patches, [&](const PatchRange& range) {
            return !side.empty() && onOutline(range, side.front());
        });
        if (patch == topology.patches.end())
            return;
        for (std::size_t i = 1; i < side.size(); ++i)
            sewn[after(*patch, side[i - 1]) == side[i] ? side[i - 1] : side[i]] = 1;
    };
    for (const SurfaceTopology::Chain& chain : topology.seams) {
        mark(chain.a);
        mark(chain.b);
    }
    return sewn;
}

} // namespace

std::vector<SurfaceEdge> edgesOf(const SurfaceTopology& topology, const PatchRange& patch)
{
    std::vector<SurfaceEdge> edges;
    edges.reserve((3 * std::size_t{patch.triangleCount} + patch.outlineCount) / 2);
    for (std::uint32_t t = patch.firstTriangle; t < patch.firstTriangle + patch.triangleCount; ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = topology.triangles[t][i], b = topology.triangles[t][(i + 1) % 3];
            const bool outline =
                onOutline(patch, a) && onOutline(patch, b) && (after(patch, a) == b || after(patch, b) == a);
            if (outline || a < b) // inside, the triangle at the other side walks it from b to a
                edges.push_back({a, b});
        }
    return edges;
}

SurfaceRun outlineOf(const PatchRange& patch)
{
    SurfaceRun run;
    for (std::uint32_t i = 0; i <= patch.outlineCount && patch.outlineCount > 0; ++i)
        run.push_back(patch.firstVertex + i % patch.outlineCount);
    return run;
}

std::vector<SurfaceRun> unsewnOutlines(const SurfaceTopology& topology)
{
    const std::vector<char> sewn = sewnEdges(topology);
    std::vector<SurfaceRun> runs;
    for (const PatchRange& patch : topology.patches) {
        const SurfaceRun outline = outlineOf(patch);
        const auto isSewn = [&](std::uint32_t v) { return sewn[v] != 0; };
        const auto firstSewn = std::ranges::find_if(outline, isSewn);
        if (firstSewn == outline.end()) {
            runs.push_back(outline);
            continue;
        }
        std::uint32_t at = *firstSewn; // from here a run cannot pass the start
        bool running = false;
        for (std::uint32_t i = 0; i < patch.outlineCount; ++i, at = after(patch, at)) {
            if (isSewn(at)) {
                running = false;
                continue;
            }
            if (!running)
                runs.push_back({at});
            running = true;
            runs.back().push_back(after(patch, at));
        }
    }
    return runs;
}

} // namespace bolster
