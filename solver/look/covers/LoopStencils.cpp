#include "LoopStencils.h"

#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <stdexcept>

namespace bolster {

namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using Parents = CoverTopology::Parents;
using Refiner = std::unique_ptr<Far::TopologyRefiner>;

Refiner makeRefiner(const LoopMesh& mesh, int levels)
{
    const std::vector<int> sizes(mesh.triangles.size(), 3);
    std::vector<int> corners, creases;
    for (const auto& triangle : mesh.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    for (const auto& edge : mesh.creases)
        creases.insert(creases.end(), edge.begin(), edge.end());
    const std::vector<int> sharp(mesh.corners.begin(), mesh.corners.end());
    const std::vector<float> edgeWeights(mesh.creases.size(), Sdc::Crease::SHARPNESS_INFINITE);
    const std::vector<float> vertexWeights(sharp.size(), Sdc::Crease::SHARPNESS_INFINITE);

    Far::TopologyDescriptor of;
    of.numVertices = static_cast<int>(mesh.vertexCount);
    of.numFaces = static_cast<int>(sizes.size());
    of.numVertsPerFace = sizes.data();
    of.vertIndicesPerFace = corners.data();
    of.numCreases = static_cast<int>(mesh.creases.size());
    of.creaseVertexIndexPairs = creases.data();
    of.creaseWeights = edgeWeights.data();
    of.numCorners = static_cast<int>(sharp.size());
    of.cornerVertexIndices = sharp.data();
    of.cornerWeights = vertexWeights.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    Refiner refiner(Factory::Create(of, Factory::Options(Sdc::SCHEME_LOOP, rules)));
    if (!refiner)
        throw std::runtime_error("OpenSubdiv takes no such mesh");
    Far::TopologyRefiner::UniformOptions options(levels);
    options.fullTopologyInLastLevel = false;
    refiner->RefineUniform(options);
    return refiner;
}

/// Half of each of both.
Parents parentsBetween(const Parents& a, const Parents& b)
{
    Parents result{{a.vertex[0], 0, 0}, {0, 0, 0}};
    std::size_t used = 0;
    for (const Parents* side : {&a, &b})
        for (std::size_t i = 0; i < 3; ++i) {
            if (side->share[i] <= 0)
                continue;
            const auto known = std::find(
                result.vertex.begin(), result.vertex.begin() + static_cast<std::ptrdiff_t>(used), side->vertex[i]);
            const auto at = static_cast<std::size_t>(known - result.vertex.begin());
            used = std::max(used, at + 1);
            result.vertex[at] = side->vertex[i];
            result.share[at] += 0.5F * side->share[i];
        }
    return result;
}

std::vector<Parents> findParents(const Far::TopologyRefiner& refiner)
{
    std::vector<Parents> parents(static_cast<std::size_t>(refiner.GetLevel(0).GetNumVertices()));
    for (std::uint32_t v = 0; v < parents.size(); ++v)
        parents[v].vertex = {v, v, v};
    for (int l = 0; l < refiner.GetMaxLevel(); ++l) {
        const Far::TopologyLevel& level = refiner.GetLevel(l);
        std::vector<Parents> children(static_cast<std::size_t>(refiner.GetLevel(l + 1).GetNumVertices()));
        for (int v = 0; v < level.GetNumVertices(); ++v)
            children[static_cast<std::size_t>(level.GetVertexChildVertex(v))] =
                parents[static_cast<std::size_t>(v)];
        for (int e = 0; e < level.GetNumEdges(); ++e) {
            const auto ends = level.GetEdgeVertices(e);
            children[static_cast<std::size_t>(level.GetEdgeChildVertex(e))] = parentsBetween(
                parents[static_cast<std::size_t>(ends[0])], parents[static_cast<std::size_t>(ends[1])]);
        }
        parents = std::move(children);
    }
    return parents;
}

std::vector<CoverTopology::Edge> findEdges(const Far::TopologyRefiner& refiner)
{
    const Far::TopologyLevel& coarse = refiner.GetLevel(0);
    std::vector<CoverTopology::Edge> edges;
    edges.reserve(static_cast<std::size_t>(coarse.GetNumEdges()));
    for (int e = 0; e < coarse.GetNumEdges(); ++e) {
        const auto ends = coarse.GetEdgeVertices(e);
        const int a = std::min(ends[0], ends[1]), b = std::max(ends[0], ends[1]);
        const int middle = coarse.GetEdgeChildVertex(e);
        CoverTopology::Edge edge{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), {}};
        edge.between.fill(static_cast<std::uint32_t>(middle));
        if (refiner.GetMaxLevel() == 2) {
            const Far::TopologyLevel& half = refiner.GetLevel(1);
            const int first = half.FindEdge(coarse.GetVertexChildVertex(a), middle);
            const int second = half.FindEdge(middle, coarse.GetVertexChildVertex(b));
            if (first < 0 || second < 0)
                continue; // of a triangle without three corners
            edge.between = {static_cast<std::uint32_t>(half.GetEdgeChildVertex(first)),
                            static_cast<std::uint32_t>(half.GetVertexChildVertex(middle)),
                            static_cast<std::uint32_t>(half.GetEdgeChildVertex(second))};
        }
        edges.push_back(edge);
    }
    std::ranges::sort(edges, {}, [](const CoverTopology::Edge& e) { return std::pair(e.a, e.b); });
    return edges;
}

/// In numbers of the last level: a vertex's child has its number, since children of vertices come first.
std::vector<CoverTopology::Triangle> trianglesOf(const Far::TopologyLevel& level)
{
    std::vector<CoverTopology::Triangle> triangles;
    triangles.reserve(static_cast<std::size_t>(level.GetNumFaces()));
    for (int f = 0; f < level.GetNumFaces(); ++f) {
        const auto corners = level.GetFaceVertices(f);
        triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
                             static_cast<std::uint32_t>(corners[2])});
    }
    return triangles;
}

} // namespace

LoopStencils::LoopStencils(const LoopMesh& mesh, int levels)
{
    const Refiner refiner = makeRefiner(mesh, levels);
    // Not Far::StencilTableFactory, which casts what this makes to a class that it is not.
    using Factory = Far::StencilTableFactoryReal<float>;
    Factory::Options options;
    options.generateOffsets = false;
    options.generateIntermediateLevels = false;
    options.maxLevel = static_cast<unsigned>(levels) & 0xfU;
    const std::unique_ptr<const Far::StencilTableReal<float>> table(Factory::Create(*refiner, options));
    m_start.push_back(0);
    for (const int size : table->GetSizes())
        m_start.push_back(m_start.back() + static_cast<std::uint32_t>(size));
    m_index.assign(table->GetControlIndices().begin(), table->GetControlIndices().end());
    m_weight = table->GetWeights();
    for (int l = 1; l <= levels; ++l)
        m_triangles.push_back(trianglesOf(refiner->GetLevel(l)));
    parents = findParents(*refiner);
    if (levels <= 2)
        edges = findEdges(*refiner);
}

void LoopStencils::apply(const Points& points, std::size_t count, Points& refined) const
{
    refined.resize(count);
    std::uint32_t at = 0;
    for (std::size_t v = 0; v < count; ++v) {
        Point sum = Point::Zero();
        for (const std::uint32_t end = m_start[v + 1]; at < end; ++at)
            sum += m_weight[at] * points[m_index[at]];
        refined[v] = sum;
    }
}

} // namespace bolster
