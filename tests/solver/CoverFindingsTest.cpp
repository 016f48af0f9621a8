// What the window says of a cover that has come to rest: neither too little nor too much.
#include "TestDesigns.h"
#include "TestMeshes.h"

#include "CoverFindings.h"

#include <gtest/gtest.h>

#include <set>

#include <cstdio>

namespace bolster::test {
namespace {

using FindingKind = CoverFinding::Kind;

std::vector<CoverFinding> findingsOf(const Design& design, const DesignFiles& files = {})
{
    SolveOptions options;
    options.lenient = true;
    const SolveResult result = solveResting({design, files}, options);
    FrameDistance frames;
    std::vector<CoverFinding> found = coverFindings(*result.surface, design, files, frames);
    for (const CoverFinding& finding : found)
        std::printf("    %s\n", finding.text.english().c_str());
    return found;
}

bool has(const std::vector<CoverFinding>& found, FindingKind kind)
{
    return std::ranges::any_of(found, [kind](const CoverFinding& finding) { return finding.kind == kind; });
}

/// A sheet between two straight curves, `stretch` times as far apart as it is long.
DesignBuilder sheetBetween(double stretch)
{
    DesignBuilder b(14);
    const ElementId patch = b.patch(rectangle(300, 200), b.fabric(0.3, 8));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {300, 0, 0}}));
    b.fix({patch, 2, 3}, polyline({{300, 200 * stretch, 0}, {0, 200 * stretch, 0}}));
    return b;
}

TEST(CoverFindings, SamplesOfGoodQualityHaveNone)
{
    for (const char* name : {"armchair", "box-cushion", "car-seat", "cylinder", "pillow"}) {
        std::printf("%s\n", name);
        EXPECT_TRUE(findingsOf(sample(name)).empty()) << name;
    }
}

TEST(CoverFindings, ClothThatIsStretchedTooFarIsSaidWithWhereAndHowMuch)
{
    EXPECT_TRUE(findingsOf(sheetBetween(1.03).design()).empty()) << "fabrics may 8 %";
    const std::vector<CoverFinding> found = findingsOf(sheetBetween(1.6).design());
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].kind, FindingKind::OverLimit);
    EXPECT_NEAR(found[0].value, 60, 15);
    EXPECT_EQ(found[0].allowed, 8);
    ASSERT_TRUE(found[0].place);
    EXPECT_EQ(found[0].place->patch, found[0].element);
    EXPECT_NE(found[0].text.english().find("stretched by"), std::string::npos) << found[0].text.english();
}

TEST(CoverFindings, EachLimitThatIsExceededIsSaid)
{
    // Pulled along, across and askew at once, so that each is over its limit.
    Design design = sheetBetween(1.6).design();
    Edit edit;
    design.each<Fabric>([&](ElementId id, Fabric fabric) {
        fabric.limits = {1, 0.1, 0.1};
        edit.changes.push_back({id, nullptr, makeElement(std::move(fabric))});
    });
    std::set<std::string> said;
    for (const CoverFinding& finding : findingsOf(design.with(edit)))
        if (finding.kind == FindingKind::OverLimit)
            said.insert(finding.text.key);
    EXPECT_GE(said.size(), 2U) << "stretched and sheared";
}

TEST(CoverFindings, ACornerOfCoarseTrianglesIsNoWorry)
{
    DesignBuilder b(25);
    const ElementId patch = b.patch(rectangle(300, 200), b.fabric(0.3, 8));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {300, 0, 0}}));
    b.fix({patch, 2, 3}, polyline({{300, 200, 0}, {0, 200, 0}}));
    const SolveResult result = solveResting({b.design(), {}}, {});
    ASSERT_TRUE(result.surface);
    const auto withMoved = [&](const Vec2& middle, double radius, const Vec3& by) {
        SurfaceMesh moved = *result.surface;
        int count = 0;
        for (std::size_t v = 0; v < moved.positions.size(); ++v)
            if ((moved.topology->pattern[v] - middle).norm() < radius) {
                moved.positions[v] += by;
                ++count;
            }
        EXPECT_GT(count, 0);
        FrameDistance frames;
        return coverFindings(moved, b.design(), {}, frames);
    };
    EXPECT_TRUE(withMoved({0, 0}, 1, {-20, -20, 0}).empty()) << "one or two triangles";
    EXPECT_FALSE(withMoved({150, 100}, 45, {0, 0, 30}).empty()) << "a bump";
}

TEST(CoverFindings, FoldsAreSaid)
{
    const std::vector<CoverFinding> found = findingsOf(sheetBetween(0.7).design());
    EXPECT_TRUE(has(found, FindingKind::Folds) || found.empty()) << "a sheet that hangs through does not fold";
    EXPECT_TRUE(has(findingsOf(sample("trapezoid")), FindingKind::Folds));
}

TEST(CoverFindings, WhatNothingHoldsIsSaidWhileSomethingIsHeld)
{
    DesignBuilder b = sheetBetween(1);
    const ElementId loose = b.patch(rectangle(100, 100), b.fabric(0.3, 8));
    const std::vector<CoverFinding> found = findingsOf(b.design());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, FindingKind::Free);
    EXPECT_EQ(found[0].element, loose);
    DesignBuilder alone(14);
    alone.patch(rectangle(100, 100), alone.fabric(0.3, 8));
    EXPECT_TRUE(findingsOf(alone.design()).empty()) << "a first patch is no mistake";
}

TEST(CoverFindings, ACurveThatHoldsTheClothOffTheFrameIsSaid)
{
    Design design = sheetBetween(1).design();
    const ElementId id = design.nextId();
    Frame frame;
    frame.file = "frame.obj";
    design = design.with({{}, {{id, nullptr, makeElement(frame)}}});
    const auto below = [&](double gap) {
        DesignFiles files;
        files.meshes[id] =
            std::make_shared<const TriangleMesh>(boxMesh(Box3(Vec3(-10, -10, -80 - gap), Vec3(310, 210, -gap))));
        return files;
    };
    EXPECT_TRUE(findingsOf(design, below(5)).empty());
    const std::vector<CoverFinding> found = findingsOf(design, below(120));
    ASSERT_EQ(found.size(), 2u) << "both curves";
    EXPECT_EQ(found[0].kind, FindingKind::OffFrame);
    EXPECT_NEAR(found[0].value, 120, 1);
    EXPECT_TRUE(design.find<FixationCurve>(found[0].element));

    Frame hidden = frame;
    hidden.hiddenParts = {"Box"};
    design = design.with({{}, {{id, design.element(id), makeElement(hidden)}}});
    EXPECT_TRUE(findingsOf(design, below(120)).empty()) << "a part that is hidden is not there";
}

TEST(CoverFindings, SeamsWithTooMuchEaseAreSaid)
{
    DesignBuilder b(14);
    const ElementId fabric = b.fabric(0.3, 8);
    const ElementId a = b.patch(rectangle(300, 200), fabric), other = b.patch(rectangle(330, 200), fabric);
    b.seam({a, 0, 1}, {other, 0, 1});
    EXPECT_TRUE(has(findingsOf(b.design()), FindingKind::Ease));
}

} // namespace
} // namespace bolster::test
