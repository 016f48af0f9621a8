// Patterns that follow a goal.
#include "PatternFit.h"
#include "WarmCover.h" // before Qt, which has a macro "slots"

#include "DesignFile.h"
#include "FitChange.h"
#include "RestingSolve.h"
#include "RowModel.h"
#include "TestFreedoms.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bolster::test {
namespace {

constexpr double edge = 25; // mm, so that a fit takes a second

/// Outlines bent by up to about so many mm, smoothly, some control points outwards and some inwards.
Design bent(const Design& design, double most)
{
    const std::vector<Freedom> freedoms = outlineFreedoms(design);
    Eigen::VectorXd values(std::ssize(freedoms));
    for (Eigen::Index k = 0; k < values.size(); ++k)
        values[k] = most * std::sin(1 + 0.7 * static_cast<double>(k));
    return withFreedoms(design, freedoms, values);
}

FitTarget coverOf(const Design& design, const Vec3& shift = Vec3::Zero())
{
    const SolveResult result = solved(design, 1e-6);
    TriangleMesh mesh;
    for (const Vec3& place : result.surface->positions)
        mesh.points.push_back(place + shift);
    mesh.triangles = result.surface->topology->triangles;
    return targetOf(mesh);
}

struct Case {
    Design right;
    double bend; ///< mm
};

Case caseOf(const std::string& name)
{
    return name == "Cushion" ? Case{coarseSample("box-cushion", edge), 6} : Case{box(300, 90, 15, 8, 0.5), 8};
}

class PatternFitOf : public testing::TestWithParam<const char*> {
protected:
    const Case one = caseOf(GetParam());
    const Design& right = one.right;
    const Design wrong = bent(right, one.bend);

    FitOrder orderTo(const Design& goal) const
    {
        FitOrder order;
        order.goals.target = coverOf(goal);
        order.freedoms = outlineFreedoms(wrong);
        return order;
    }
};

TEST_P(PatternFitOf, BentOutlinesComeBackOntoTheirCover)
{
    const FitOrder order = orderTo(right);
    double share = 0;
    const FitResult result = fitPattern(wrong, order, [&](double done, const FitRound& round) {
        EXPECT_GE(done, share - 1e-9) << "progress goes on";
        EXPECT_LE(done, 1);
        EXPECT_GT(round.edgeLength, 0);
        share = done;
    });
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_GT(result.before.distanceRms, 1);
    EXPECT_LT(result.after.distanceRms, 0.3);
    EXPECT_LT(result.after.sewnMost, 0.3) << "of the seams' sides";
    EXPECT_GT(result.after.covered, 0.99);
    EXPECT_FALSE(result.jumped);
    EXPECT_TRUE(result.idle.empty());
    EXPECT_TRUE(result.design == withFreedoms(wrong, order.freedoms, result.values));
    EXPECT_LE(largestChange(order.freedoms, result.values), order.mostChange);
    // The cover of that design, as anybody would solve it, is there.
    FitOrder again = order;
    again.mostRounds = 0;
    const FitResult checked = fitPattern(result.design, again);
    EXPECT_NEAR(checked.before.distanceRms, result.after.distanceRms, 0.02);
    EXPECT_EQ(checked.status, FitResult::Status::NothingToDo);
}

TEST_P(PatternFitOf, TwiceIsTheSameOnAnyNumberOfThreads)
{
    FitOrder order = orderTo(right);
    order.mostRounds = 2;
    order.threads = 1;
    const FitResult one = fitPattern(wrong, order);
    order.threads = 3;
    const FitResult other = fitPattern(wrong, order);
    ASSERT_EQ(one.status, FitResult::Status::Done) << one.reason.english();
    EXPECT_TRUE(one.values == other.values);
    EXPECT_TRUE(one.design == other.design);
    EXPECT_EQ(one.after.distanceRms, other.after.distanceRms);
}

TEST_P(PatternFitOf, TheGreatestChangeIsKept)
{
    FitOrder order = orderTo(right);
    order.mostChange = one.bend / 3;
    const FitResult result = fitPattern(wrong, order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_LE(largestChange(order.freedoms, result.values), order.mostChange * (1 + 1e-6));
    wrong.each<Patch>([&](ElementId id, const Patch& before) {
        const std::vector<Vec2>& after = result.design.find<Patch>(id)->outline.points();
        for (std::size_t k = 0; k < after.size(); ++k)
            EXPECT_LE((after[k] - before.outline.points()[k]).norm(), order.mostChange * (1 + 1e-6));
    });
    EXPECT_LT(result.after.distanceRms, result.before.distanceRms);
}

TEST_P(PatternFitOf, StoppedIsAsItWas)
{
    const FitOrder order = orderTo(right);
    std::stop_source before;
    before.request_stop();
    std::stop_source amid;
    for (std::stop_source* stop : {&before, &amid}) {
        int reports = 0;
        const FitResult result = fitPattern(
            wrong, order,
            [&](double, const FitRound& round) {
                if (++reports > 0 && round.largestChange > 0)
                    amid.request_stop();
            },
            stop->get_token());
        EXPECT_EQ(result.status, FitResult::Status::Cancelled);
        EXPECT_TRUE(result.design == wrong);
        EXPECT_TRUE(result.values.isZero());
    }
}

/// On a seat steps are tried in vain, after which every worker's cover is elsewhere.
TEST(PatternFit, OfASeatIsTheSameOnAnyNumberOfThreads)
{
    const OpenedDesign opened = openDesign(QString::fromStdString(samplesFolder() + "/car-seat/car-seat.json"));
    const SolveInput wrong{withEdgeLength({bent(opened.design, 12), opened.files}, 60).design, opened.files};
    const SolveInput right{withEdgeLength({opened.design, opened.files}, 60).design, opened.files};
    FitOrder order;
    const SolveResult cover = solveResting(right, {});
    ASSERT_TRUE(cover.surface);
    TriangleMesh mesh;
    for (const Vec3& place : cover.surface->positions)
        mesh.points.push_back(place + Vec3(0, 6, 4));
    mesh.triangles = cover.surface->topology->triangles;
    order.goals.target = targetOf(mesh);
    order.freedoms = outlineFreedoms(wrong.design);
    std::vector<FitResult> results;
    for (const int threads : {1, 2, 3}) {
        order.threads = threads;
        results.push_back(fitPattern(wrong, order));
        ASSERT_EQ(results.back().status, FitResult::Status::Done) << results.back().reason.english();
        ASSERT_EQ(results.back().rounds.size(), results.front().rounds.size());
        for (std::size_t k = 0; k < results.front().rounds.size(); ++k)
            EXPECT_EQ(results.back().rounds[k].figures.distanceRms, results.front().rounds[k].figures.distanceRms)
                << "round " << k << " with " << threads << " threads";
        EXPECT_TRUE(results.back().values == results.front().values);
    }
}

INSTANTIATE_TEST_SUITE_P(Boxes, PatternFitOf, testing::Values("Cushion", "Small"));

/// Columns' products are carried on, not made anew.
TEST(RowModel, LearnsWhatAStepLedToAndNoMore)
{
    const Eigen::MatrixXd jacobian = Eigen::MatrixXd::Random(40, 7);
    const Eigen::VectorXd steps = Eigen::VectorXd::Random(7), off = Eigen::VectorXd::Random(40);
    RowModel model(jacobian);
    EXPECT_LT((model.squares() - jacobian.transpose() * jacobian).norm(), 1e-12);
    model.learn(steps, off);
    EXPECT_LT((model.jacobian() * steps - jacobian * steps - off).norm(), 1e-12);
    Eigen::VectorXd across = Eigen::VectorXd::Random(7);
    across -= across.dot(steps) / steps.squaredNorm() * steps;
    EXPECT_LT((model.jacobian() * across - jacobian * across).norm(), 1e-12);
    EXPECT_LT((model.squares() - model.jacobian().transpose() * model.jacobian()).norm(), 1e-11);
}

TEST(PatternFit, AFormFarAwayIsAFailureWithAReason)
{
    const Design design = coarseSample("box-cushion", edge);
    FitOrder order;
    order.goals.target = coverOf(design, Vec3(0, 0, 500));
    order.freedoms = outlineFreedoms(design);
    const FitResult result = fitPattern(design, order);
    EXPECT_EQ(result.status, FitResult::Status::Failed);
    EXPECT_NE(result.reason.english().find("near the form"), std::string::npos) << result.reason.english();
    EXPECT_TRUE(result.design == design);
}

TEST(PatternFit, NothingThatMayChangeIsAFailure)
{
    const Design design = coarseSample("box-cushion", edge);
    FitOrder order;
    order.goals.target = coverOf(design);
    EXPECT_EQ(fitPattern(design, order).status, FitResult::Status::Failed);
    // And what may change does nothing.
    order.freedoms = {
        {.kind = Freedom::Kind::Number, .element = ElementId{20}, .field = "stiffness", .name = "unused"}};
    const FitResult result = fitPattern(design, order);
    EXPECT_NE(result.status, FitResult::Status::Done);
    EXPECT_TRUE(result.design == design);
}

TEST(PatternFit, NamesWhatDoesNothing)
{
    const Design right = coarseSample("box-cushion", edge), wrong = bent(right, 5);
    FitOrder order;
    order.goals.target = coverOf(right);
    order.freedoms = outlineFreedoms(wrong);
    order.freedoms.push_back({.kind = Freedom::Kind::Number,
                              .element = ElementId{20},
                              .field = "stiffness",
                              .name = "stiffness of a fabric that nothing is made of",
                              .step = 0.1});
    order.mostRounds = 1;
    const FitResult result = fitPattern(wrong, order);
    EXPECT_EQ(result.idle, std::vector<std::string>{"stiffness of a fabric that nothing is made of"});
    EXPECT_EQ(result.values[result.values.size() - 1], 0);
}

TEST(PatternFit, WhatIsRightStays)
{
    const Design design = coarseSample("box-cushion", edge);
    FitOrder order;
    order.goals.target = coverOf(design);
    order.freedoms = outlineFreedoms(design);
    const FitResult result = fitPattern(design, order);
    EXPECT_LT(result.before.distanceRms, 0.2) << "what lies between the points of a form whose edges are sharp";
    EXPECT_LT(largestChange(order.freedoms, result.values), 1);
    EXPECT_LE(result.after.distanceRms, result.before.distanceRms);
}

TEST(PatternFit, OtherFreedomsAreFoundToo)
{
    const Design right = coarseSample("box-cushion", edge);
    const std::vector<Freedom> freedoms = pressureFreedoms(right);
    FitOrder order;
    order.goals.target = coverOf(right);
    order.freedoms = freedoms;
    order.locks.change = 1e-4;
    const Eigen::VectorXd off = Eigen::VectorXd::Constant(std::ssize(freedoms), 0.1);
    const FitResult result = fitPattern(withFreedoms(right, freedoms, off), order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_LT(result.after.distanceRms, 0.1 * result.before.distanceRms);
    for (const Freedom& freedom : freedoms)
        EXPECT_NEAR(result.design.find<Patch>(freedom.element)->pressure, 0.3, 0.02) << freedom.name;
}

/// A sheet that is too short for the curves it is fixed to.
TEST(PatternFit, StrainComesBelowItsLimit)
{
    DesignBuilder b(edge);
    const ElementId patch = b.patch(rectangle(300, 200), b.fabric(0.3, 5));
    b.fix({patch, 0, 1}, polyline({{0, 0, 0}, {300, 0, 0}}));
    b.fix({patch, 2, 3}, polyline({{300, 210, 0}, {0, 210, 0}}));
    FitOrder order;
    order.goals.strain = true;
    order.goals.limit = 2;
    order.goals.keepShape = FitGoals::lightly;
    order.freedoms = outlineFreedoms(b.design());
    const FitResult result = fitPattern(b.design(), order);
    ASSERT_EQ(result.status, FitResult::Status::Done) << result.reason.english();
    EXPECT_GT(result.before.overLimit, 0.9);
    EXPECT_LT(result.after.overLimit, 0.05);
    EXPECT_LT(result.after.shapeRms, 1);
    const double height = result.design.find<Patch>(patch)->outline.boundingBox().sizes().y();
    EXPECT_GT(height, 210 / 1.025);
    EXPECT_LT(height, 210) << "no more than need be";

    order.goals.limit = 20;
    const FitResult none = fitPattern(b.design(), order);
    EXPECT_EQ(none.status, FitResult::Status::NothingToDo) << "it is below that";
    EXPECT_TRUE(none.rounds.empty());
    EXPECT_EQ(none.design, b.design());
}

} // namespace
} // namespace bolster::test
