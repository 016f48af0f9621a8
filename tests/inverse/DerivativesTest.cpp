// Derivatives of covers against differences of covers that were solved from their usual start.
#include "CoverTeam.h"

#include "CoverMove.h"
#include "DesignFile.h"
#include "TestFreedoms.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cmath>

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

double relative(const Eigen::VectorXd& off, const Eigen::VectorXd& whole)
{
    return off.norm() / whole.norm();
}

/// Against covers of the changed design, solved from their usual start on the same triangles.
void expectDerivatives(const SolveInput& input, const std::vector<Freedom>& freedoms, double edge)
{
    CoverTeam team(input, exactly(edge), 0);
    ASSERT_TRUE(team.problem().empty());
    const Derivatives found = differentiate(team, input.design, freedoms, places, true);
    ASSERT_EQ(found.columns.cols(), std::ssize(freedoms));
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        SCOPED_TRACE(freedoms[k].name);
        ASSERT_TRUE(found.known[k]);
        const double step = freedoms[k].step;
        const auto solvedAt = [&](double value) {
            const WarmCover cover({changedBy(input.design, freedoms[k], value), input.files}, exactly(edge));
            EXPECT_TRUE(cover.problem().empty());
            return placesOf(cover);
        };
        const Eigen::VectorXd expected = (solvedAt(step) - solvedAt(-step)) / (2 * step);
        ASSERT_EQ(expected.size(), found.columns.rows()) << "the same triangles";
        EXPECT_GT(step * expected.norm(), 0.1) << "mm: it does something";
        EXPECT_LT(relative(found.columns.col(static_cast<Eigen::Index>(k)) - expected, expected), 0.02);
    }
}

TEST(Derivatives, AreDifferencesOfCoversSolvedByThemselves)
{
    const Design cushion = sample("box-cushion"), cylinder = sample("cylinder");
    expectDerivatives(cushion, numbersOf(cushion), 20);
    std::vector<Freedom> loose = pressureFreedoms(cylinder);
    const std::vector<Freedom> rims = fixationFreedoms(cylinder);
    loose.insert(loose.end(), rims.begin(), rims.end());
    expectDerivatives(cylinder, loose, 20);
}

/// A sheet that lies on a padded cube.
TEST(Derivatives, OfFoamAndWhatLiesOnIt)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(samplesFolder() + "/trapezoid-cushion/trapezoid-cushion.json"));
    ASSERT_TRUE(opened.readable);
    std::vector<Freedom> freedoms = foamFreedoms(opened.design);
    ASSERT_EQ(freedoms.size(), 1u);
    freedoms.push_back({.kind = Freedom::Kind::Number,
                        .element = freedoms[0].element,
                        .field = "strength",
                        .name = "strength",
                        .step = 0.1});
    expectDerivatives({opened.design, opened.files}, freedoms, 20);
}

/// Triangles differ when outlines move, so that what is compared is the cover as a whole, along its normals.
TEST(Derivatives, OfOutlinesLeadWhereCoversOfMovedOutlinesAre)
{
    const Design design = withEdgeLength({sample("box-cushion"), {}}, 10).design;
    const std::vector<Freedom> points = outlineFreedoms(design);
    const std::vector<Freedom> freedoms{
        points[0],
        points[3],
        points[10],
        {.kind = Freedom::Kind::Offset, .element = ElementId{2}},
        {.kind = Freedom::Kind::Offset, .element = ElementId{3}, .from = 2, .to = 3},
        {.kind = Freedom::Kind::Size, .element = ElementId{2}, .step = 0.2}};
    CoverTeam team(design, exactly(0), 0);
    const SurfaceMesh still = *team.first().surface();
    const Derivatives found = differentiate(team, design, freedoms, places, true);
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        SCOPED_TRACE(k);
        ASSERT_TRUE(found.known[k]);
        const double value = 2 * freedoms[k].step;
        const SurfaceMeshPtr full = solved(changedBy(design, freedoms[k], value), 1e-8).surface;
        SurfaceMesh predicted = still;
        for (std::size_t v = 0; v < predicted.positions.size(); ++v)
            predicted.positions[v] +=
                value *
                found.columns.col(static_cast<Eigen::Index>(k)).segment<3>(3 * predicted.topology->unknown[v]);
        const auto heightsOver = [&](const SurfaceMesh& before) {
            const CoverMove move = moveBetween(before, *full);
            Eigen::VectorXd heights(std::ssize(full->positions));
            for (std::size_t v = 0; v < full->positions.size(); ++v)
                heights[static_cast<Eigen::Index>(v)] =
                    full->normals[v].cast<double>().dot(full->positions[v] - move.from->positions[v]);
            return heights;
        };
        EXPECT_LT(relative(heightsOver(predicted), heightsOver(still)), 0.02);
    }
}

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
