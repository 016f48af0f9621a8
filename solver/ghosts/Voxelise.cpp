#include "Voxelise.h"

#include <algorithm>

namespace bolster {

namespace {

struct Range {
    std::array<int, 3> begin;
    std::array<int, 3> end;
};

/// The voxels that a box touches.
Range rangeOf(const Box3& box, const VoxelGrid& grid)
{
    Range range{};
    for (int k = 0; k < 3; ++k) {
        const double low = box.min()[k] / grid.edge - grid.low[k], high = box.max()[k] / grid.edge - grid.low[k];
        range.begin[k] = static_cast<int>(std::clamp(std::floor(low), 0.0, double(grid.size[k])));
        range.end[k] = static_cast<int>(std::clamp(std::floor(high) + 1, 0.0, double(grid.size[k])));
    }
    return range;
}

/// Marks every voxel that the triangle passes through, and a few more.
void mark(const TriangleTree::Triangle& triangle, const VoxelGrid& grid, std::vector<std::uint8_t>& touched)
{
    Box3 box;
    for (const Vec3& corner : triangle)
        box.extend(corner);
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    const double reach = 0.5 * grid.edge * normal.cwiseAbs().sum() * (1 + 1e-9);
    const Range range = rangeOf(box, grid);
    for (int z = range.begin[2]; z < range.end[2]; ++z)
        for (int y = range.begin[1]; y < range.end[1]; ++y)
            for (int x = range.begin[0]; x < range.end[0]; ++x)
                if (std::abs(normal.dot(grid.centre(x, y, z) - triangle[0])) <= reach)
                    touched[grid.index(x, y, z)] = 1;
}

/// Fills one row of voxels, from `begin` to `end`.
class Row {
public:
    Row(const FrameBody& body, Voxels& voxels, const std::vector<std::uint8_t>& touched, int y, int z)
        : m_body(body)
        , m_grid(voxels.grid)
        , m_inside(voxels.inside.data() + voxels.grid.index(0, y, z))
        , m_touched(touched.data() + voxels.grid.index(0, y, z))
        , m_y(y)
        , m_z(z)
    {}

    void fill(int begin, int end)
    {
        constexpr int longestOfOpen = 8;
        while (begin < end) {
            int stop = begin + 1;
            if (!m_touched[begin])
                while (stop < end && !m_touched[stop] && (m_body.closed || stop - begin < longestOfOpen))
                    ++stop;
            const bool first = contains(begin);
            set(begin, stop, first, m_body.closed || stop - begin < 2 ? first : contains(stop - 1));
            begin = stop;
        }
    }

private:
    bool contains(int x) const { return m_body.tree.windingNumber(m_grid.centre(x, m_y, m_z)) > 0.5; }

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
    const std::uint8_t* m_touched;
    int m_y;
    int m_z;
};

} // namespace

void fillInside(const FrameBody& body, Voxels& voxels, WorkerPool& pool, const std::stop_token& stop)
{
    if (body.tree.box().isEmpty())
        return;
    std::vector<std::uint8_t> touched(voxels.inside.size(), 0);
    for (const TriangleTree::Triangle& triangle : body.tree.triangles())
        mark(triangle, voxels.grid, touched);
    const Range range = rangeOf(body.tree.box(), voxels.grid);
    pool.forTasks(range.end[2] - range.begin[2], [&](int task) {
        for (int y = range.begin[1]; y < range.end[1] && !stop.stop_requested(); ++y)
            Row(body, voxels, touched, y, range.begin[2] + task).fill(range.begin[0], range.end[0]);
    });
}

} // namespace bolster
