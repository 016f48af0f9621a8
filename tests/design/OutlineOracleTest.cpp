// The reader's B-splines against reference evaluations of real outlines.
#include "ArcLength.h"
#include "DesignCheck.h"

#include "TestData.h"

#include <nlohmann/json.hpp>

namespace bolster {
namespace {

class OutlineOracle : public testing::TestWithParam<const char*> {};

TEST_P(OutlineOracle, AgreesWithEverySample)
{
    const Design design = test::soundDesign(test::designText(GetParam()));
    const auto oracle = nlohmann::json::parse(test::designText(std::string(GetParam()) + ".samples"));
    std::size_t compared = 0;
    design.each<Patch>([&](ElementId, const Patch& patch) {
        SCOPED_TRACE(patch.name);
        ASSERT_TRUE(oracle.contains(patch.name));
        const auto& expected = oracle[patch.name];
        const BSpline2& outline = patch.outline;
        for (const auto& sample : expected["samples"]) {
            const Vec2 point(sample[1].get<double>(), sample[2].get<double>());
            EXPECT_LT((outline.at(sample[0]) - point).norm(), 0.002) << "t = " << sample[0];
        }
        EXPECT_EQ(outline.corners(), expected["corner_parameters"].get<std::vector<double>>());
        EXPECT_EQ(outline.period(), expected["period"].get<double>());
        EXPECT_EQ(outline.signedArea() > 0, expected["counter_clockwise"].get<bool>());
        // These two were taken from a polygon, which cuts the corners a little.
        const double area = expected["area_mm2"];
        const double length = expected["length_mm"];
        EXPECT_NEAR(std::abs(outline.signedArea()), area, 3e-4 * area);
        EXPECT_NEAR(ArcLength2(outline).total(), length, 6e-3 * length);
        EXPECT_GT(ArcLength2(outline).total(), length - 0.01);
        EXPECT_FALSE(selfIntersection(outline));
        ++compared;
    });
    EXPECT_EQ(compared, oracle.size());
}

TEST_P(OutlineOracle, DesignHasNoProblems)
{
    const Design design = test::soundDesign(test::designText(GetParam()));
    for (const Problem& problem : checkDesign(design))
        ADD_FAILURE() << problem.english();
}

INSTANTIATE_TEST_SUITE_P(Designs, OutlineOracle, testing::ValuesIn(test::designNames), [](const auto& parameter) {
    std::string name = parameter.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace
} // namespace bolster
