// Seams between sheets that were parted, drawn anew.
#include "StraightSeams.h"
#include "JoinedSheets.h"
#include "TestForms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster {

namespace {

using namespace bolster::test;

constexpr double side = 400; // mm
constexpr int cells = 20;
constexpr double cell = side / cells; // mm

/// A square of cells, flat or bent up by 90 degrees at the middle, parted by a line that goes to and fro by so many
/// cells from row to row.
std::vector<FormSheet> zigzag(int steps, bool bent)
{
    const TriangleMesh grid = gridMesh(cells, cells, [&](double u, double v) {
        const double across = side * (u - 0.5);
        return bent && across > 0 ? Vec3(0, side * v, across) : Vec3(across, side * v, 0);
    });
    std::vector<FormSheet> sheets(2, FormSheet{grid.points, {}});
    for (std::size_t t = 0; t < grid.triangles.size(); ++t) {
        const auto& [a, b, c] = grid.triangles[t];
        const Vec3 center = (grid.points[a] + grid.points[b] + grid.points[c]) / 3;
        const int row = static_cast<int>(center.y() / cell);
        const bool right = center.x() + center.z() > (row % 2 == 0 ? 0 : steps * cell);
        sheets[right ? 1 : 0].triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    }
    return sheets;
}

double commonLength(const std::vector<FormSheet>& sheets, const SheetTrials& trials)
{
    double length = 0;
    for (const auto& [pair, each] : commonLengths(sheets, trials))
        length += each;
    return length;
}

TEST(StraightSeams, WhatGoesToAndFroBecomesShort)
{
    const SheetTrials trials({}, {}, {});
    std::vector<FormSheet> sheets = zigzag(2, false);
    EXPECT_NEAR(commonLength(sheets, trials), side + (cells - 1) * 2 * cell, 1);
    straighten(sheets, trials);
    EXPECT_LT(commonLength(sheets, trials), 1.1 * side);
    EXPECT_NEAR(sheets[0].area() + sheets[1].area(), side * side, 1e-6 * side * side);
    EXPECT_NEAR(sheets[0].area(), side * (side / 2 + cell), 0.02 * side * side) << "midway between its turns";
}

TEST(StraightSeams, ACreaseStaysWhereItIs)
{
    const SheetTrials trials({}, {}, {});
    std::vector<FormSheet> sheets = zigzag(0, true);
    EXPECT_NEAR(commonLength(sheets, trials), side, 1);
    straighten(sheets, trials);
    EXPECT_NEAR(commonLength(sheets, trials), side, 1);
    for (const auto& [a, b, c] : sheets[0].triangles)
        for (const int corner : {a, b, c})
            EXPECT_NEAR(sheets[0].points[corner].z(), 0, 1e-9);
}

} // namespace
} // namespace bolster
