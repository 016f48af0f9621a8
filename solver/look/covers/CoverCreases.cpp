#include "CoverCreases.h"

#include "HalfEdges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bolster {

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Borders and seams that turn by more than this have a corner there, radians.
constexpr double cornerTurn = 0.8;

Edge edgeOf(std::uint32_t a, std::uint32_t b)
{
    return a < b ? Edge{a, b} : Edge{b, a};
}

/// The creases and borders at each vertex, counted.
std::vector<int> sharpEdges(const LoopMesh& mesh)
{
    std::vector<Edge> sharp = mesh.creases;
    eachEdge(halfEdges(mesh.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2)
            sharp.push_back(
                edgeOf(static_cast<std::uint32_t>(first->low), static_cast<std::uint32_t>(first->high)));
    });
    std::ranges::sort(sharp);
    sharp.erase(std::unique(sharp.begin(), sharp.end()), sharp.end());
    std::vector<int> count(mesh.vertexCount, 0);
    for (const Edge& e : sharp) {
        ++count[e[0]];
        ++count[e[1]];
    }
    return count;
}

/// The angle of all triangles at each vertex, in the pattern.
std::vector<double> patternAngles(const SurfaceTopology& topology)
{
    std::vector<double> angle(topology.pattern.size(), 0);
    for (const auto& t : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = topology.pattern[t[(k + 1) % 3]] - topology.pattern[t[k]];
            const Vec2 b = topology.pattern[t[(k + 2) % 3]] - topology.pattern[t[k]];
            angle[t[k]] += std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
        }
    return angle;
}

/// Vertices that are one piece of cloth to the eye: patches that meet in a smooth seam.
class Sectors {
public:
    explicit Sectors(const SurfaceTopology& topology)
        : m_parent(topology.pattern.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), 0U);
        for (const SurfaceTopology::Chain& chain : topology.seams)
            if (chain.continuity != Continuity::C0)
                for (std::size_t k = 0; k < std::min(chain.a.size(), chain.b.size()); ++k)
                    m_parent[find(chain.a[k])] = find(chain.b[k]);
    }
    std::uint32_t find(std::uint32_t v)
    {
        while (m_parent[v] != v)
            v = m_parent[v] = m_parent[m_parent[v]];
        return v;
    }

private:
    std::vector<std::uint32_t> m_parent;
};

bool turns(double angle)
{
    return std::abs(angle - std::numbers::pi) > cornerTurn;
}

void addCreases(CoverCreases& creases, const SurfaceTopology& topology)
{
    const auto add = [&](const std::vector<std::uint32_t>& run, bool inside) {
        for (std::size_t k = 1; k < run.size(); ++k) {
            const Edge merged = edgeOf(creases.unknown[run[k - 1]], creases.unknown[run[k]]);
            if (merged[0] != merged[1])
                creases.merged.creases.push_back(merged);
            if (inside && run[k - 1] != run[k])
                creases.patches.creases.push_back(edgeOf(run[k - 1], run[k]));
        }
    };
    for (const SurfaceTopology::Chain& chain : topology.seams)
        if (chain.continuity == Continuity::C0)
            add(chain.a, false);
    for (const SurfaceTopology::Line& line : topology.lines)
        if (line.crease)
            add(line.vertices, true);
}

void findCorners(CoverCreases& creases, const SurfaceTopology& topology)
{
    const std::vector<int> sharp = sharpEdges(creases.merged), own = sharpEdges(creases.patches);
    const std::vector<double> angle = patternAngles(topology);
    Sectors sectors(topology);
    std::vector<double> sectorAngle(angle.size(), 0);
    for (std::uint32_t v = 0; v < angle.size(); ++v)
        sectorAngle[sectors.find(v)] += angle[v];

    std::vector<char> corner(creases.merged.vertexCount, 0);
    for (std::uint32_t v = 0; v < angle.size(); ++v)
        if (own[v] > 0) { // else it is inside a patch
            const std::uint32_t u = creases.unknown[v];
            corner[u] |= sharp[u] > 2 || (sharp[u] == 2 && turns(sectorAngle[sectors.find(v)]));
        }
    for (std::uint32_t u = 0; u < corner.size(); ++u)
        if (corner[u])
            creases.merged.corners.push_back(u);
    for (std::uint32_t v = 0; v < angle.size(); ++v) {
        const std::uint32_t u = creases.unknown[v];
        if (own[v] > 0 && (corner[u] || (sharp[u] < 2 && turns(angle[v]))))
            creases.patches.corners.push_back(v);
    }
}

} // namespace

CoverCreases CoverCreases::of(const SurfaceTopology& topology)
{
    CoverCreases creases;
    creases.unknown = topology.unknown;
    creases.merged.vertexCount = topology.unknownCount;
    if (creases.unknown.size() != topology.pattern.size()) {
        creases.unknown.resize(topology.pattern.size());
        std::iota(creases.unknown.begin(), creases.unknown.end(), 0U);
        creases.merged.vertexCount = topology.vertexCount();
    }
    creases.patches.vertexCount = topology.vertexCount();
    creases.patches.triangles = topology.triangles;
    for (const auto& [a, b, c] : topology.triangles)
        creases.merged.triangles.push_back({creases.unknown[a], creases.unknown[b], creases.unknown[c]});
    addCreases(creases, topology);
    findCorners(creases, topology);
    return creases;
}

} // namespace bolster
