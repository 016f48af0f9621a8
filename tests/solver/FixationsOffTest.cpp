// Fixation curves that a changed frame leaves behind.
#include "FixationsOff.h"

#include "ElementEdits.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

namespace bolster::test {
namespace {

PlacedMesh seat(double height)
{
    return {std::make_shared<const TriangleMesh>(boxMesh({Vec3(0, 0, 0), Vec3(400, 400, height)})), {}};
}

/// A design with straight fixation curves from one point to the other.
class FixationsOffTest : public testing::Test {
protected:
    ElementId add(const std::string& name, const Vec3& from, const Vec3& to)
    {
        const Edit added =
            edits::addElement(design, makeElement(FixationCurve{name, BSpline3(1, false, {from, to})}));
        design = design.with(added);
        return added.changes.front().id;
    }

    Design design;
};

TEST_F(FixationsOffTest, SaysWhatNoLongerLiesOnTheFrameAndByHowMuch)
{
    const ElementId top = add("top", {10, 10, 100}, {390, 10, 100});
    add("bottom", {10, 10, 0}, {390, 10, 0});
    add("in the air", {10, 10, 300}, {390, 10, 300});
    const auto left = fixationsOff(design, seat(100), seat(88));
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].curve, top);
    EXPECT_NEAR(left[0].distance, 12, 1e-6);
}

TEST_F(FixationsOffTest, WhatRanAlongAnEdgeIsComparedWithEdges)
{
    // The frame becomes longer: the end of its top lies on its surface still, but no longer on its edge.
    const auto longer = [](double depth) {
        PlacedMesh placed{std::make_shared<const TriangleMesh>(boxMesh({Vec3(0, 0, 0), Vec3(400, depth, 100)})),
                          {}};
        placed.edges = {{Vec3(0, depth, 100), Vec3(400, depth, 100)}, {Vec3(0, 0, 100), Vec3(400, 0, 100)}};
        return placed;
    };
    const ElementId back = add("back", {0, 400, 100}, {400, 400, 100});
    add("front", {0, 0, 100}, {400, 0, 100});
    add("across", {200, 0, 100}, {200, 400, 100});
    const auto left = fixationsOff(design, longer(400), longer(450));
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].curve, back);
    EXPECT_TRUE(left[0].fromEdge);
    EXPECT_NEAR(left[0].distance, 50, 1e-6);
}

TEST_F(FixationsOffTest, OnlyWhatLayOnTheFrameCounts)
{
    add("leaves the frame at its end", {10, 10, 100}, {10, 10, 300});
    const auto left = fixationsOff(design, seat(100), seat(97));
    ASSERT_EQ(left.size(), 1u);
    EXPECT_NEAR(left[0].distance, 3.3, 0.8) << "its upper end was never on it";
    EXPECT_TRUE(fixationsOff(design, seat(100), seat(100)).empty());
}

TEST_F(FixationsOffTest, TheFarthestStandsFirstAndThereIsAnEnd)
{
    const ElementId near = add("near", {10, 10, 0}, {390, 10, 0});
    const ElementId far = add("far", {10, 10, 1000}, {390, 10, 1000});
    PlacedMesh after = seat(1);
    after.placement.position = {0, 0, 5};
    const auto left = fixationsOff(design, seat(1000), after);
    ASSERT_EQ(left.size(), 2u);
    EXPECT_EQ(left[0].curve, far);
    EXPECT_EQ(left[0].distance, farthestLooked);
    EXPECT_EQ(left[1].curve, near);
    EXPECT_NEAR(left[1].distance, 5, 1e-6);
}

TEST_F(FixationsOffTest, WithoutAMeshThereIsNothingToSay)
{
    add("top", {10, 10, 100}, {390, 10, 100});
    EXPECT_TRUE(fixationsOff(design, {}, seat(80)).empty());
    EXPECT_TRUE(fixationsOff(design, seat(100), {}).empty());
}

} // namespace
} // namespace bolster::test
