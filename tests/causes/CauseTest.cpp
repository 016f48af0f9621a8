// Pieces that were built otherwise than designed, and what is said of them.
#include "BuiltScan.h"
#include "CauseEvidence.h"
#include "DesignFile.h"
#include "SlippedOutline.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bolster::test {
namespace {

constexpr double edge = 20; // mm
constexpr double builtEdge = 17;

SolveInput sampleInput(const std::string& name)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(samplesFolder() + "/" + name + "/" + name + ".json"));
    EXPECT_TRUE(opened.readable);
    return {withoutTwins(opened.design), opened.files};
}

std::size_t causeOf(const std::vector<Cause>& causes, Cause::Kind kind, const std::string& name)
{
    for (std::size_t k = 0; k < causes.size(); ++k)
        if (causes[k].kind == kind && causes[k].name.find(name) != std::string::npos)
            return k;
    ADD_FAILURE() << "no cause of " << name;
    return 0;
}

/// One finder for all, since derivatives take the time.
class BoxTest : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        s_input = std::make_unique<SolveInput>(sampleInput("box-cushion"));
        s_finder = std::make_unique<CauseFinder>(*s_input, ExplainOrder{.edgeLength = edge});
        s_cover = std::make_unique<WarmCover>(*s_input, WarmOrder{.edgeLength = builtEdge});
    }
    static void TearDownTestSuite()
    {
        s_finder.reset();
        s_cover.reset();
        s_input.reset();
    }

    static Explanations explainBuilt(const Design& design)
    {
        EXPECT_TRUE(s_cover->follow(design)) << s_cover->problem().english();
        return s_finder->explain(scanOf(*s_cover->surface(), 5, 1, 7));
    }

    static void expectFound(Cause::Kind kind, const std::string& name, const Eigen::VectorXd& values, double within)
    {
        const std::size_t cause = causeOf(s_finder->causes(), kind, name);
        const Explanations found = explainBuilt(withCause(s_input->design, s_finder->causes()[cause], values));
        ASSERT_FALSE(found.ranked.empty());
        const Explanation& first = found.ranked.front();
        EXPECT_EQ(s_finder->causes()[first.cause].name, s_finder->causes()[cause].name);
        EXPECT_TRUE(first.solved);
        EXPECT_LT(found.none, 0.01);
        for (Eigen::Index k = 0; k < values.size(); ++k)
            EXPECT_NEAR(first.values[k], values[k], within) << k;
    }

    static std::unique_ptr<SolveInput> s_input;
    static std::unique_ptr<CauseFinder> s_finder;
    static std::unique_ptr<WarmCover> s_cover;
};

std::unique_ptr<SolveInput> BoxTest::s_input;
std::unique_ptr<CauseFinder> BoxTest::s_finder;
std::unique_ptr<WarmCover> BoxTest::s_cover;

TEST_F(BoxTest, AStretchedPieceIsFound)
{
    expectFound(Cause::Kind::Stretch, "Top", Eigen::VectorXd::Constant(1, 3), 0.5);
}

TEST_F(BoxTest, AWrongAllowanceIsFound)
{
    expectFound(Cause::Kind::Seam, "Top to Front", Eigen::VectorXd::Constant(1, 2.5), 0.6);
}

TEST_F(BoxTest, AFixationElsewhereIsFound)
{
    expectFound(Cause::Kind::Fixation, "", Eigen::Vector3d(4, 0, -6), 0.6);
}

TEST_F(BoxTest, OfASoundPieceNothingIsSaid)
{
    const Explanations found = explainBuilt(s_input->design);
    EXPECT_GT(found.covered, 0.8);
    EXPECT_LT(found.rms, 0.7) << "noise of 1 mm averages out";
    for (const Explanation& one : found.ranked)
        EXPECT_LT(one.share, 0.3) << s_finder->causes()[one.cause].name;
}

TEST_F(BoxTest, OfThePieceItselfSharesAreNumbers)
{
    const FitTarget itself = scanOf(*s_finder->nominal(), 5, 0, 1);
    for (const Explanation& one : s_finder->explain(itself, itself).ranked) {
        EXPECT_TRUE(std::isfinite(one.share)) << s_finder->causes()[one.cause].name;
        EXPECT_TRUE(std::isfinite(one.probability));
    }
}

/// Left and right are alike: what looks best is not much better than the next.
TEST_F(BoxTest, OfTwoThingsAtOnceNoOneIsSure)
{
    Design built = s_input->design;
    for (const char* piece : {"Left", "Right"})
        built = withCause(built, s_finder->causes()[causeOf(s_finder->causes(), Cause::Kind::Stretch, piece)],
                          Eigen::VectorXd::Constant(1, 4));
    const Explanations found = explainBuilt(built);
    ASSERT_GT(found.ranked.size(), 1u);
    const Explanation &first = found.ranked[0], &second = found.ranked[1];
    EXPECT_NEAR(first.share, second.share, 0.1);
    EXPECT_LT(first.share, 0.75);
    EXPECT_LT(first.probability, 0.9) << second.probability;
    EXPECT_GT(second.probability, 0.05);
}

TEST_F(BoxTest, WhoStopsItGetsNothing)
{
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(s_finder->explain(scanOf(*s_finder->nominal(), 5, 1, 1), {}, {}, stop.get_token()).ranked.empty());
}

TEST_F(BoxTest, AScanElsewhereShowsNothing)
{
    ASSERT_TRUE(s_cover->follow(s_input->design));
    FitTarget far = scanOf(*s_cover->surface(), 20, 0, 1);
    far.place.position = {0, 0, 5000};
    const Explanations found = s_finder->explain(far);
    EXPECT_EQ(found.covered, 0);
    EXPECT_TRUE(found.ranked.empty());
}

TEST(Causes, ThickerAndHarderFoamAreTwoCauses)
{
    const SolveInput input = sampleInput("trapezoid-cushion");
    CauseFinder finder(input, {.edgeLength = edge});
    WarmCover cover(input, {.edgeLength = builtEdge});
    const std::size_t thicker = causeOf(finder.causes(), Cause::Kind::Foam, "");
    for (const double by : {-10.0, 10.0}) {
        ASSERT_TRUE(
            cover.follow(withCause(input.design, finder.causes()[thicker], Eigen::VectorXd::Constant(1, by))));
        const Explanations found = finder.explain(scanOf(*cover.surface(), 5, 1, 3));
        EXPECT_TRUE(isFound(found, thicker)) << finder.causes()[found.ranked.front().cause].name;
    }
}

TEST(Causes, OneOfTwoTwinsMayBeWrong)
{
    const OpenedDesign opened =
        openDesign(QString::fromStdString(samplesFolder() + "/car-seat-cushioned/car-seat-cushioned.json"));
    withoutTwins(opened.design).each<Patch>([](ElementId, const Patch& patch) { EXPECT_FALSE(patch.twin); });
    const Design design = withoutTwins(opened.design);
    const std::vector<Cause> causes = possibleCauses(design);
    int patches = 0;
    design.each<Patch>([&](ElementId, const Patch&) { ++patches; });
    EXPECT_EQ(std::ranges::count(causes, Cause::Kind::Stretch, &Cause::kind), patches);
}

TEST(Causes, ASlippedOutlineKeepsItsShape)
{
    // A rectangle whose lower edge has points between its corners.
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k)
        points.emplace_back(50.0 * k, 0);
    points.insert(
        points.end(),
        {{600, 0}, {600, 100}, {600, 200}, {600, 300}, {400, 300}, {200, 300}, {0, 300}, {0, 200}, {0, 100}});
    const BSpline2 outline = BSpline2::withCorners(points, {0, 12, 15, 18});
    const BSpline2 slipped = slippedOutline(outline, 0, 12, 10);
    EXPECT_NEAR(slipped.at(6).x() - outline.at(6).x(), 10, 0.5);
    for (double t = 0; t < 21; t += 0.05) {
        EXPECT_NEAR(outline.closest(slipped.at(t)).distance, 0, 1e-6) << t;
        if (t >= 12) {
            EXPECT_NEAR((slipped.at(t) - outline.at(t)).norm(), 0, 1e-9) << t;
        }
    }
}

/// A field that one cause explains only with an amount that nobody makes, and another one nearly as well with a
/// usual one.
TEST(Causes, AmountsArePlausible)
{
    constexpr Eigen::Index rows = 200;
    CauseColumns columns{.field = Eigen::VectorXd::LinSpaced(rows, 1, 2), .up = {}, .down = {}, .first = {0, 1, 2}};
    columns.up.resize(rows, 2);
    columns.up.col(0) = columns.field / 30;
    columns.up.col(1) = columns.field + Eigen::VectorXd::LinSpaced(rows, 0, 30).array().sin().matrix() * 0.3;
    columns.down = -columns.up;
    const CauseEvidence evidence(columns, rows, 0.05);
    EXPECT_EQ(evidence.fit(0).numbers[0], 6);
    EXPECT_NEAR((evidence.fit(0).reached - columns.field / 5).norm(), 0, 1e-9);
    EXPECT_NEAR(evidence.fit(1).numbers[0], 1, 0.1);
    EXPECT_GT(evidence.fit(1).evidence, evidence.fit(0).evidence);
}

TEST(Causes, EvidenceCountsAgainstCausesThatCouldBeAnything)
{
    // The field is twice the first column; the second cause could make it, too, among much else.
    CauseColumns columns;
    columns.field = Eigen::VectorXd::Zero(100);
    columns.up = Eigen::MatrixXd::Zero(100, 4);
    for (int k = 0; k < 100; ++k) {
        columns.up(k, 0) = std::sin(0.1 * k);
        columns.field[k] = 2 * columns.up(k, 0) + 0.1 * std::sin(37.0 * k * k);
        columns.up(k, 1) = columns.up(k, 0);
        columns.up(k, 2) = std::cos(0.1 * k);
        columns.up(k, 3) = std::cos(0.2 * k);
    }
    columns.down = -columns.up;
    columns.first = {0, 1, 4};
    const CauseEvidence evidence(columns, 100, 0.01);
    EXPECT_NEAR(evidence.noise(), 0.07, 0.02);
    EXPECT_NEAR(evidence.fit(0).numbers[0], 2, 0.05);
    EXPECT_GT(evidence.fit(0).evidence, evidence.fit(1).evidence + 1);
    EXPECT_GT(evidence.likeness(1, columns.field)[0], 0.99);
    EXPECT_LT(evidence.likeness(0, columns.up.col(2))[0], 0.3);
}

} // namespace
} // namespace bolster::test
