// Points in equal triangles, which fill the inside of a patch.
#pragma once

#include "PatchTriangulator.h"

namespace bolster {

/// Seeds in horizontal rows, centred, so that a symmetric patch gets a symmetric mesh as far as rows can be.
class SeedLattice {
public:
    /// Keeps a gap to the outline and to the lines.
    SeedLattice(const std::vector<Vec2>& boundary, const std::vector<InnerLine>& lines, double edgeLength);

    /// Row by row from below, from left to right; mm.
    const std::vector<Vec2>& points() const { return m_points; }
    /// How many rings of seeds lie around this one, with nothing but seeds in them, as far as they are counted;
    /// less than 1: the outline or a line is beside it.
    int rings(int seed) const { return m_rings[static_cast<std::size_t>(seed)]; }
    /// Whoever has so many is inside.
    static constexpr int insideRings = 4;
    bool isInside(int seed) const { return rings(seed) >= insideRings; }
    /// All its neighbours are inside, too.
    bool isWithin(int seed) const { return rings(seed) > insideRings; }
    /// Of seeds that are inside: counter-clockwise, from the first of them on.
    std::vector<std::array<int, 3>> insideTriangles() const;

private:
    enum Side { Left, Right, BelowLeft, BelowRight, AboveLeft, AboveRight };
    using Neighbours = std::array<int, 6>; // by side; none: -1

    void addRow(bool shifted, double y, double middle, double edge, const std::vector<double>& crossings,
                const class SegmentGrid& grid);
    void findNeighbours();
    void countRings();

    struct Row {
        int firstColumn = 0;
        std::vector<int> seeds; // by column, from the first one on; none: -1
        bool shifted = false;   // by half an edge to the right
        int at(int column) const;
    };
    std::vector<Row> m_rows;
    std::vector<Vec2> m_points;
    std::vector<Neighbours> m_neighbours;
    std::vector<signed char> m_rings;
};

} // namespace bolster
