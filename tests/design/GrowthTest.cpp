// Work that must not grow with the square of what there is to do.
#include "BSpline.h"
#include "DesignCheck.h"
#include "DesignJson.h"

#include "Growth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster::test {
namespace {

std::string textOf(int count, const std::string& before, const std::string& after)
{
    std::string text = R"({"format": "bolster-design", "version": 1, "unit": "mm", "settings": {"edge_length": 60},
        "elements": [{"id": 900000, "kind": "fabric", "name": "F"})";
    for (int i = 1; i <= count; ++i)
        text += ", " + before + std::to_string(i) + after;
    return text + "]}";
}

TEST(Growth, BadElementsAreRead)
{
    const auto make = [](int count) { return textOf(count, R"({"kind": "patch", "id": )", "}"); };
    const auto work = [](const std::string& text) { EXPECT_GT(allProblems(readDesign(text)).size(), 100u); };
    EXPECT_LT(growth(500, make, work), nearlyLinear);
}

TEST(Growth, PatchesAndFabricsAreChecked)
{
    const auto make = [](int count) {
        Design design;
        Edit edit;
        for (int i = 1; i <= count; ++i) {
            Fabric fabric;
            fabric.bendingLength = 1; // finer than the mesh: a warning
            edit.changes.push_back({ElementId{2 * i}, nullptr, makeElement(fabric)});
            Patch patch;
            patch.fabric = ElementId{2 * i};
            patch.outline = BSpline2(1, true, {{0, 0}, {99, 0}, {99, 99}});
            edit.changes.push_back({ElementId{2 * i + 1}, nullptr, makeElement(patch)});
        }
        return design.with(edit);
    };
    EXPECT_LT(growth(250, make, [](const Design& design) { EXPECT_FALSE(checkDesign(design).empty()); }),
              nearlyLinear);
}

TEST(Growth, CornersOfAPolygonAreFound)
{
    const auto make = [](int count) {
        std::vector<Vec2> points;
        for (int k = 0; k < count; ++k)
            points.emplace_back(std::cos(k), std::sin(k));
        return BSpline2(1, true, points);
    };
    EXPECT_LT(growth(6000, make,
                     [](const BSpline2& curve) {
                         for (int round = 0; round < 10; ++round)
                             EXPECT_EQ(std::ssize(curve.corners()), curve.pointCount());
                     }),
              nearlyLinear);
}

TEST(Growth, ProblemsAreJoined)
{
    const auto make = [](int count) {
        Problems problems;
        for (int k = 0; k < count; ++k)
            problems.push_back({settingsId, "design", "elements[" + std::to_string(k) + "]", {"wrong"}});
        return problems;
    };
    EXPECT_LT(growth(1000, make,
                     [](const Problems& problems) {
                         Problems all = problems;
                         addNew(all, problems);
                         EXPECT_EQ(all.size(), problems.size());
                     }),
              nearlyLinear);
}

} // namespace
} // namespace bolster::test
