// Work that must not grow with the square of what there is to do.
#include "BSpline.h"
#include "DesignCheck.h"
#include "DesignJson.h"
#include "PatchMerge.h"
#include "PatchSplit.h"

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

/// A patch with handle curves upright beside each other, 1 mm apart, all of one name.
Design withHandles(int count)
{
    Design design;
    Edit edit;
    edit.changes.push_back({ElementId{1}, nullptr, makeElement(Fabric{})});
    Patch patch;
    patch.fabric = ElementId{1};
    const double width = count + 1;
    patch.outline = BSpline2(1, true, {{0, 0}, {width, 0}, {width, 100}, {0, 100}});
    edit.changes.push_back({ElementId{2}, nullptr, makeElement(patch)});
    for (int i = 1; i <= count; ++i) {
        HandleCurve handle;
        handle.name = "Handle";
        handle.patch = ElementId{2};
        handle.curve = BSpline2(1, false, {Vec2(i, 20), Vec2(i, 80)});
        handle.target = BSpline3(1, false, {Vec3(i, 20, 0), Vec3(i, 80, 0)});
        edit.changes.push_back({ElementId{2 + i}, nullptr, makeElement(std::move(handle))});
    }
    return design.with(edit);
}

TEST(Growth, PatchesWithManyHandlesAreCut)
{
    EXPECT_LT(
        growth(
            400, withHandles,
            [](const Design& design) {
                const double width = design.count<HandleCurve>() + 1;
                const edits::Outcome cut = edits::splitPatch(design, ElementId{2}, {{-10, 50}, {width + 10, 50}});
                EXPECT_TRUE(cut.problem.empty()) << cut.problem.english();
                EXPECT_EQ(design.with(cut.edit).count<HandleCurve>(), 2 * design.count<HandleCurve>());
            }),
        nearlyLinear);
}

TEST(Growth, PatchesWithManyHandlesAreMerged)
{
    const auto make = [](int count) {
        const Design design = withHandles(count);
        return design.with(edits::splitPatch(design, ElementId{2}, {{-10, 50}, {count + 11.0, 50}}).edit);
    };
    EXPECT_LT(growth(80, make,
                     [](const Design& design) {
                         ElementId seam{};
                         design.each<Seam>([&](ElementId id, const Seam&) { seam = id; });
                         const edits::Outcome merged = edits::mergePatches(design, seam);
                         EXPECT_TRUE(merged.problem.empty()) << merged.problem.english();
                         EXPECT_EQ(design.with(merged.edit).count<HandleCurve>(), design.count<HandleCurve>() / 2);
                     }),
              nearlyLinear);
}

} // namespace
} // namespace bolster::test
