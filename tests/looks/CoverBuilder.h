// Covers made of grids, for tests of what is shown.
#pragma once

#include "SurfaceMesh.h"

#include <functional>

namespace bolster::test {

class CoverBuilder {
public:
    using Bend = std::function<Vec3(const Vec2&)>; ///< from pattern to space, mm

    /// A rectangle from (0, 0) to `size` of columns x rows squares. `jitter`: moves inner vertices in the pattern
    /// by up to this share of a square. Returns the patch's number.
    std::size_t grid(const Vec2& size, int columns, int rows, const Bend& bend, double jitter = 0);

    enum class Side { Left, Right, Bottom, Top }; ///< x = 0, x = size.x, y = 0, y = size.y
    /// The vertices of a side, by increasing x or y.
    std::vector<std::uint32_t> side(std::size_t patch, Side side) const;
    /// Sews vertices that lie at the same place.
    void sew(std::vector<std::uint32_t> a, std::vector<std::uint32_t> b, Continuity continuity);
    /// The k-th column of a grid becomes a line.
    void line(std::size_t patch, int column, bool crease);

    SurfaceMeshPtr cover() const;

private:
    struct Grid {
        int columns, rows;
        std::uint32_t first;
        std::vector<std::uint32_t> at; ///< row by row: vertices of the outline come first, counter-clockwise
    };

    std::vector<Grid> m_grids;
    SurfaceTopology m_topology;
    std::vector<Vec3> m_positions;
    std::vector<std::uint32_t> m_joined;
};

} // namespace bolster::test
