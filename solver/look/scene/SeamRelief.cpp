#include "SeamRelief.h"

#include "Design.h"
#include "Shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

using Vec2f = Eigen::Vector2f;
using Vertices = std::vector<std::uint32_t>;

constexpr int tracks = 3;
constexpr float cornerTurn = 0.5F; ///< radians: where a border turns by more, another run begins
constexpr std::size_t partLength = 16;

/// A stretch of a patch's border that is sewn in one way and has no corner.
struct Run {
    Vertices vertices;
    Vec2f shape = Vec2f::Zero();
    int track = 0;
};

struct Edge {
    std::uint32_t a = 0, b = 0;
    Vec2f shape = Vec2f::Zero();
};

/// What the two kinds of covers have in common.
struct Cloth {
    std::uint64_t serial = 0;
    std::vector<Vec2f> pattern;
    std::vector<std::uint32_t> patch;     ///< of each vertex
    std::vector<std::vector<Edge>> edges; ///< sewn ones, of each patch
    float longestEdge = 0;                ///< of the solver's triangles, mm
};

/// Joins sewn edges to runs.
class Joiner {
public:
    Joiner(const std::vector<Edge>& edges, const std::vector<Vec2f>& pattern)
        : m_edges(edges)
        , m_pattern(pattern)
        , m_joined(edges.size(), 0)
    {
        for (std::size_t e = 0; e < edges.size(); ++e) {
            m_at.emplace_back(edges[e].a, e);
            m_at.emplace_back(edges[e].b, e);
        }
        std::ranges::sort(m_at);
    }

    std::vector<Run> runs()
    {
        for (std::size_t e = 0; e < m_edges.size(); ++e)
            for (const std::uint32_t end : {m_edges[e].a, m_edges[e].b})
                if (!m_joined[e] && !following(e, end))
                    walk(e, end);
        for (std::size_t e = 0; e < m_edges.size(); ++e) // what is left runs round
            if (!m_joined[e])
                walk(e, m_edges[e].a);
        return std::move(m_runs);
    }

private:
    std::uint32_t otherEnd(std::size_t edge, std::uint32_t vertex) const
    {
        return m_edges[edge].a == vertex ? m_edges[edge].b : m_edges[edge].a;
    }

    std::optional<std::size_t> following(std::size_t edge, std::uint32_t vertex) const
    {
        const auto here = std::lower_bound(m_at.begin(), m_at.end(), std::pair(vertex, std::size_t{0}));
        const auto end = std::lower_bound(here, m_at.end(), std::pair(vertex + 1, std::size_t{0}));
        if (end - here != 2)
            return std::nullopt;
        const std::size_t next = here[0].second == edge ? here[1].second : here[0].second;
        const Vec2f in = m_pattern[vertex] - m_pattern[otherEnd(edge, vertex)];
        const Vec2f out = m_pattern[otherEnd(next, vertex)] - m_pattern[vertex];
        const float turn = std::atan2(std::abs(in.x() * out.y() - in.y() * out.x()), in.dot(out));
        return turn < cornerTurn && m_edges[next].shape == m_edges[edge].shape ? std::optional(next) : std::nullopt;
    }

    void walk(std::size_t edge, std::uint32_t from)
    {
        Run& run = m_runs.emplace_back(Run{{from}, m_edges[edge].shape});
        for (std::optional<std::size_t> next = edge; next && !m_joined[*next]; next = following(*next, from)) {
            m_joined[*next] = 1;
            from = otherEnd(*next, from);
            run.vertices.push_back(from);
        }
    }

    const std::vector<Edge>& m_edges;
    const std::vector<Vec2f>& m_pattern;
    std::vector<char> m_joined;
    std::vector<std::pair<std::uint32_t, std::size_t>> m_at; ///< edges at a vertex
    std::vector<Run> m_runs;
};

float between(const Run& a, const Run& b, const std::vector<Vec2f>& pattern)
{
    float least = std::numeric_limits<float>::max();
    const auto look = [&](std::uint32_t v, std::uint32_t w) {
        least = std::min(least, (pattern[v] - pattern[w]).squaredNorm());
    };
    for (const std::uint32_t end : {a.vertices.front(), a.vertices.back()})
        for (const std::uint32_t other : {b.vertices.front(), b.vertices.back()})
            look(end, other);
    for (std::size_t i = 0; i < a.vertices.size(); i += 3)
        for (std::size_t k = 0; k < b.vertices.size(); k += 3)
            look(a.vertices[i], b.vertices[k]);
    return least;
}

/// Each run goes where the nearest other one is farthest away.
void spread(std::vector<Run>& runs, const std::vector<Vec2f>& pattern)
{
    std::ranges::stable_sort(runs, std::greater<>(), [](const Run& run) { return run.vertices.size(); });
    for (std::size_t r = 0; r < runs.size(); ++r) {
        std::array<float, tracks> room;
        room.fill(std::numeric_limits<float>::max());
        for (std::size_t other = 0; other < r; ++other) {
            float& least = room[static_cast<std::size_t>(runs[other].track)];
            least = std::min(least, between(runs[r], runs[other], pattern));
        }
        runs[r].track = static_cast<int>(std::ranges::max_element(room) - room.begin());
    }
}

/// Some edges of a run, and a box around them: most vertices are far from most edges.
struct Part {
    const Run* run = nullptr;
    std::size_t first = 0, last = 0;
    Eigen::AlignedBox2f box;
};

std::vector<Part> partsOf(const std::vector<Run>& runs, const std::vector<Vec2f>& pattern)
{
    std::vector<Part> parts;
    for (const Run& run : runs)
        for (std::size_t first = 0; first + 1 < run.vertices.size(); first += partLength) {
            Part part{&run, first, std::min(first + partLength, run.vertices.size() - 1), {}};
            for (std::size_t i = part.first; i <= part.last; ++i)
                part.box.extend(pattern[run.vertices[i]]);
            parts.push_back(part);
        }
    return parts;
}

float squaredDistance(const Vec2f& p, const Vec2f& a, const Vec2f& b)
{
    const Vec2f along = b - a;
    const float length2 = along.squaredNorm();
    const float t = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.F, 1.F) : 0.F;
    return (a + t * along - p).squaredNorm();
}

/// `reach`: distances beyond do not matter.
void measure(std::uint32_t vertex, const std::vector<Part>& parts, const std::vector<Vec2f>& pattern, float reach,
             SeamRelief& relief)
{
    const Vec2f& p = pattern[vertex];
    Eigen::Vector3f best = Eigen::Vector3f::Constant(reach * reach);
    float nearest = std::numeric_limits<float>::max();
    for (const Part& part : parts) {
        float& least = best[part.run->track];
        if (part.box.squaredExteriorDistance(p) >= least)
            continue;
        for (std::size_t i = part.first; i < part.last; ++i)
            least = std::min(
                least, squaredDistance(p, pattern[part.run->vertices[i]], pattern[part.run->vertices[i + 1]]));
        if (least < nearest && least < reach * reach) {
            nearest = least;
            relief.shapes[vertex] = part.run->shape;
        }
    }
    relief.distances[vertex] = best.cwiseSqrt();
}

SeamReliefPtr measured(const Cloth& cloth)
{
    auto relief = std::make_shared<SeamRelief>();
    relief->topology = cloth.serial;
    float widest = 0;
    std::vector<std::vector<Run>> runs;
    for (const std::vector<Edge>& edges : cloth.edges) {
        runs.push_back(Joiner(edges, cloth.pattern).runs());
        spread(runs.back(), cloth.pattern);
        for (const Run& run : runs.back())
            widest = std::max(widest, run.shape.x());
    }
    const float reach = std::max(shading::valleyReach, shading::bulgeWidth(widest, 0)) + 1.5F * cloth.longestEdge;
    relief->distances.assign(cloth.pattern.size(), Eigen::Vector3f::Constant(reach));
    relief->shapes.assign(cloth.pattern.size(), Vec2f::Zero());
    std::vector<std::vector<Part>> parts;
    for (const std::vector<Run>& ofPatch : runs)
        parts.push_back(partsOf(ofPatch, cloth.pattern));
    for (std::uint32_t v = 0; v < cloth.pattern.size(); ++v)
        if (cloth.patch[v] < parts.size() && !parts[cloth.patch[v]].empty())
            measure(v, parts[cloth.patch[v]], cloth.pattern, reach, *relief);
    return relief;
}

Vec2f shapeOf(const Design& design, ElementId seam)
{
    const auto* found = design.find<Seam>(seam);
    const SeamTrim trim = found ? found->trim : SeamTrim{};
    return {static_cast<float>(trim.allowance), trim.valley ? 1.F : 0.F};
}

/// `along`: the vertices of a run of the solver's vertices.
template <class Along>
void takeSeams(const Design& design, const SurfaceTopology& topology, const Along& along, Cloth& cloth)
{
    cloth.serial = topology.serial;
    cloth.edges.resize(topology.patches.size());
    for (const SurfaceTopology::Chain& chain : topology.seams) {
        const Vec2f shape = shapeOf(design, chain.seam);
        for (const Vertices* side : {&chain.a, &chain.b}) {
            const Vertices run = along(*side);
            for (std::size_t i = 1; i < run.size(); ++i)
                if (run[i] != run[i - 1] && cloth.patch[run[i]] < cloth.edges.size())
                    cloth.edges[cloth.patch[run[i]]].push_back({run[i - 1], run[i], shape});
        }
    }
    for (const auto& t : topology.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            cloth.longestEdge =
                std::max(cloth.longestEdge,
                         static_cast<float>((topology.pattern[t[(i + 1) % 3]] - topology.pattern[t[i]]).norm()));
}

std::vector<std::uint32_t> patchesOf(const SurfaceTopology& topology)
{
    std::vector<std::uint32_t> patch(topology.pattern.size(), std::numeric_limits<std::uint32_t>::max());
    for (std::uint32_t p = 0; p < topology.patches.size(); ++p)
        std::fill_n(patch.begin() + topology.patches[p].firstVertex, topology.patches[p].vertexCount, p);
    return patch;
}

} // namespace

SeamReliefPtr seamRelief(const Design& design, const SurfaceTopology& topology)
{
    Cloth cloth;
    for (const Vec2& p : topology.pattern)
        cloth.pattern.push_back(p.cast<float>());
    cloth.patch = patchesOf(topology);
    takeSeams(
        design, topology, [](const Vertices& run) { return run; }, cloth);
    return measured(cloth);
}

SeamReliefPtr seamRelief(const Design& design, const CoverTopology& topology)
{
    Cloth cloth;
    cloth.pattern = topology.pattern;
    const std::vector<std::uint32_t> ofCoarse = patchesOf(*topology.coarse);
    for (const CoverTopology::Parents& parents : topology.parents)
        cloth.patch.push_back(ofCoarse[parents.vertex[0]]);
    takeSeams(
        design, *topology.coarse, [&](const Vertices& run) { return topology.along(run); }, cloth);
    return measured(cloth);
}

SeamProfile SeamProfile::at(const Eigen::Vector3f& distances, const Eigen::Vector2f& shape,
                            const Eigen::Vector3f& pixel)
{
    SeamProfile profile;
    Eigen::Index nearest = 0;
    const float distance = distances.minCoeff(&nearest);
    const shading::Valley valley = shading::valleyAt(distance, shape.y(), pixel[nearest]);
    profile.dark = valley.dark;
    profile.height = -shading::valleyDepth * valley.dark;
    profile.slope[nearest] = valley.rise;
    if (!(shape.x() > 0))
        return profile;
    const float width = shading::bulgeWidth(shape.x(), pixel[nearest]);
    const float top = shading::bulgeTop(shape.x(), width);
    std::array<shading::Flat, tracks> flat{};
    std::ranges::transform(distances, flat.begin(), [&](float d) { return shading::flatAt(d, width); });
    profile.height += top * (1 - flat[0].share * flat[1].share * flat[2].share);
    for (std::size_t i = 0; i < tracks; ++i)
        profile.slope[static_cast<Eigen::Index>(i)] -=
            top * flat[i].rise * flat[(i + 1) % tracks].share * flat[(i + 2) % tracks].share;
    return profile;
}

} // namespace bolster
