#include "Relief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace bolster {

namespace {

double smoothstep(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

class ReliefMaker {
public:
    ReliefMaker(const SewnMesh& mesh, const OutlineSampling& sampling)
        : m_mesh(mesh)
        , m_sampling(sampling)
        , m_sharing(mesh.topology->unknownCount, 0)
    {
        for (std::uint32_t unknown : mesh.topology->unknown)
            ++m_sharing[unknown];
    }

    SewnMesh::Relief relief(int outline, ElementId seam, const FancySeam& shape) const
    {
        SewnMesh::Relief relief;
        relief.seam = seam;
        relief.depth = shape.depth;
        relief.profile = shape.profile;
        const std::vector<OutlineSampling::Line>& lines = m_sampling.outlines[outline].lines;
        const auto first = std::ranges::lower_bound(lines, seam, {}, &OutlineSampling::Line::element);
        const auto last = std::ranges::upper_bound(lines, seam, {}, &OutlineSampling::Line::element);
        std::vector<int> own(static_cast<std::size_t>(last - first));
        std::iota(own.begin(), own.end(), static_cast<int>(first - lines.begin()));
        const bool fadesAtStart = !endsInTheOpen(outline, own, true),
                   fadesAtEnd = !endsInTheOpen(outline, own, false);
        for (int k : own) {
            const std::vector<std::uint32_t>& vertices =
                m_mesh.topology->lines[m_mesh.firstLine[outline] + k].vertices;
            const std::vector<double> along = lengths(vertices);
            const std::size_t count = vertices.size() - (lines[k].shape.closed ? 1 : 0);
            for (std::size_t i = 0; i < count; ++i) {
                double share = 1;
                if (!lines[k].shape.closed && fadesAtStart)
                    share *= smoothstep(along[i] / shape.width);
                if (!lines[k].shape.closed && fadesAtEnd)
                    share *= smoothstep((along.back() - along[i]) / shape.width);
                relief.points.push_back({static_cast<int>(vertices[i]), lines[k].across, share});
            }
        }
        return relief;
    }

private:
    /// Whether all lines end at samples side by side on a free part of the outline: there nothing can tear.
    bool endsInTheOpen(int outline, const std::vector<int>& own, bool start) const
    {
        const OutlineSampling::Outline& samples = m_sampling.outlines[outline];
        const int count = static_cast<int>(samples.points.size());
        int previous = -1;
        for (int k : own) {
            const InnerLine& shape = samples.lines[k].shape;
            const int sample = start ? shape.startSample : shape.endSample;
            if (sample < 0)
                return false;
            const std::uint32_t unknown = m_mesh.topology->unknown[m_mesh.parts[outline].firstVertex + sample];
            if (static_cast<int>(unknown) >= m_mesh.freeCount || m_sharing[unknown] > 1)
                return false;
            const int apart = previous < 0 ? 1 : (sample - previous + count) % count;
            if (apart != 1 && apart != count - 1)
                return false;
            previous = sample;
        }
        return true;
    }

    /// From the start of the line to each vertex, in the pattern, mm.
    std::vector<double> lengths(const std::vector<std::uint32_t>& vertices) const
    {
        std::vector<double> along{0};
        for (std::size_t i = 1; i < vertices.size(); ++i)
            along.push_back(along.back() + (m_mesh.rest()[vertices[i]] - m_mesh.rest()[vertices[i - 1]]).norm());
        return along;
    }

    const SewnMesh& m_mesh;
    const OutlineSampling& m_sampling;
    std::vector<int> m_sharing; // vertices per unknown
};

} // namespace

std::vector<SewnMesh::Relief> makeReliefs(const SewnMesh& mesh, const OutlineSampling& sampling,
                                          const Design& design)
{
    std::vector<SewnMesh::Relief> reliefs;
    const ReliefMaker maker(mesh, sampling);
    design.each<FancySeam>([&](ElementId id, const FancySeam& seam) {
        const auto outline =
            std::ranges::lower_bound(sampling.outlines, seam.patch, {}, &OutlineSampling::Outline::patch);
        if (outline != sampling.outlines.end() && outline->patch == seam.patch)
            reliefs.push_back(maker.relief(static_cast<int>(outline - sampling.outlines.begin()), id, seam));
    });
    return reliefs;
}

void updateReliefs(SewnMesh& mesh, const Design& design)
{
    for (SewnMesh::Relief& relief : mesh.reliefs) {
        const FancySeam& seam = *design.find<FancySeam>(relief.seam);
        relief.depth = seam.depth;
        relief.profile = seam.profile;
    }
    updateCreases(mesh, design);
}

std::vector<Eigen::Vector3f> smoothNormals(const SurfaceTopology& topology, const std::vector<Vec3>& positions)
{
    std::vector<Eigen::Vector3f> normals(positions.size(), Eigen::Vector3f::Zero());
    for (const auto& [a, b, c] : topology.triangles) {
        const Eigen::Vector3f normal = // weighted by area
            (positions[b] - positions[a]).cross(positions[c] - positions[a]).cast<float>();
        normals[a] += normal;
        normals[b] += normal;
        normals[c] += normal;
    }
    for (Eigen::Vector3f& normal : normals)
        normal = normal.squaredNorm() > 0 ? normal.normalized() : Eigen::Vector3f(Eigen::Vector3f::UnitZ());
    return normals;
}

std::vector<Vec3> coverPositions(const SewnMesh& mesh, const SheetState& state)
{
    std::vector<Vec3> positions(static_cast<std::size_t>(mesh.vertexCount()));
    for (std::size_t v = 0; v < positions.size(); ++v)
        positions[v] = state.positions.col(mesh.topology->unknown[v]);
    if (mesh.reliefs.empty())
        return positions;
    const std::vector<Eigen::Vector3f> normals = smoothNormals(*mesh.topology, positions);
    for (const SewnMesh::Relief& relief : mesh.reliefs)
        for (const SewnMesh::Relief::Point& point : relief.points)
            positions[point.vertex] -= relief.depth * point.share * fancyProfile(relief.profile, point.across) *
                                       normals[point.vertex].cast<double>();
    return positions;
}

} // namespace bolster
