// Any number of points comes in, a limited number stays: one in each cube of a grid.
#pragma once

#include "ImportWatch.h"
#include "PointCloud.h"

#include <optional>

namespace bolster {

/// As long as there are no more than the limit, all stay, bit for bit. Then a grid is chosen, and each of its cubes
/// keeps the point that came first; when too many cubes are taken, the grid becomes twice as coarse. So of a
/// surface a quarter of the limit stays, or more. The result depends on the points and their order alone.
class CloudThinner {
public:
    CloudThinner(std::size_t most, ImportWatch watch);

    std::uint64_t count() const { return m_count; } ///< that came in
    void reserve(std::uint64_t count);
    /// Finite ones, at most 1e7. Colours, 0xRRGGBB, are kept while every point has one.
    void add(const Vec3& point, std::optional<std::uint32_t> color = {});
    PointCloud take();

private:
    void append(const Vec3& point, std::optional<std::uint32_t> color);
    void grow();
    void shrink();
    void chooseGrid();
    void emptyCubes();
    void thin();
    bool keep(const Vec3& point, std::optional<std::uint32_t> color);
    std::size_t slotOf(const Vec3& point) const;
    std::size_t estimateCubes(double edge) const;
    bool isFull() const { return m_cloud.points.size() == m_most; }

    std::size_t m_most;
    ImportWatch m_watch;
    std::uint64_t m_count = 0;
    PointCloud m_cloud;
    bool m_colored = false;
    std::vector<std::uint32_t> m_taken; // open addressing: index of the cube's point + 1, or 0
    std::uint64_t m_seed;               // random, so that no file can be made to collide
};

} // namespace bolster
