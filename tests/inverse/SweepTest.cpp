// Tolerances: what is drawn, what is solved, and what is reckoned.
#include "Sweep.h"

#include "TestFreedoms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace bolster::test {
namespace {

Tolerances tolerancesOf(const Design& design)
{
    Tolerances tolerances;
    const auto add = [&](std::vector<Tolerance> more) {
        tolerances.all.insert(tolerances.all.end(), more.begin(), more.end());
    };
    add(cutTolerances(design, 1));
    add(seamTolerances(design, 1));
    add(fixationTolerances(design, 1));
    add(stiffnessTolerances(design, 10));
    add(sizeTolerances(design, 0.2));
    return tolerances;
}

void expectSame(const SweepSample& a, const SweepSample& b)
{
    EXPECT_EQ(a.number, b.number);
    EXPECT_EQ(a.outside, b.outside) << a.number;
    EXPECT_EQ(a.rms, b.rms);
    EXPECT_EQ(a.p95, b.p95);
    EXPECT_EQ(a.most, b.most);
    EXPECT_EQ(a.strain, b.strain);
}

/// What 95 % of the pieces do not exceed, when there are few of them.
TEST(Sweep, OfFewPiecesTheWorstOneCounts)
{
    const auto p95Of = [](int count) {
        std::vector<SweepSample> samples(static_cast<std::size_t>(count));
        std::vector<const SweepSample*> all;
        for (int k = 0; k < count; ++k) {
            samples[static_cast<std::size_t>(k)].outside = {static_cast<float>(k % 2 ? k + 1 : -k - 1)};
            all.push_back(&samples[static_cast<std::size_t>(k)]);
        }
        return solvedP95(all).front();
    };
    EXPECT_EQ(p95Of(1), 1);
    EXPECT_EQ(p95Of(12), 12);
    EXPECT_EQ(p95Of(20), 19);
    EXPECT_EQ(p95Of(1000), 950);
}

TEST(Sweep, SamplesAreTheSameInPortionsAndOnAnyNumberOfThreads)
{
    const Design design = coarseSample("box-cushion", 30);
    const Tolerances tolerances = tolerancesOf(design);
    Sweep whole(design, tolerances, 2), parts(design, tolerances, 3);
    ASSERT_TRUE(whole.problem().empty()) << whole.problem().english();
    const std::vector<SweepSample> all = whole.solve(0, 40);
    ASSERT_EQ(all.size(), 40u);
    std::vector<SweepSample> pieces(40);
    for (const auto& [first, count] : {std::pair(33, 7), std::pair(0, 1), std::pair(13, 20), std::pair(1, 12)})
        std::ranges::move(parts.solve(static_cast<std::uint64_t>(first), count), pieces.begin() + first);
    for (std::size_t k = 0; k < all.size(); ++k) {
        EXPECT_EQ(all[k].number, k);
        EXPECT_EQ(all[k].outside.size(), whole.nominal()->positions.size());
        EXPECT_GT(all[k].rms, 0.01);
        expectSame(all[k], pieces[k]);
    }
    Sweep alone(design, tolerances, 1);
    expectSame(alone.solve(17, 1).front(), all[17]);
    EXPECT_TRUE(whole.linear() == alone.linear());
}

TEST(Sweep, FiguresOfASampleAreThoseOfItsVertices)
{
    const Design design = coarseSample("box-cushion", 30);
    Sweep sweep(design, tolerancesOf(design), 2);
    const SweepSample sample = sweep.solve(5, 1).front();
    std::vector<double> sizes(sample.outside.begin(), sample.outside.end());
    std::ranges::transform(sizes, sizes.begin(), [](double v) { return std::abs(v); });
    std::ranges::sort(sizes);
    EXPECT_EQ(sample.most, sizes.back());
    EXPECT_NEAR(sample.rms,
                std::sqrt(std::inner_product(sizes.begin(), sizes.end(), sizes.begin(), 0.0) /
                          static_cast<double>(sizes.size())),
                1e-9);
    const auto within = std::ranges::count_if(sizes, [&](double v) { return v <= sample.p95; });
    EXPECT_NEAR(static_cast<double>(within), 0.95 * static_cast<double>(sizes.size()), 2);
    EXPECT_GT(sample.strain, 0);
}

TEST(Sweep, LinearFiguresAreNearSolvedOnes)
{
    const Design design = coarseSample("pillow", 20);
    Tolerances tolerances;
    tolerances.all = cutTolerances(design, 1);
    for (const Tolerance& more : stiffnessTolerances(design, 10))
        tolerances.all.push_back(more);
    Sweep sweep(design, tolerances, 2);
    ASSERT_TRUE(sweep.problem().empty()) << sweep.problem().english();
    constexpr int count = 200;
    const std::vector<SweepSample> samples = sweep.solve(0, count);
    std::vector<const SweepSample*> resting;
    for (const SweepSample& sample : samples)
        if (!sample.outside.empty())
            resting.push_back(&sample);
    ASSERT_EQ(resting.size(), samples.size());
    const std::vector<float> reckoned = linearP95(sweep.linear(), tolerances, count).map,
                             found = solvedP95(resting);
    ASSERT_EQ(reckoned.size(), found.size());
    const auto rms = [](const std::vector<float>& map) {
        return std::sqrt(std::inner_product(map.begin(), map.end(), map.begin(), 0.0) /
                         static_cast<double>(map.size()));
    };
    EXPECT_NEAR(rms(reckoned), rms(found), 0.1 * rms(found));
}

TEST(Sweep, SolvedPiecesCorrectLinearOnes)
{
    Tolerances tolerances;
    tolerances.all = {Tolerance{{}, 1, "a"}, Tolerance{{}, 1, "b"}};
    const Eigen::MatrixXf linear = (Eigen::MatrixXf(3, 4) << 1, -1, 0, 0, 0, 0, 2, -2, 1, -1, 1, -1).finished();
    const LinearP95 reckoned = linearP95(linear, tolerances, 10'000);
    const std::vector<float>& many = reckoned.map;
    EXPECT_NEAR(many[0], 0.95, 0.01);
    EXPECT_NEAR(many[1], 1.9, 0.02);
    std::vector<SweepSample> solved;
    std::vector<const SweepSample*> all;
    for (std::uint64_t number = 0; number < 64; ++number)
        solved.push_back(linearSample(linear, tolerances, number));
    for (const SweepSample& sample : solved)
        all.push_back(&sample);
    const std::vector<float> same = correctedP95(reckoned, linear, tolerances, all).map;
    for (std::size_t v = 0; v < many.size(); ++v)
        EXPECT_NEAR(same[v], many[v], 1e-5) << "as linear as they were thought to be";
    for (SweepSample& sample : solved)
        sample.outside[1] *= 1.5F;
    const CorrectedP95 corrected = correctedP95(reckoned, linear, tolerances, all);
    EXPECT_NEAR(corrected.map[0], many[0], 1e-5);
    EXPECT_NEAR(corrected.map[1], 1.5 * many[1], 0.15) << "what 64 pieces leave to chance is half of it";
    EXPECT_TRUE(corrected.rmsError);
    EXPECT_EQ(correctedP95(reckoned, linear, tolerances, {}).map, many);
    EXPECT_FALSE(correctedP95(reckoned, linear, tolerances, {all.begin(), all.begin() + 15}).rmsError);
}

/// Covers that are far from linear, of several tolerances at several places.
TEST(Sweep, SaysHowSureAFewSolvedPiecesAre)
{
    Tolerances tolerances;
    Eigen::MatrixXf linear(8, 8);
    for (int k = 0; k < 4; ++k) {
        tolerances.all.push_back({{}, 1, std::string(1, static_cast<char>('a' + k))});
        for (int v = 0; v < 8; ++v) {
            linear(v, 2 * k) = static_cast<float>(std::cos(1 + 3 * k + v)) / static_cast<float>(1 + k);
            linear(v, 2 * k + 1) = -linear(v, 2 * k);
        }
    }
    const LinearP95 reckoned = linearP95(linear, tolerances, 10'000);
    const auto solvedFrom = [&](std::uint64_t first, std::uint64_t count) {
        std::vector<SweepSample> pieces;
        for (std::uint64_t number = first; number < first + count; ++number) {
            pieces.push_back(linearSample(linear, tolerances, number));
            for (float& value : pieces.back().outside)
                value += 0.6F * value * std::abs(value); // cloth that comes free
        }
        return pieces;
    };
    const auto correctedBy = [&](const std::vector<SweepSample>& pieces) {
        std::vector<const SweepSample*> all;
        for (const SweepSample& piece : pieces)
            all.push_back(&piece);
        return correctedP95(reckoned, linear, tolerances, all);
    };
    const double truth = rmsOf(correctedBy(solvedFrom(0, 4000)).map);
    for (const int count : {20, 60, 200}) {
        constexpr int draws = 100;
        int within = 0;
        double errors = 0;
        for (int draw = 0; draw < draws; ++draw) {
            const CorrectedP95 corrected = correctedBy(
                solvedFrom(10'000 + static_cast<std::uint64_t>(draw * count), static_cast<std::uint64_t>(count)));
            ASSERT_TRUE(corrected.rmsError);
            within += std::abs(rmsOf(corrected.map) - truth) <= *corrected.rmsError;
            errors += *corrected.rmsError / draws;
        }
        EXPECT_GE(within, 85) << count;
        EXPECT_LT(errors, 0.3 * truth) << count << ": it says something";
    }
}

TEST(Sweep, SharesOfFewPiecesAreUnsure)
{
    const auto [least, most] = shareOfMany(13, 30); // Wilson 1927
    EXPECT_NEAR(least, 0.274, 0.001);
    EXPECT_NEAR(most, 0.608, 0.001);
    EXPECT_EQ(shareOfMany(0, 30)[0], 0);
    EXPECT_NEAR(shareOfMany(0, 30)[1], 0.1135, 0.001);
    EXPECT_EQ(shareOfMany(30, 30)[1], 1);
}

TEST(Sweep, InfluencesAreSharesAndFindWhatMatters)
{
    const Design design = coarseSample("box-cushion", 30);
    Tolerances tolerances;
    tolerances.all = cutTolerances(design, 1);
    const std::vector<Tolerance> little = fixationTolerances(design, 1e-3);
    tolerances.all.insert(tolerances.all.end(), little.begin(), little.end());
    Sweep sweep(design, tolerances, 2);
    const Eigen::MatrixXf linear = sweep.linear();
    ASSERT_EQ(linear.cols(), 2 * std::ssize(tolerances.all));
    const std::vector<double> areas(sweep.nominal()->positions.size(), 1);
    const std::vector<double> shares = influences(linear, tolerances, areas);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-9);
    EXPECT_EQ(std::ranges::max_element(shares) - shares.begin(), 0) << "the top is the largest piece";
    for (std::size_t k = shares.size() - little.size(); k < shares.size(); ++k)
        EXPECT_LT(shares[k], 1e-4);
}

TEST(Sweep, SaysWhyThereIsNoCover)
{
    DesignBuilder b(10);
    Sweep sweep(b.design(), {}, 1);
    EXPECT_FALSE(sweep.problem().empty());
    EXPECT_FALSE(sweep.nominal());
}

TEST(Sweep, EndsWhenStopped)
{
    const Design design = coarseSample("box-cushion", 30);
    Sweep sweep(design, tolerancesOf(design), 2);
    std::stop_source stop;
    stop.request_stop();
    for (const SweepSample& sample : sweep.solve(0, 4, stop.get_token()))
        EXPECT_TRUE(sample.outside.empty());
    EXPECT_GT(sweep.solve(0, 1).front().rms, 0) << "and can go on";
}

TEST(Tolerances, SamplesFollowFromTheirNumberAndTheSeed)
{
    const Design design = sample("box-cushion");
    Tolerances tolerances = tolerancesOf(design);
    const Eigen::VectorXd seventh = sampleOf(tolerances, 7);
    sampleOf(tolerances, 8);
    EXPECT_TRUE(sampleOf(tolerances, 7) == seventh);
    EXPECT_FALSE(sampleOf(tolerances, 8) == seventh);
    tolerances.seed = 2;
    EXPECT_FALSE(sampleOf(tolerances, 7) == seventh);
    Tolerances fewer = tolerances;
    fewer.all.resize(3);
    EXPECT_TRUE(sampleOf(fewer, 7) == sampleOf(tolerances, 7).head(3)) << "more tolerances do not change the first";
}

/// Moments of `count` samples of one number, and how two of them go together.
struct Moments {
    double mean = 0, deviation = 0, most = 0, correlation = 0;
};

Moments momentsOf(const Tolerances& tolerances, int count)
{
    Eigen::MatrixXd values(2, count);
    for (int s = 0; s < count; ++s)
        values.col(s) = sampleOf(tolerances, static_cast<std::uint64_t>(s));
    const Eigen::VectorXd mean = values.rowwise().mean();
    const Eigen::MatrixXd off = values.colwise() - mean;
    const Eigen::Matrix2d covariance = off * off.transpose() / count;
    return {mean[0], std::sqrt(covariance(0, 0)), values.row(0).cwiseAbs().maxCoeff(),
            covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1))};
}

TEST(Tolerances, AreDrawnAsTheyAreSpread)
{
    Tolerances tolerances;
    tolerances.all = {Tolerance{{}, 3, "a"}, Tolerance{{}, 1, "b"}};
    constexpr int count = 20'000;
    const Moments uniform = momentsOf(tolerances, count);
    EXPECT_NEAR(uniform.mean, 0, 0.05);
    EXPECT_NEAR(uniform.deviation, 3 / std::sqrt(3), 0.03);
    EXPECT_LE(uniform.most, 3);
    EXPECT_GT(uniform.most, 2.99);
    EXPECT_NEAR(uniform.correlation, 0, 0.03);
    tolerances.normal = true;
    const Moments normal = momentsOf(tolerances, count);
    EXPECT_NEAR(normal.mean, 0, 0.03);
    EXPECT_NEAR(normal.deviation, 1, 0.02) << "the spread is three of them";
    EXPECT_GT(normal.most, 3);
    EXPECT_LT(normal.most, 6);
    EXPECT_NEAR(normal.correlation, 0, 0.03);
}

TEST(Tolerances, FoamGrowsByWholeVoxels)
{
    const Design design = sample("car-seat-cushioned");
    Tolerances tolerances;
    tolerances.all = foamTolerances(design, 10);
    ASSERT_EQ(tolerances.all.size(), 1u);
    ElementId cushion{};
    design.each<Cushion>([&](ElementId id, const Cushion&) { cushion = id; });
    const double voxel = design.find<Cushion>(cushion)->voxel;
    std::set<double> dilations;
    for (std::uint64_t s = 0; s < 100; ++s)
        dilations.insert(
            sampleDesign(design, tolerances, sampleOf(tolerances, s)).find<Cushion>(cushion)->dilation);
    std::set<double> expected;
    for (int k = -2; k <= 2; ++k)
        expected.insert(design.find<Cushion>(cushion)->dilation + k * voxel);
    EXPECT_EQ(voxel, 5);
    EXPECT_EQ(dilations, expected);
}

TEST(Tolerances, SamplesOfADesignAreThatMuchElsewhere)
{
    const Design design = sample("box-cushion");
    Tolerances tolerances;
    tolerances.all = stiffnessTolerances(design, 10);
    Eigen::VectorXd values = Eigen::VectorXd::Constant(std::ssize(tolerances.all), 10);
    EXPECT_NEAR(sampleDesign(design, tolerances, values).find<Fabric>(ElementId{1})->stiffness, 1.1, 1e-12);
    tolerances.all = seamTolerances(design, 1);
    ASSERT_EQ(tolerances.all.size(), 8u);
    values = Eigen::VectorXd::Zero(8);
    values[0] = 1; // top to front
    const Design changed = sampleDesign(design, tolerances, values);
    EXPECT_EQ(changed.find<Patch>(ElementId{2})->outline.boundingBox().sizes(), Vec2(500, 501));
    EXPECT_EQ(changed.find<Patch>(ElementId{3})->outline.boundingBox().sizes(), Vec2(500, 101));
    EXPECT_TRUE(*changed.find<Patch>(ElementId{5}) == *design.find<Patch>(ElementId{5}));
}

} // namespace
} // namespace bolster::test
