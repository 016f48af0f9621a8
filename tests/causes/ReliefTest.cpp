// Changes that relieve strained cloth: what is proposed, and whether it holds.
#include "DesignCheck.h"
#include "DesignFile.h"
#include "ElementEdits.h"
#include "PointCloud.h"
#include "RankCorrelation.h"
#include "ReliefCandidates.h"
#include "RestingSolve.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace bolster::test {
namespace {

SolveInput boxInput(double edgeLength)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(samplesFolder() + "/box-cushion/box-cushion.json"));
    Settings settings = opened.design.settings();
    settings.edgeLength = edgeLength;
    return {opened.design.with({{}, {{settingsId, nullptr, makeElement(settings)}}}), opened.files};
}

ElementId seamOf(const Design& design, const std::string& a, const std::string& b)
{
    ElementId found = noElement;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (design.find<Patch>(seam.a.patch)->name == a && design.find<Patch>(seam.b.patch)->name == b)
            found = id;
    });
    EXPECT_NE(found, noElement) << a << ", " << b;
    return found;
}

CoverStrains solvedStrains(const SolveInput& input, double limit, SurfaceMeshPtr* surface = nullptr)
{
    const SolveResult result = solveResting(input, {});
    EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    if (surface)
        *surface = result.surface;
    return coverStrains(*result.surface->topology, result.surface->positions, input.design, limit);
}

TEST(Reliefs, WhatIsOverTheLimitIsAMeanOverTheArea)
{
    CoverStrains strains;
    strains.strains.resize(3, 2);
    strains.strains << 0.05, 0.01, -0.04, 0, 0, -0.02;
    strains.limits = Eigen::Matrix3Xd::Constant(3, 2, 0.02);
    strains.areas = Eigen::Vector2d(1, 3);
    const OverLimit over = overLimit(strains);
    EXPECT_NEAR(over.energy, (0.03 * 0.03 + 0.02 * 0.02) / 4, 1e-12) << "what is pressed together counts";
    EXPECT_NEAR(over.area, 0.25, 1e-12);
}

TEST(Reliefs, NothingIsProposedWhereNothingIsOverTheLimit)
{
    const ReliefList list = proposeReliefs(boxInput(25), {.limit = 90.0});
    EXPECT_TRUE(list.problem.empty());
    EXPECT_EQ(list.now.area, 0);
    EXPECT_TRUE(list.reliefs.empty());
}

TEST(Reliefs, TheBestOnesGainWhatIsPredicted)
{
    const SolveInput input = boxInput(25);
    const ReliefList list = proposeReliefs(input, {.limit = 1.0, .solved = 4});
    ASSERT_TRUE(list.problem.empty()) << list.problem.english();
    ASSERT_GE(list.reliefs.size(), 4u);
    std::set<ElementId> places;
    for (std::size_t k = 0; k < 4; ++k) {
        const Relief& relief = list.reliefs[k];
        ASSERT_TRUE(relief.solved) << relief.text.english();
        EXPECT_NEAR(relief.solved->energy, relief.predicted, 0.03 + 0.3 * relief.predicted)
            << relief.text.english();
        EXPECT_LE(relief.moved, 4 * 6) << relief.text.english();
        EXPECT_EQ(relief.shape > 0, relief.cover != nullptr) << relief.text.english();
        EXPECT_LT(relief.shape, 20) << relief.text.english();
        EXPECT_FALSE(hasErrors(checkDesign(input.design.with(relief.edit)))) << relief.text.english();
        places.insert(relief.element);
    }
    EXPECT_EQ(places.size(), 4u);
    const Relief& first = list.reliefs.front();
    EXPECT_GT(first.solved->energy, 0.02);
    const OverLimit after = overLimit(solvedStrains(input.design.with(first.edit), 1.0));
    EXPECT_NEAR(1 - after.energy / list.now.energy, first.solved->energy, 1e-9);
}

/// Edges may move farther than the cloth at their seams bears.
TEST(Reliefs, MakeNoSeamPucker)
{
    const SolveInput input = boxInput(25);
    const ReliefList list = proposeReliefs(input, {.limit = 1.0, .most = 40, .solved = 0});
    EXPECT_GE(list.reliefs.size(), 4u);
    for (const Relief& relief : list.reliefs) {
        const Design after = input.design.with(relief.edit);
        after.each<Seam>(
            [&](ElementId, const Seam& seam) { EXPECT_FALSE(puckers(after, seam)) << relief.text.english(); });
    }
}

/// What relieves strain may lead away from the built piece.
TEST(Reliefs, SayHowFarTheCoverWouldLieFromAScan)
{
    SolveInput input = boxInput(25);
    const SolveResult now = solveResting(input, {});
    ASSERT_TRUE(now.surface);
    Scan scan;
    scan.name = "Built";
    scan.file = "built.ply";
    scan.enabled = false;
    const Edit added = edits::addElement(input.design, makeElement(scan));
    input.design = input.design.with(added);
    auto cloud = std::make_shared<PointCloud>();
    cloud->points = now.surface->positions;
    input.files.clouds[added.changes.front().id] = cloud;
    const ReliefList list = proposeReliefs(input, {.limit = 1.0, .solved = 1});
    ASSERT_TRUE(list.problem.empty()) << list.problem.english();
    ASSERT_EQ(list.scans.size(), 1U);
    EXPECT_EQ(list.scans[0].name, "Built");
    EXPECT_LT(list.scans[0].figures.rms, 0.01);
    ASSERT_FALSE(list.reliefs.empty());
    ASSERT_EQ(list.reliefs[0].scans.size(), 1U);
    EXPECT_GT(list.reliefs[0].scans[0].figures.rms, 0.05 * list.reliefs[0].shape);
    EXPECT_LT(list.reliefs[0].scans[0].figures.rms, 1.5 * list.reliefs[0].shape);
}

TEST(Reliefs, WhatWasTakenInIsLetOut)
{
    const SolveInput sound = boxInput(25);
    const ElementId seam = seamOf(sound.design, "Top", "Front");
    const std::vector<ReliefMove> moves = reliefMoves(sound.design);
    const auto letOut = std::ranges::find_if(moves, [&](const ReliefMove& move) {
        return move.kind == Relief::Kind::LetOut && move.element == seam && move.names.front() == "Front";
    });
    ASSERT_NE(letOut, moves.end());
    EXPECT_EQ(reliefOf(sound.design, *letOut, 5).text.english(), "Let out Front by 5 mm where it is sewn to Top");
    EXPECT_EQ(reliefOf(sound.design, *letOut, -5).text.english(), "Take in Front by 5 mm where it is sewn to Top");
    const Design tight = withMove(sound.design, *letOut, -5);
    const ReliefList list = proposeReliefs({tight, sound.files}, {.limit = 1.0, .solved = 1});
    // A dart into the crowned top gains more still: under pressure most of that is over 1 % in any case.
    const auto first =
        std::ranges::find_if(list.reliefs, [](const Relief& relief) { return relief.kind != Relief::Kind::Dart; });
    ASSERT_NE(first, list.reliefs.end());
    EXPECT_TRUE(first->text.english().starts_with("Let out Front by ")) << first->text.english();
    const auto back = std::ranges::find_if(list.reliefs, [&](const Relief& relief) {
        return relief.element == seam && relief.text.english().starts_with("Let out Front by ");
    });
    ASSERT_NE(back, list.reliefs.end());
    EXPECT_GT(back->predicted, 0.03);
    EXPECT_NEAR(back->moved, 5, 2.5);
}

TEST(Reliefs, EaseMakesAnEdgeLonger)
{
    const SolveInput input = boxInput(25);
    for (const ReliefMove& move : reliefMoves(input.design))
        if (move.kind == Relief::Kind::Ease) {
            EXPECT_NEAR(reliefOf(input.design, move, 3).sewn, 3, 0.1);
        }
}

TEST(Reliefs, ADartRunsToWhereItIsWorst)
{
    const SolveInput input = boxInput(15);
    SurfaceMeshPtr surface;
    CoverStrains strains = solvedStrains(input, 1.0, &surface);
    // As if a single triangle in the middle of the first patch were strained.
    strains.strains.setZero();
    const SurfaceTopology& topology = *surface->topology;
    const Vec2 middle = input.design.find<Patch>(topology.patches.front().patch)->outline.boundingBox().center();
    std::uint32_t nearest = 0;
    for (std::uint32_t t = 0; t < topology.patches.front().triangleCount; ++t)
        if ((topology.pattern[topology.triangles[t][0]] - middle).norm() <
            (topology.pattern[topology.triangles[nearest][0]] - middle).norm())
            nearest = t;
    strains.strains(0, nearest) = 0.05;
    const std::vector<Relief> darts = dartReliefs(input.design, topology, strains);
    ASSERT_EQ(darts.size(), 2u) << "two widths";
    for (const Relief& dart : darts) {
        EXPECT_EQ(dart.element, topology.patches.front().patch);
        EXPECT_GT(dart.sewn, 30);
        const Design cut = input.design.with(dart.edit);
        EXPECT_FALSE(hasErrors(checkDesign(cut)));
        int before = 0, after = 0;
        input.design.each<Seam>([&](ElementId, const Seam&) { ++before; });
        cut.each<Seam>([&](ElementId, const Seam&) { ++after; });
        EXPECT_GT(after, before);
    }
}

TEST(Reliefs, RanksAreCompared)
{
    EXPECT_DOUBLE_EQ(rankCorrelation({1, 2, 3, 4}, {10, 20, 30, 40}), 1);
    EXPECT_DOUBLE_EQ(rankCorrelation({1, 2, 3, 4}, {4, 3, 2, 1}), -1);
}

} // namespace
} // namespace bolster::test
