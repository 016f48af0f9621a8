// Small changes of a design change its resting surface little: it does not jump to other folds.
#include "TestDesigns.h"

#include "CoverMove.h"
#include "CurveEdits.h"
#include "PatchEdits.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace bolster::test {
namespace {

constexpr double step = 3;  // mm
constexpr double most = 10; // mm: a jump to other folds moves cloth by 20 mm and more

template <class T>
ElementId oneOf(const Design& design, std::mt19937& random)
{
    std::vector<ElementId> all;
    design.each<T>([&](ElementId id, const T&) { all.push_back(id); });
    return all[random() % all.size()];
}

/// A direction of length `step`, from numbers that are the same everywhere.
template <int Dim>
Eigen::Matrix<double, Dim, 1> anyStep(std::mt19937& random)
{
    Eigen::Matrix<double, Dim, 1> direction;
    do
        for (Eigen::Index i = 0; i < Dim; ++i)
            direction[i] = static_cast<double>(random() % 2001) / 1000 - 1;
    while (direction.norm() < 0.1 || direction.norm() > 1);
    return step * direction.normalized();
}

Edit moveOfACurve(const Design& design, std::mt19937& random)
{
    const ElementId curve = oneOf<FixationCurve>(design, random);
    const auto points = static_cast<unsigned>(design.find<FixationCurve>(curve)->curve.pointCount());
    return edits::moveCurvePoints(design, curve, std::array{static_cast<int>(random() % points)},
                                  anyStep<3>(random));
}

Edit moveOfAnOutline(const Design& design, std::mt19937& random)
{
    const ElementId patch = oneOf<Patch>(design, random);
    const auto points = static_cast<unsigned>(design.find<Patch>(patch)->outline.pointCount());
    return edits::movePatchPoints(design, patch, std::array{static_cast<int>(random() % points)},
                                  anyStep<2>(random));
}

class RestingMoves : public testing::TestWithParam<const char*> {};

TEST_P(RestingMoves, OfOnePointMoveTheCoverLittle)
{
    const Design design = sample(GetParam());
    SolveOptions options;
    options.lenient = true;
    const SolveResult before = solveResting(design, options);
    ASSERT_EQ(before.status, SolveResult::Status::Solved);
    std::mt19937 random(1);
    for (int round = 0; round < 6; ++round) {
        const bool outline = round % 2 == 1;
        const Design moved = design.with(outline ? moveOfAnOutline(design, random) : moveOfACurve(design, random));
        const SolveResult after = solveResting(moved, options);
        ASSERT_EQ(after.status, SolveResult::Status::Solved) << round;
        const double distance = moveBetween(*before.surface, *after.surface).distance;
        std::printf("%s: %s moved by %.0f mm, cover by %.1f mm\n", GetParam(), outline ? "outline" : "curve", step,
                    distance);
        EXPECT_LT(distance, most) << round;
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, RestingMoves,
                         testing::Values("armchair", "box-cushion", "car-seat", "cylinder", "trapezoid"),
                         [](const auto& sampled) {
                             std::string name = sampled.param;
                             std::erase(name, '-');
                             return name;
                         });

} // namespace
} // namespace bolster::test
