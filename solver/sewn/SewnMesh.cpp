#include "SewnMesh.h"

#include "Relief.h"
#include "UnionFind.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

namespace bolster {

namespace {

std::vector<int> firstVertices(const std::vector<PatchMesh>& meshes)
{
    std::vector<int> first{0};
    for (const PatchMesh& mesh : meshes)
        first.push_back(first.back() + static_cast<int>(mesh.points.size()));
    return first;
}

/// The k-th vertex of a line drawn in a patch.
int lineVertex(const SewnMesh& mesh, const SurfaceTopology& topology, int part, int line, std::size_t k)
{
    return static_cast<int>(topology.lines[mesh.firstLine[part] + line].vertices[k]);
}

/// Calls visit(vertex, target) for all that fixation seams and handles hold.
template <class Visit>
void eachHeld(const SewnMesh& mesh, const SurfaceTopology& topology, const OutlineSampling& sampling, Visit visit)
{
    for (const auto& chain : sampling.fixations)
        for (std::size_t k = 0; k < chain.samples.size(); ++k)
            visit(mesh.parts[chain.outline].firstVertex + chain.samples[k], chain.targets[k]);
    for (const auto& chain : sampling.handles)
        for (std::size_t k = 0; k < chain.targets.size(); ++k)
            visit(lineVertex(mesh, topology, chain.outline, chain.line, k), chain.targets[k]);
}

/// Numbers the unknowns: free ones first, in order of appearance, then the fixed ones.
void numberUnknowns(SewnMesh& mesh, SurfaceTopology& topology, const OutlineSampling& sampling)
{
    std::vector<char> isFixed(sampling.clusterCount, 0), isHeld(topology.pattern.size(), 0);
    eachHeld(mesh, topology, sampling, [&](int vertex, const Vec3&) { isHeld[vertex] = 1; });
    for (std::size_t p = 0; p < mesh.parts.size(); ++p)
        for (int i = 0; i < mesh.parts[p].boundaryCount; ++i)
            isFixed[sampling.outlines[p].cluster[i]] |= isHeld[mesh.parts[p].firstVertex + i];
    std::vector<std::uint32_t> ofCluster(sampling.clusterCount, UINT32_MAX);
    std::uint32_t next = 0;
    topology.unknown.resize(topology.pattern.size());
    for (bool fixedOnes : {false, true}) {
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            const SewnMesh::Part& part = mesh.parts[p];
            for (int i = 0; i < part.vertexCount; ++i) {
                const bool onOutline = i < part.boundaryCount;
                const int cluster = onOutline ? sampling.outlines[p].cluster[i] : -1;
                if ((onOutline ? isFixed[cluster] : isHeld[part.firstVertex + i]) != fixedOnes)
                    continue;
                std::uint32_t& number = onOutline ? ofCluster[cluster] : topology.unknown[part.firstVertex + i];
                if (!onOutline || number == UINT32_MAX)
                    number = next++;
                topology.unknown[part.firstVertex + i] = number;
            }
        }
        if (!fixedOnes)
            mesh.freeCount = static_cast<int>(next);
    }
    topology.unknownCount = next;
}

/// A corner whose two sides are sewn to each other merges two corners of the triangle that fills it. Its
/// quadrilateral gets the other diagonal, so that no triangle collapses.
void openSewnCorners(SurfaceTopology& topology)
{
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    const auto turned = [](const auto& triangle, std::size_t k) {
        return std::array{triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
    };
    std::map<Edge, std::size_t> collapsed;
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto [a, b, c] = turned(topology.triangles[t], k); topology.unknown[a] == topology.unknown[b])
                collapsed[{a, b}] = t;
    if (collapsed.empty())
        return;
    const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return cross(topology.pattern[b] - topology.pattern[a], topology.pattern[c] - topology.pattern[a]);
    };
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [b, a, far] = turned(topology.triangles[t], k);
            const auto found = collapsed.find({a, b});
            if (found == collapsed.end())
                continue;
            auto& corner = topology.triangles[found->second];
            const std::uint32_t tip = corner[0] + corner[1] + corner[2] - a - b;
            const double whole = area(a, b, tip) + area(b, a, far);
            constexpr double least = 0.05; // of the quadrilateral: a sliver would be no better
            if (area(a, far, tip) / whole < least || area(far, b, tip) / whole < least)
                continue;
            corner = {a, far, tip};
            topology.triangles[t] = {far, b, tip};
            collapsed.erase(found);
            break;
        }
}

/// Which triangles each vertex has.
void collectCorners(SewnMesh& mesh, const SurfaceTopology& topology)
{
    mesh.cornerStart.assign(topology.pattern.size() + 1, 0);
    for (const auto& triangle : topology.triangles)
        for (const std::uint32_t vertex : triangle)
            ++mesh.cornerStart[vertex + 1];
    std::partial_sum(mesh.cornerStart.begin(), mesh.cornerStart.end(), mesh.cornerStart.begin());
    std::vector<int> next(mesh.cornerStart.begin(), mesh.cornerStart.end() - 1);
    mesh.corners.resize(3 * topology.triangles.size());
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t)
        for (const std::uint32_t vertex : topology.triangles[t])
            mesh.corners[next[vertex]++] = t;
}

/// The ring of a vertex, and its area: cotangent weights, clamped at 0, and a third of each triangle's area.
class Ring {
public:
    void measure(SewnMesh& mesh, const SurfaceTopology& topology, int vertex)
    {
        m_halves.clear();
        double& area = mesh.area[vertex] = 0;
        for (int c = mesh.cornerStart[vertex]; c < mesh.cornerStart[vertex + 1]; ++c) {
            const auto& triangle = topology.triangles[mesh.corners[c]];
            for (int k = 0; k < 3; ++k) {
                const int a = static_cast<int>(triangle[k]), b = static_cast<int>(triangle[(k + 1) % 3]);
                if (a != vertex && b != vertex)
                    continue;
                const Vec2& apex = topology.pattern[triangle[(k + 2) % 3]];
                const Vec2 u = topology.pattern[a] - apex, v = topology.pattern[b] - apex;
                const double doubleArea = std::abs(cross(u, v));
                m_halves.emplace_back(a == vertex ? b : a, 0.5 * u.dot(v) / doubleArea);
                if (a == vertex)
                    area += doubleArea / 6;
            }
        }
        join();
    }
    const std::vector<SewnMesh::RingEdge>& edges() const { return m_edges; }

private:
    /// Half edges to the same neighbour are one edge.
    void join()
    {
        std::ranges::sort(m_halves, {}, &Half::first);
        m_edges.clear();
        for (std::size_t k = 0; k < m_halves.size();) {
            auto [vertex, weight] = m_halves[k];
            for (++k; k < m_halves.size() && m_halves[k].first == vertex; ++k)
                weight += m_halves[k].second;
            m_edges.push_back({vertex, static_cast<float>(std::max(0.0, weight))});
        }
    }

    using Half = std::pair<int, double>; // the neighbour, and the weight that one triangle gives
    std::vector<Half> m_halves;
    std::vector<SewnMesh::RingEdge> m_edges;
};

void collectRings(SewnMesh& mesh, const SurfaceTopology& topology, WorkerPool& pool)
{
    collectCorners(mesh, topology);
    const int vertices = static_cast<int>(topology.pattern.size());
    mesh.area.resize(topology.pattern.size());
    mesh.ringStart.assign(topology.pattern.size() + 1, 0);
    std::vector<std::vector<SewnMesh::RingEdge>> rings(WorkerPool::chunkCount(vertices)); // of a chunk's vertices
    pool.forChunks(vertices, [&](int chunk, int begin, int end) {
        Ring ring;
        constexpr int mostNeighbours = 7; // but for few
        rings[chunk].reserve(static_cast<std::size_t>(mostNeighbours * (end - begin)));
        for (int v = begin; v < end; ++v) {
            ring.measure(mesh, topology, v);
            mesh.ringStart[v + 1] = static_cast<int>(ring.edges().size());
            rings[chunk].insert(rings[chunk].end(), ring.edges().begin(), ring.edges().end());
        }
    });
    std::partial_sum(mesh.ringStart.begin(), mesh.ringStart.end(), mesh.ringStart.begin());
    mesh.ring.resize(static_cast<std::size_t>(mesh.ringStart.back()));
    pool.forChunks(vertices, [&](int chunk, int begin, int) {
        std::ranges::copy(rings[chunk], mesh.ring.begin() + mesh.ringStart[begin]);
    });
}

/// The same rings on another rest shape.
void measureRings(SewnMesh& mesh, const SurfaceTopology& topology, WorkerPool& pool)
{
    pool.forChunks(mesh.vertexCount(), [&](int, int begin, int end) {
        Ring ring;
        for (int v = begin; v < end; ++v) {
            ring.measure(mesh, topology, v);
            std::ranges::copy(ring.edges(), mesh.ring.begin() + mesh.ringStart[v]);
        }
    });
}

void measureParts(SewnMesh& mesh)
{
    for (SewnMesh::Part& part : mesh.parts) {
        part.area = 0;
        double length = 0;
        int count = 0;
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            part.area += mesh.area[v];
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k, ++count)
                length += mesh.along(v, mesh.ring[k]).norm();
        }
        part.meanEdge = count > 0 ? length / count : 0;
    }
}

void findComponents(SewnMesh& mesh, const OutlineSampling& sampling)
{
    UnionFind sewn(static_cast<int>(mesh.parts.size()));
    for (const auto& seam : sampling.seams)
        sewn.join(seam.outlineA, seam.outlineB);
    int count = 0;
    const std::vector<int> label = sewn.labels(&count);
    mesh.diameter.assign(count, 0);
    mesh.anchored.assign(count, 0);
    for (std::size_t p = 0; p < mesh.parts.size(); ++p)
        mesh.parts[p].component = label[p];
    for (const auto& chain : sampling.fixations)
        mesh.anchored[label[chain.outline]] = 1;
    for (const auto& chain : sampling.handles)
        mesh.anchored[label[chain.outline]] = 1;
}

void measureComponents(SewnMesh& mesh)
{
    std::ranges::fill(mesh.diameter, 0);
    for (const SewnMesh::Part& part : mesh.parts)
        mesh.diameter[part.component] += part.area;
    for (double& d : mesh.diameter)
        d = std::sqrt(2 * d);
}

void collectChains(SurfaceTopology& topology, const OutlineSampling& sampling, const std::vector<int>& first)
{
    auto vertices = [&](int outline, const std::vector<int>& samples) {
        std::vector<std::uint32_t> result;
        for (int sample : samples)
            result.push_back(static_cast<std::uint32_t>(first[outline] + sample));
        return result;
    };
    for (const auto& seam : sampling.seams)
        topology.seams.push_back({seam.seam, vertices(seam.outlineA, seam.a), vertices(seam.outlineB, seam.b)});
    for (const auto& chain : sampling.fixations)
        topology.fixations.push_back({chain.fixation, vertices(chain.outline, chain.samples), {}});
    std::set<ElementId> held;
    for (const auto& chain : sampling.fixations)
        held.insert(chain.fixation);
    for (const auto& chain : sampling.orientations)
        if (chain.line < 0 && !held.contains(chain.owner))
            topology.fixations.push_back({chain.owner, vertices(chain.outline, chain.samples), {}});
}

void collectLines(SewnMesh& mesh, SurfaceTopology& topology, const OutlineSampling& sampling,
                  const std::vector<PatchMesh>& meshes)
{
    for (std::size_t p = 0; p < meshes.size(); ++p) {
        mesh.firstLine.push_back(static_cast<int>(topology.lines.size()));
        for (std::size_t k = 0; k < meshes[p].lines.size(); ++k) {
            const OutlineSampling::Line& line = sampling.outlines[p].lines[k];
            topology.lines.push_back({line.element, {}, line.across});
            for (int vertex : meshes[p].lines[k])
                topology.lines.back().vertices.push_back(
                    static_cast<std::uint32_t>(mesh.parts[p].firstVertex + vertex));
        }
    }
}

std::uint64_t nextSerial()
{
    static std::atomic<std::uint64_t> serial{0};
    return ++serial;
}

} // namespace

double SewnMesh::largestDiameter() const
{
    return diameter.empty() ? 1 : *std::max_element(diameter.begin(), diameter.end());
}

double SewnMesh::Part::bendingSquared() const
{
    constexpr double meshBending = 0.12; // lambda_eff^2 = lambda^2 + meshBending h^2
    return std::max(0.0, material.bendingLength * material.bendingLength - meshBending * meanEdge * meanEdge);
}

SewnMesh buildSewnMesh(const Design& design, const OutlineSampling& sampling, const std::vector<PatchMesh>& meshes,
                       WorkerPool& pool)
{
    SewnMesh mesh;
    auto topology = std::make_shared<SurfaceTopology>();
    topology->serial = nextSerial();
    const std::vector<int> first = firstVertices(meshes);
    for (std::size_t p = 0; p < meshes.size(); ++p) {
        const ElementId id = sampling.outlines[p].patch;
        const Patch& patch = *design.find<Patch>(id);
        SewnMesh::Part part;
        part.patch = id;
        part.firstVertex = first[p];
        part.vertexCount = static_cast<int>(meshes[p].points.size());
        part.boundaryCount = meshes[p].boundaryCount;
        part.outward = patch.wrongSideOut ? -1 : 1;
        mesh.parts.push_back(part);
        topology->patches.push_back({id, patch.fabric, static_cast<std::uint32_t>(first[p]),
                                     static_cast<std::uint32_t>(part.vertexCount),
                                     static_cast<std::uint32_t>(topology->triangles.size()),
                                     static_cast<std::uint32_t>(meshes[p].triangles.size()),
                                     static_cast<std::uint32_t>(part.boundaryCount)});
        topology->pattern.insert(topology->pattern.end(), meshes[p].points.begin(), meshes[p].points.end());
        for (auto [a, b, c] : meshes[p].triangles) {
            if (patch.wrongSideOut)
                std::swap(b, c);
            topology->triangles.push_back({static_cast<std::uint32_t>(first[p] + a),
                                           static_cast<std::uint32_t>(first[p] + b),
                                           static_cast<std::uint32_t>(first[p] + c)});
        }
    }
    collectLines(mesh, *topology, sampling, meshes);
    numberUnknowns(mesh, *topology, sampling);
    openSewnCorners(*topology);
    collectRings(mesh, *topology, pool);
    findComponents(mesh, sampling);
    collectChains(*topology, sampling, first);
    mesh.topology = std::move(topology);
    measureParts(mesh);
    measureComponents(mesh);
    updateMaterials(mesh, design);
    updateTargets(mesh, sampling);
    mesh.reliefs = makeReliefs(mesh, sampling, design);
    return mesh;
}

void reshape(SewnMesh& mesh, std::vector<Vec2> pattern, WorkerPool& pool)
{
    auto topology = std::make_shared<SurfaceTopology>(*mesh.topology);
    topology->pattern = std::move(pattern);
    measureRings(mesh, *topology, pool);
    mesh.topology = std::move(topology);
    measureParts(mesh);
    measureComponents(mesh);
}

Vec2 chainTangent(const std::vector<Vec2>& rest, const std::vector<std::uint32_t>& chain, std::size_t k)
{
    const std::size_t before = k > 0 ? k - 1 : 0, after = std::min(k + 1, chain.size() - 1);
    return (rest[chain[after]] - rest[chain[before]]).normalized();
}

namespace {

/// A sharp seam folds the cover in its middle, a welt along its sides.
bool isCrease(const Design& design, const SurfaceTopology::Line& line)
{
    const FancySeam* seam = design.find<FancySeam>(line.element);
    return seam && ((seam->profile == Profile::Sharp && line.across == 0) ||
                    (seam->profile == Profile::Welt && std::abs(line.across) == 1));
}

} // namespace

void updateCreases(SewnMesh& mesh, const Design& design)
{
    auto topology = std::make_shared<SurfaceTopology>(*mesh.topology);
    bool changed = false;
    for (SurfaceTopology::Chain& chain : topology->seams) {
        const Continuity continuity = design.find<Seam>(chain.seam)->continuity;
        changed |= std::exchange(chain.continuity, continuity) != continuity;
    }
    for (SurfaceTopology::Line& line : topology->lines) {
        const bool crease = isCrease(design, line);
        changed |= std::exchange(line.crease, crease) != crease;
    }
    if (changed)
        mesh.topology = std::move(topology);
}

void updateMaterials(SewnMesh& mesh, const Design& design)
{
    updateCreases(mesh, design);
    mesh.continuity.clear();
    for (const SurfaceTopology::Chain& chain : mesh.topology->seams)
        mesh.continuity.push_back(design.find<Seam>(chain.seam)->continuity);
    for (SewnMesh::Part& part : mesh.parts) {
        const Patch& patch = *design.find<Patch>(part.patch);
        const Fabric& fabric = *design.find<Fabric>(patch.fabric);
        part.material = {fabric.poisson, fabric.stiffness, fabric.bendingLength, patch.pressure};
    }
}

void updateTargets(SewnMesh& mesh, const OutlineSampling& sampling)
{
    mesh.targets.resize(static_cast<std::size_t>(mesh.unknownCount() - mesh.freeCount));
    const SurfaceTopology& topology = *mesh.topology;
    eachHeld(mesh, topology, sampling, [&](int vertex, const Vec3& target) {
        mesh.targets[topology.unknown[vertex] - static_cast<std::uint32_t>(mesh.freeCount)] = target;
    });
    mesh.oriented.clear();
    for (const auto& chain : sampling.orientations) {
        const int first = mesh.parts[chain.outline].firstVertex;
        for (std::size_t k = 0; k < chain.directions.size(); ++k) {
            const int vertex = chain.line < 0 ? first + chain.samples[k]
                                              : lineVertex(mesh, topology, chain.outline, chain.line, k);
            if (chain.weight > 0 && chain.directions[k] != Vec3::Zero())
                mesh.oriented.push_back({vertex, chain.outline, chain.directions[k], chain.kind, chain.weight});
        }
    }
}

} // namespace bolster
