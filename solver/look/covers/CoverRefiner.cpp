#include "CoverRefiner.h"

#include "CoverCreases.h"
#include "HalfEdges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace bolster {

namespace {

using Points = LoopStencils::Points;

constexpr int stepsForAll = 4;
constexpr int stepsForHeld = 12;
constexpr float heldFactor = 1.4F; ///< over-relaxation: S along lines has eigenvalues from 1/3 to 1

/// c with S c = points, nearly: see the header.
Points corrected(const Points& points, const std::vector<char>& held, const LoopStencils& stencils)
{
    Points control = points, refined;
    for (int step = 0; step < stepsForHeld; ++step) {
        stencils.apply(control, points.size(), refined);
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (held[v])
                control[v] += heldFactor * (points[v] - refined[v]);
            else if (step < stepsForAll)
                control[v] += points[v] - refined[v];
        }
    }
    return control;
}

std::vector<char> heldVertices(const SurfaceTopology& topology, const LoopMesh& patches)
{
    std::vector<char> held(topology.pattern.size(), 0);
    eachEdge(halfEdges(patches.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 1) // on the border
            held[first->low] = held[first->high] = 1;
    });
    for (const SurfaceTopology::Line& line : topology.lines)
        for (const std::uint32_t v : line.vertices)
            held[v] = 1;
    return held;
}

bool sameCreases(const SurfaceTopology& a, const SurfaceTopology& b)
{
    return std::ranges::equal(a.seams, b.seams, {}, &SurfaceTopology::Chain::continuity,
                              &SurfaceTopology::Chain::continuity) &&
           std::ranges::equal(a.lines, b.lines, {}, &SurfaceTopology::Line::crease, &SurfaceTopology::Line::crease);
}

} // namespace

bool CoverRefiner::prepared(const SurfaceTopology& topology, int levels) const
{
    return m_cover && m_cover->levels == levels && m_coarse->serial == topology.serial &&
           m_coarse->triangles.size() == topology.triangles.size() &&
           m_coarse->pattern.size() == topology.pattern.size() && sameCreases(*m_coarse, topology);
}

void CoverRefiner::prepare(const std::shared_ptr<const SurfaceTopology>& topology, int levels)
{
    if (topology == m_coarse && m_cover && m_cover->levels == levels)
        return;
    auto cover = std::make_shared<CoverTopology>();
    if (prepared(*topology, levels)) {
        *cover = *m_cover;
    } else {
        m_cover.reset();
        const CoverCreases creases = CoverCreases::of(*topology);
        m_merged = LoopStencils(creases.merged, levels);
        m_patches = LoopStencils(creases.patches, levels);
        m_unknown = creases.unknown;
        m_heldPatches = heldVertices(*topology, creases.patches);
        m_heldMerged.assign(creases.merged.vertexCount, 0);
        for (std::size_t v = 0; v < m_unknown.size(); ++v)
            m_heldMerged[m_unknown[v]] |= m_heldPatches[v];
        cover->levels = levels;
        cover->triangles = m_patches.triangles().back();
        cover->parents = m_patches.parents;
        cover->edges = m_patches.edges;
        cover->merged.assign(m_patches.count(), 0);
        const auto& merged = m_merged.triangles().back(); // both have the same triangles in the same order
        for (std::size_t t = 0; t < cover->triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k)
                cover->merged[cover->triangles[t][k]] = merged[t][k];
    }
    cover->coarse = topology;
    makePattern(*cover);
    m_coarse = topology;
    m_cover = std::move(cover);
    findSmoothSeams(*topology);
}

void CoverRefiner::makePattern(CoverTopology& cover) const
{
    Points pattern, refined;
    for (const Vec2& p : cover.coarse->pattern)
        pattern.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0, 0});
    m_patches.apply(corrected(pattern, m_heldPatches, m_patches), m_patches.count(), refined);
    cover.pattern.clear();
    for (const LoopStencils::Point& p : refined)
        cover.pattern.emplace_back(p.head<2>());
}

/// Where smooth seams meet, all the patches around have one normal.
void CoverRefiner::findSmoothSeams(const SurfaceTopology& topology)
{
    std::map<std::uint32_t, std::vector<std::uint32_t>> meeting;
    for (const SurfaceTopology::Chain& chain : topology.seams) {
        if (chain.continuity == Continuity::C0)
            continue;
        for (const auto* side : {&chain.a, &chain.b})
            for (const std::uint32_t v : m_cover->along(*side))
                meeting[m_cover->merged[v]].push_back(v);
    }
    m_oneNormal.clear();
    for (auto& [merged, vertices] : meeting) {
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        m_oneNormal.push_back(std::move(vertices));
    }
}

Points CoverRefiner::controlPoints(const SurfaceMesh& surface, const Vec3& origin) const
{
    Points points(m_heldMerged.size(), LoopStencils::Point::Zero());
    for (std::size_t v = 0; v < m_unknown.size(); ++v)
        points[m_unknown[v]].head<3>() = (surface.positions[v] - origin).cast<float>();
    return corrected(points, m_heldMerged, m_merged);
}

/// `points` of merged vertices.
std::vector<Eigen::Vector3f> CoverRefiner::normals(const Points& points) const
{
    Points sum(m_cover->merged.size(), LoopStencils::Point::Zero());
    for (const auto& [a, b, c] : m_cover->triangles) {
        const LoopStencils::Point& p = points[m_cover->merged[a]];
        const LoopStencils::Point u = points[m_cover->merged[b]] - p, v = points[m_cover->merged[c]] - p;
        const LoopStencils::Point normal = u.cross3(v); // its length is twice the area
        sum[a] += normal;
        sum[b] += normal;
        sum[c] += normal;
    }
    for (const std::vector<std::uint32_t>& meeting : m_oneNormal) {
        LoopStencils::Point all = LoopStencils::Point::Zero();
        for (const std::uint32_t v : meeting)
            all += sum[v];
        for (const std::uint32_t v : meeting)
            sum[v] = all;
    }
    std::vector<Eigen::Vector3f> normals(sum.size());
    for (std::size_t v = 0; v < sum.size(); ++v) {
        const Eigen::Vector3f n = sum[v].head<3>();
        const float length2 = n.squaredNorm();
        normals[v] =
            length2 > 0 ? Eigen::Vector3f(n / std::sqrt(length2)) : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
    }
    return normals;
}

CoverMeshPtr CoverRefiner::refine(const SurfaceMeshPtr& surface, int levels)
{
    if (surface->positions.size() != surface->topology->vertexCount() ||
        !std::ranges::all_of(surface->positions, [](const Vec3& p) { return p.allFinite(); }))
        throw std::runtime_error("not every vertex has a position");
    prepare(surface->topology, levels);
    const Vec3 origin = surface->positions.empty() ? Vec3(Vec3::Zero()) : surface->positions.front();
    Points refined;
    m_merged.apply(controlPoints(*surface, origin), m_merged.count(), refined);
    auto cover = std::make_shared<CoverMesh>();
    cover->topology = m_cover;
    cover->surface = surface;
    cover->normals = normals(refined);
    cover->points.resize(m_cover->merged.size());
    const Eigen::Vector3f back = origin.cast<float>();
    for (std::size_t v = 0; v < cover->points.size(); ++v)
        cover->points[v] = refined[m_cover->merged[v]].head<3>() + back;
    return cover;
}

} // namespace bolster
