#include "Voxelise.h"

#include "CushionVoxels.h"
#include "RowCrossings.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace bolster {

namespace {

struct VoxelRange {
    std::array<int, 3> begin;
    std::array<int, 3> end;

    std::size_t size(int axis) const { return static_cast<std::size_t>(end[axis] - begin[axis]); }
};

/// The voxels that a box touches.
VoxelRange rangeOf(const Box3& box, const VoxelGrid& grid)
{
    VoxelRange range{};
    for (int k = 0; k < 3; ++k) {
        const double low = box.min()[k] / grid.edge - grid.low[k], high = box.max()[k] / grid.edge - grid.low[k];
        range.begin[k] = static_cast<int>(std::clamp(std::floor(low), 0.0, double(grid.size[k])));
        range.end[k] = static_cast<int>(std::clamp(std::floor(high) + 1, 0.0, double(grid.size[k])));
    }
    return range;
}

/// Which voxels of a range triangles pass through, and a few more.
class Touched {
public:
    Touched(const FrameBody& body, const VoxelGrid& grid, const std::stop_token& stop)
        : m_grid(grid)
        , m_range(rangeOf(body.tree.box(), grid))
        , m_marks(m_range.size(0) * m_range.size(1) * m_range.size(2), 0)
    {
        for (const TriangleTree::Triangle& triangle : body.tree.triangles()) {
            if (stop.stop_requested())
                return;
            mark(triangle);
        }
    }

    const VoxelRange& range() const { return m_range; }
    /// Of one row, from the first voxel of the range.
    const std::uint8_t* row(int y, int z) const { return m_marks.data() + index(m_range.begin[0], y, z); }

private:
    std::size_t index(int x, int y, int z) const
    {
        return std::size_t(x - m_range.begin[0]) +
               m_range.size(0) *
                   (std::size_t(y - m_range.begin[1]) + m_range.size(1) * std::size_t(z - m_range.begin[2]));
    }

    /// Column by column of the axis that it faces most: in each it passes through few.
    void mark(const TriangleTree::Triangle& triangle)
    {
        Box3 box;
        for (const Vec3& corner : triangle)
            box.extend(corner);
        const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
        if (!(normal.squaredNorm() > 0))
            return; // nothing changes where it is
        const double reach = 0.5 * m_grid.edge * normal.cwiseAbs().sum() * (1 + 1e-9);
        const VoxelRange range = rangeOf(box, m_grid);
        int across = 0;
        normal.cwiseAbs().maxCoeff(&across);
        const int u = (across + 1) % 3, v = (across + 2) % 3;
        const double first = 0.5 + m_grid.low[across] - triangle[0][across] / m_grid.edge;
        const double most = reach / (std::abs(normal[across]) * m_grid.edge) + 1; // in voxels, and one for rounding
        std::array<int, 3> at{};
        for (at[u] = range.begin[u]; at[u] < range.end[u]; ++at[u])
            for (at[v] = range.begin[v]; at[v] < range.end[v]; ++at[v]) {
                at[across] = 0;
                const Vec3 way = m_grid.centre(at[0], at[1], at[2]) - triangle[0];
                const double middle =
                    -(normal[u] * way[u] + normal[v] * way[v]) / (normal[across] * m_grid.edge) - first;
                const double low =
                    std::clamp(std::floor(middle - most), double(range.begin[across]), double(range.end[across]));
                for (at[across] = static_cast<int>(low);
                     at[across] < range.end[across] && at[across] <= middle + most; ++at[across])
                    if (std::abs(normal.dot(m_grid.centre(at[0], at[1], at[2]) - triangle[0])) <= reach)
                        m_marks[index(at[0], at[1], at[2])] = 1;
            }
    }

    const VoxelGrid& m_grid;
    VoxelRange m_range;
    std::vector<std::uint8_t> m_marks;
};

/// Fills one row of voxels, from `begin` to `end`.
class Row {
public:
    Row(const FrameBody& body, Voxels& voxels, const Touched& touched, int y, int z)
        : m_body(body)
        , m_grid(voxels.grid)
        , m_inside(voxels.inside.data() + voxels.grid.index(0, y, z))
        , m_touched(touched.row(y, z))
        , m_begin(touched.range().begin[0])
        , m_end(touched.range().end[0])
        , m_y(y)
        , m_z(z)
    {}

    /// False when there is nothing to fill.
    bool fill()
    {
        constexpr int longestOfOpen = 8;
        for (int begin = m_begin; begin < m_end;) {
            int stop = begin + 1;
            if (!touched(begin))
                while (stop < m_end && !touched(stop) && (m_body.closed || stop - begin < longestOfOpen))
                    ++stop;
            const bool first = contains(begin);
            set(begin, stop, first, m_body.closed || stop - begin < 2 ? first : contains(stop - 1));
            begin = stop;
        }
        return m_any;
    }
    int looks() const { return m_looks; }

private:
    bool touched(int x) const { return m_touched[x - m_begin]; }
    bool contains(int x)
    {
        ++m_looks;
        const bool inside = m_body.tree.windingNumber(m_grid.centre(x, m_y, m_z)) > 0.5;
        m_any = m_any || inside;
        return inside;
    }

    /// The first and the last are known, and between them it changes once at most.
    void set(int begin, int end, bool first, bool last)
    {
        if (first == last) {
            if (first)
                std::fill(m_inside + begin, m_inside + end, std::uint8_t{1});
            return;
        }
        const int middle = (begin + end) / 2;
        if (end - begin == 2) {
            m_inside[first ? begin : begin + 1] = 1;
            return;
        }
        const bool there = contains(middle);
        set(begin, middle + 1, first, there);
        set(middle, end, there, last);
    }

    const FrameBody& m_body;
    const VoxelGrid& m_grid;
    std::uint8_t* m_inside;
    const std::uint8_t* m_touched; // from m_begin on
    int m_begin;
    int m_end;
    int m_y;
    int m_z;
    int m_looks = 0;
    bool m_any = false;
};

/// Of a closed body: a row of which the steps are known.
class CountedRow {
public:
    CountedRow(Voxels& voxels, const VoxelRange& range, int y, int z, const int* steps)
        : m_inside(voxels.inside.data() + voxels.grid.index(range.begin[0], y, z))
        , m_count(range.size(0))
        , m_steps(steps)
    {}

    /// Whether it leaves the body as often as it comes in.
    bool isSound() const { return std::accumulate(m_steps, m_steps + m_count + 1, 0) == 0; }
    /// False when there is nothing to fill.
    bool fill()
    {
        bool any = false;
        int winding = 0;
        for (std::size_t x = m_count; x-- > 0;) {
            winding += m_steps[x + 1];
            if (winding > 0)
                m_inside[x] = 1;
            any = any || winding > 0;
        }
        return any;
    }

private:
    std::uint8_t* m_inside;
    std::size_t m_count;
    const int* m_steps;
};

/// All rows of a closed body.
class CountedRows {
public:
    CountedRows(const TriangleTree& tree, Voxels& voxels, const VoxelRange& range, const std::stop_token& stop)
        : m_voxels(voxels)
        , m_range(range)
        , m_crossings(tree.triangles(), voxels.grid, range.begin, range.end, stop)
        , m_stop(stop)
    {}

    /// Whether each row leaves the body as often as it comes in: else it is not what it seems.
    bool areSound(WorkerPool& pool) const
    {
        return !anyRow(pool, [](CountedRow row, int, int) { return !row.isSound(); });
    }
    bool fill(WorkerPool& pool) const
    {
        return anyRow(pool, [](CountedRow row, int, int) { return row.fill(); });
    }

    /// Calls `is(row, y, z)` for every row.
    template <class Is>
    bool anyRow(WorkerPool& pool, const Is& is) const
    {
        std::atomic<bool> any = false;
        pool.forTasks(m_range.end[2] - m_range.begin[2], [&](int task) {
            if (m_stop.stop_requested())
                return;
            const int z = m_range.begin[2] + task;
            const std::vector<int> steps = m_crossings.layer(z);
            for (int y = m_range.begin[1]; y < m_range.end[1]; ++y) {
                const std::size_t row = static_cast<std::size_t>(y - m_range.begin[1]);
                if (is(CountedRow(m_voxels, m_range, y, z, steps.data() + m_crossings.stepsOfRow() * row), y, z))
                    any = true;
            }
        });
        return any;
    }

private:
    Voxels& m_voxels;
    VoxelRange m_range;
    RowCrossings m_crossings;
    const std::stop_token& m_stop;
};

} // namespace

bool fillInside(const FrameBody& body, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop)
{
    if (body.tree.box().isEmpty())
        return false;
    if (body.closed) {
        const CountedRows rows(body.tree, voxels, rangeOf(body.tree.box(), voxels.grid), stop);
        if (rows.areSound(pool))
            return rows.fill(pool);
    }
    std::atomic<bool> any = false;
    const Touched touched(body, voxels.grid, stop);
    const VoxelRange& range = touched.range();
    pool.forTasks(range.end[2] - range.begin[2], [&](int task) {
        for (int y = range.begin[1]; y < range.end[1] && !stop.stop_requested(); ++y)
            if (Row(body, voxels, touched, y, range.begin[2] + task).fill())
                any = true;
    });
    return any;
}

void fillWithin(const TriangleTree& surface, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop)
{
    if (surface.box().isEmpty())
        return;
    const VoxelRange range = rangeOf(surface.box(), voxels.grid);
    CountedRows(surface, voxels, range, stop).anyRow(pool, [&](CountedRow row, int y, int z) {
        if (row.isSound())
            return row.fill();
        for (int x = range.begin[0]; x < range.end[0]; ++x)
            if (surface.windingNumber(voxels.grid.centre(x, y, z)) > 0.5)
                voxels.inside[voxels.grid.index(x, y, z)] = 1;
        return true;
    });
}

std::optional<bool> hasInside(const FrameBody& body, double edge, int& looks)
{
    const Box3& box = body.tree.box();
    constexpr double most = 1e7; // bytes
    if (box.isEmpty() || voxelCount(box, edge, 0) > most)
        return box.isEmpty() ? std::optional(false) : std::nullopt;
    Voxels voxels{VoxelGrid::around(box, edge, 0), {}};
    voxels.inside.assign(voxels.grid.voxelCount(), 0);
    if (body.closed) {
        WorkerPool alone(1);
        return fillInside(body, voxels, alone);
    }
    const Touched touched(body, voxels.grid, {});
    for (int z = touched.range().begin[2]; z < touched.range().end[2]; ++z)
        for (int y = touched.range().begin[1]; y < touched.range().end[1]; ++y) {
            Row row(body, voxels, touched, y, z);
            if (row.fill())
                return true;
            looks -= row.looks();
            if (looks < 0)
                return std::nullopt;
        }
    return false;
}

} // namespace bolster
