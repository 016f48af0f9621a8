#include "FoamSolid.h"

#include "BodyTree.h"
#include "CoverLids.h"
#include "FramePieces.h"
#include "IsoSurface.h"
#include "Voxelise.h"
#include "WorkerPool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

constexpr int blockEdge = 4;                 ///< voxels that are looked at together where nothing is near
constexpr std::size_t mostVoxels = 1U << 26; ///< 384 MB

class FoamGrid {
public:
    FoamGrid(const SurfaceMesh& cover, const Design& design, const DesignFiles& files, const FoamOrder& order,
             const std::stop_token& stop)
        : m_cover(trianglesOf(cover), stop)
        , m_lids(coverLids(cover), stop)
        , m_parts(partsOf(design, files, stop))
        , m_frames(bodiesOf(m_parts), stop)
        , m_grid(gridAround(cover.boundingBox(), order.edge))
        , m_inCover{m_grid, std::vector<std::uint8_t>(m_grid.voxelCount(), 0)}
        , m_inFrames(m_inCover)
        , m_below(order.below)
        , m_reach(2.5 * m_grid.edge)
    {}

    TriangleMesh solid(const std::stop_token& stop)
    {
        m_values.assign(m_grid.voxelCount(), -1);
        WorkerPool pool(0);
        fillWithin(TriangleTree(together(m_cover, m_lids), stop), m_inCover, pool, stop);
        for (const FrameParts& parts : m_parts)
            for (const auto& part : parts)
                for (const FrameBody& body : part)
                    fillInside(body, m_inFrames, pool, stop);
        std::array<int, 3> blocks{};
        for (std::size_t k = 0; k < 3; ++k)
            blocks[k] = (m_grid.size[k] + blockEdge - 1) / blockEdge;
        pool.forTasks(blocks[2] * blocks[1], [&](int row) {
            for (int x = 0; x < blocks[0] && !stop.stop_requested(); ++x)
                block(blockEdge * x, blockEdge * (row % blocks[1]), blockEdge * (row / blocks[1]));
        });
        return stop.stop_requested() ? TriangleMesh() : isoSurface(m_grid, m_values, stop);
    }

private:
    /// Coarser than was asked for where it would have too many voxels.
    static VoxelGrid gridAround(const Box3& box, double edge)
    {
        const Vec3 sizes = box.sizes() / edge + Vec3::Constant(8);
        const double tooMany = sizes.prod() / static_cast<double>(mostVoxels);
        return VoxelGrid::around(box, tooMany > 1 ? edge * std::cbrt(tooMany) * 1.05 : edge, 3);
    }

    static std::vector<TriangleTree::Triangle> trianglesOf(const SurfaceMesh& cover)
    {
        std::vector<TriangleTree::Triangle> triangles;
        for (const auto& t : cover.topology->triangles)
            triangles.push_back({cover.positions[t[0]], cover.positions[t[1]], cover.positions[t[2]]});
        return triangles;
    }

    static std::vector<TriangleTree::Triangle> together(const TriangleTree& a, const TriangleTree& b)
    {
        std::vector<TriangleTree::Triangle> triangles = a.triangles();
        triangles.insert(triangles.end(), b.triangles().begin(), b.triangles().end());
        return triangles;
    }

    static std::vector<FrameParts> partsOf(const Design& design, const DesignFiles& files,
                                           const std::stop_token& stop)
    {
        std::vector<FrameParts> parts;
        design.each<Frame>([&](ElementId id, const Frame& frame) {
            const auto file = files.meshes.find(id);
            const auto mesh = file != files.meshes.end() ? shownMesh(file->second, frame.hiddenParts) : nullptr;
            if (mesh)
                parts.push_back(frameParts(*mesh, frame, stop));
        });
        return parts;
    }

    static std::vector<const FrameBody*> bodiesOf(const std::vector<FrameParts>& frames)
    {
        std::vector<const FrameBody*> bodies;
        for (const FrameParts& parts : frames)
            for (const auto& part : parts)
                for (const FrameBody& body : part)
                    bodies.push_back(&body);
        return bodies;
    }

    /// How far inside of the foam the middle of a voxel is, mm, up to the reach; negative outside.
    double value(int x, int y, int z) const
    {
        const Vec3 p = m_grid.centre(x, y, z);
        const std::size_t voxel = m_grid.index(x, y, z);
        const double toCover = m_cover.distance(p, m_reach), toLid = m_lids.distance(p, m_reach);
        if (!m_inCover.inside[voxel])
            return -std::min(toCover + m_below, toLid);
        const double toFrame = m_frames.distance(p, m_reach);
        return std::min({toCover - m_below, toLid, m_inFrames.inside[voxel] ? -toFrame : toFrame});
    }

    /// One look for all where neither cover nor frame is near.
    void block(int x0, int y0, int z0)
    {
        const double radius = 0.5 * std::sqrt(3.0) * blockEdge * m_grid.edge;
        const Vec3 middle = m_grid.centre(x0, y0, z0) + Vec3::Constant(0.5 * (blockEdge - 1) * m_grid.edge);
        const double reach = radius + m_reach;
        std::optional<double> all;
        if (m_cover.distance(middle, reach) >= reach && m_lids.distance(middle, reach) >= reach &&
            m_frames.distance(middle, reach) >= reach) {
            const std::size_t voxel = m_grid.index(x0, y0, z0);
            all = m_inCover.inside[voxel] && !m_inFrames.inside[voxel] ? m_reach : -m_reach;
        }
        for (int z = z0; z < std::min(z0 + blockEdge, m_grid.size[2]); ++z)
            for (int y = y0; y < std::min(y0 + blockEdge, m_grid.size[1]); ++y)
                for (int x = x0; x < std::min(x0 + blockEdge, m_grid.size[0]); ++x)
                    m_values[m_grid.index(x, y, z)] = static_cast<float>(onBorder(x, y, z) ? -m_reach
                                                                         : all             ? *all
                                                                                           : value(x, y, z));
    }

    bool onBorder(int x, int y, int z) const
    {
        const std::array at{x, y, z};
        for (std::size_t k = 0; k < 3; ++k)
            if (at[k] == 0 || at[k] == m_grid.size[k] - 1)
                return true;
        return false;
    }

    TriangleTree m_cover, m_lids;
    std::vector<FrameParts> m_parts;
    BodyTree m_frames;
    VoxelGrid m_grid;
    Voxels m_inCover, m_inFrames;
    double m_below, m_reach;
    std::vector<float> m_values;
};

} // namespace

TriangleMesh foamSolid(const SurfaceMesh& cover, const Design& design, const DesignFiles& files,
                       const FoamOrder& order, const std::stop_token& stop)
{
    TriangleMesh solid = FoamGrid(cover, design, files, order, stop).solid(stop);
    if (stop.stop_requested() || solid.triangles.empty())
        return {};
    solid.parts = {{"foam", 0, static_cast<std::uint32_t>(solid.triangles.size())}};
    return solid;
}

} // namespace bolster
