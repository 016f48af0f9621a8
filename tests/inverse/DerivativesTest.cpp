// Derivatives of covers against differences of covers that were solved from their usual start.
#include "CoverTeam.h"

#include "CoverMove.h"
#include "TestFreedoms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace bolster::test {
namespace {

WarmOrder exactly(double edge)
{
    WarmOrder order;
    order.edgeLength = edge;
    order.tolerance = 1e-9;
    order.mostIterations = 20'000;
    return order;
}

const CoverMeasure places = [](const WarmCover& cover, const Design&) { return placesOf(cover); };

/// Numbers that leave the triangles as they are.
std::vector<Freedom> numbersOf(const Design& design)
{
    std::vector<Freedom> freedoms;
    for (const std::vector<Freedom>& some : {pressureFreedoms(design), fixationFreedoms(design)}) {
        const auto few = std::min<std::ptrdiff_t>(3, std::ssize(some));
        freedoms.insert(freedoms.end(), some.begin(), some.begin() + few);
    }
    freedoms.push_back({.kind = Freedom::Kind::Number,
                        .element = ElementId{1},
                        .field = "stiffness",
                        .name = "stiffness",
                        .step = 0.05});
    freedoms.push_back({.kind = Freedom::Kind::Number,
                        .element = ElementId{1},
                        .field = "poisson",
                        .name = "poisson",
                        .step = 0.02});
    freedoms.push_back({.kind = Freedom::Kind::Number,
                        .element = ElementId{1},
                        .field = "bending_length",
                        .name = "bending length",
                        .step = 0.5});
    return freedoms;
}

class DerivativesOf : public testing::TestWithParam<const char*> {};

TEST_P(DerivativesOf, AreDifferencesOfCoversSolvedByThemselves)
{
    const Design design = sample(GetParam());
    const std::vector<Freedom> freedoms = numbersOf(design);
    CoverTeam team(design, exactly(20), 0);
    ASSERT_TRUE(team.problem().empty());
    const Derivatives found = differentiate(team, design, freedoms, places, true);
    ASSERT_EQ(found.columns.cols(), std::ssize(freedoms));
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        SCOPED_TRACE(freedoms[k].name);
        ASSERT_TRUE(found.known[k]);
        const double step = freedoms[k].step;
        const WarmCover after(changedBy(design, freedoms[k], step), exactly(20)),
            before(changedBy(design, freedoms[k], -step), exactly(20));
        ASSERT_TRUE(after.problem().empty() && before.problem().empty());
        const Eigen::VectorXd expected = (placesOf(after) - placesOf(before)) / (2 * step);
        ASSERT_EQ(expected.size(), found.columns.rows()) << "the same triangles";
        const Eigen::VectorXd column = found.columns.col(static_cast<Eigen::Index>(k));
        std::cout << GetParam() << " " << freedoms[k].name << " " << expected.norm() << " "
                  << (column - expected).norm() / expected.norm() << "\n";
        EXPECT_LT((column - expected).norm(), 0.02 * expected.norm());
    }
}

/// Triangles differ when outlines move, so that what is compared is the cover as a whole: along its normals.
TEST_P(DerivativesOf, OfOutlinesLeadWhereCoversOfMovedOutlinesAre)
{
    const Design design = sample(GetParam());
    const std::vector<Freedom> all = outlineFreedoms(design);
    const std::vector<Freedom> freedoms{all[0], all[3], {.kind = Freedom::Kind::Offset, .element = ElementId{2}}};
    const double edge = 10;
    CoverTeam team(design, exactly(edge), 0);
    const Derivatives found = differentiate(team, design, freedoms, places, true);
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        ASSERT_TRUE(found.known[k]);
        const double step = 2;
        const Design changed = changedBy(design, freedoms[k], step);
        const SurfaceMeshPtr full = solved(withEdgeLength({changed, {}}, edge).design, 1e-8).surface;
        SurfaceMesh predicted = *team.first().surface();
        ASSERT_TRUE(team.first().follow(design));
        predicted = *team.first().surface();
        const SurfaceMesh still = predicted;
        for (std::size_t v = 0; v < predicted.positions.size(); ++v)
            predicted.positions[v] +=
                step *
                found.columns.col(static_cast<Eigen::Index>(k)).segment<3>(3 * predicted.topology->unknown[v]);
        const CoverMove off = moveBetween(predicted, *full), whole = moveBetween(still, *full);
        double offSquares = 0, wholeSquares = 0;
        for (std::size_t v = 0; v < full->positions.size(); ++v) {
            const Vec3 normal = full->normals[v].cast<double>();
            offSquares += off.from ? std::pow(normal.dot(full->positions[v] - off.from->positions[v]), 2) : 0;
            wholeSquares += std::pow(normal.dot(full->positions[v] - whole.from->positions[v]), 2);
        }
        std::cout << GetParam() << " " << freedoms[k].name << " " << std::sqrt(offSquares / wholeSquares) << " of "
                  << std::sqrt(wholeSquares / full->positions.size()) << "\n";
        EXPECT_LT(std::sqrt(offSquares), 0.1 * std::sqrt(wholeSquares)) << freedoms[k].name;
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, DerivativesOf, testing::Values("box-cushion", "pillow"), [](const auto& one) {
    std::string name = one.param;
    std::erase(name, '-');
    return name;
});

/// Of foam: where the cover begins to lie on it the way up is another than the way down, so that both are tried.
TEST(Derivatives, AreTheSameOnAnyNumberOfThreads)
{
    const Design design = sample("box-cushion");
    std::vector<Freedom> freedoms = numbersOf(design);
    const std::vector<Freedom> outlines = outlineFreedoms(design);
    freedoms.insert(freedoms.end(), outlines.begin(), outlines.begin() + 8);
    for (const bool central : {false, true}) {
        WarmOrder order;
        order.edgeLength = 25;
        CoverTeam one(design, order, 1), three(design, order, 3);
        const Derivatives a = differentiate(one, design, freedoms, places, central);
        const Derivatives b = differentiate(three, design, freedoms, places, central);
        EXPECT_TRUE(a.columns == b.columns);
        EXPECT_EQ(a.known, b.known);
    }
}

TEST(Derivatives, SayWhereThereIsNoCoverBeside)
{
    const Design design = sample("box-cushion");
    const std::vector<Freedom> freedoms{
        {.kind = Freedom::Kind::Number, .element = ElementId{2}, .field = "pressure", .step = 0.05},
        {.kind = Freedom::Kind::Number, .element = ElementId{1}, .field = "stiffness", .step = -2}};
    WarmOrder order;
    order.edgeLength = 25;
    CoverTeam team(design, order, 2);
    const Derivatives found = differentiate(team, design, freedoms, places, false);
    EXPECT_EQ(found.known, (std::vector<bool>{true, false})) << "a fabric cannot be softer than nothing";
    EXPECT_TRUE(found.columns.col(1).isZero());
    EXPECT_GT(found.columns.col(0).norm(), 1);
}

} // namespace
} // namespace bolster::test
