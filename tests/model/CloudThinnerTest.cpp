// What becomes of scans with more points than are kept.
#include "CloudThinner.h"
#include "CloudImport.h"
#include "CloudReaders.h"
#include "ReaderFuzz.h"
#include "TestFiles.h"

#include <array>
#include <cmath>
#include <random>
#include <set>

namespace bolster {
namespace {

constexpr std::size_t most = 2000;

/// A bent sheet of 1 m, measured in order of its rows, or anywhere.
std::vector<Vec3> sheet(std::size_t count, bool inOrder)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 1000);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double y = inOrder ? 1000 * static_cast<double>(i) / static_cast<double>(count) : anywhere(random);
        const double x = anywhere(random);
        points.emplace_back(x, y, 50 * std::sin(x / 200));
    }
    return points;
}

PointCloud thinned(const std::vector<Vec3>& points)
{
    CloudThinner thinner(most, {});
    for (const Vec3& point : points)
        thinner.add(point);
    return thinner.take();
}

std::array<double, 3> cubeOf(const Vec3& point, double edge)
{
    return {std::floor(point.x() / edge), std::floor(point.y() / edge), std::floor(point.z() / edge)};
}

TEST(CloudThinner, LeavesSmallCloudsAsTheyAre)
{
    std::vector<Vec3> points = sheet(most - 2, false);
    points.push_back(points.front());
    points.emplace_back(1e-300, -0.0, 1e7);
    const PointCloud cloud = thinned(points);
    EXPECT_EQ(cloud.points, points);
    EXPECT_EQ(cloud.thinnedFrom, 0u);
    EXPECT_EQ(cloud.spacing, 0);
}

TEST(CloudThinner, KeepsTheFirstPointOfEachCubeOfTheGrid)
{
    for (const bool inOrder : {true, false}) {
        for (const std::size_t count : {most + 1, 2 * most, 30 * most}) {
            const std::vector<Vec3> points = sheet(count, inOrder);
            const PointCloud cloud = thinned(points);
            EXPECT_EQ(cloud.thinnedFrom, count);
            ASSERT_GT(cloud.spacing, 0);
            ASSERT_LE(cloud.points.size(), most);
            EXPECT_GT(cloud.points.size(), most / 6) << "not much more is given up than must be";
            std::set<std::array<double, 3>> cubes;
            std::vector<Vec3> first;
            for (const Vec3& point : points)
                if (cubes.insert(cubeOf(point, cloud.spacing)).second)
                    first.push_back(point);
            EXPECT_EQ(cloud.points, first) << count;
            EXPECT_EQ(thinned(points).points, cloud.points) << "the same again";
        }
    }
}

TEST(CloudThinner, ManyPointsAtOnePlaceAreOne)
{
    std::vector<Vec3> points(3 * most, Vec3(1, 2, 3));
    EXPECT_EQ(thinned(points).points, std::vector<Vec3>(1, Vec3(1, 2, 3)));
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].x() = 1e7 - 1e-9 * static_cast<double>(i);
    EXPECT_LE(thinned(points).points.size(), most);
}

TEST(CloudThinner, Stops)
{
    std::stop_source stop;
    CloudThinner thinner(most, {stop.get_token(), {}});
    const std::vector<Vec3> points = sheet(most, false);
    for (const Vec3& point : points)
        thinner.add(point);
    stop.request_stop();
    EXPECT_THROW(thinner.add({1, 2, 3}), ImportStopped);
}

class CloudWatchTest : public TestFiles {};

TEST_F(CloudWatchTest, SaysHowFarItIsAndStopsWhenToldTo)
{
    std::string text;
    for (int i = 0; i < 300'000; ++i)
        text += std::to_string(i) + " 1.5 2.5\n";
    const QString file = write("a.xyz", text);
    std::vector<double> steps;
    const ImportedCloud whole = importCloud(file, {{}, [&](double done) { steps.push_back(done); }});
    ASSERT_TRUE(whole.cloud);
    EXPECT_EQ(whole.cloud->points.size(), 300'000u);
    EXPECT_GE(steps.size(), 3u);
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
    EXPECT_GE(steps.front(), 0);
    EXPECT_LE(steps.back(), 1);

    std::stop_source stop;
    std::size_t seen = 0;
    const ImportedCloud stopped = importCloud(file, {stop.get_token(), [&](double) {
                                                         if (++seen == 2)
                                                             stop.request_stop();
                                                     }});
    EXPECT_FALSE(stopped.cloud);
    EXPECT_TRUE(stopped.problem.empty()) << "whoever stopped it knows";
    EXPECT_EQ(seen, 2u);
}

/// On a busy machine even a piece of a file takes its time.
TEST_F(CloudWatchTest, StopsWithinWhatIsReadAtOnce)
{
    std::string text;
    for (int i = 0; i < 50'000; ++i)
        text += std::to_string(i) + " 0 0\n";
    std::stop_source stop;
    const auto read = [&](std::uint64_t at, char* to, std::size_t count) {
        text.copy(to, count, at);
        stop.request_stop(); // asked when nothing more will be read
        return true;
    };
    EXPECT_THROW(readXyz(FileBytes(read, text.size(), {stop.get_token(), {}}, text.size())), ImportStopped);
}

TEST_F(CloudWatchTest, LinesMayBeLongerThanWhatIsReadAtOnce)
{
    const std::string text =
        "1 2 3" + std::string(3'000'000, ' ') + "# far away\n4 5 6\r\n" + std::string(2'000'000, '\n');
    const ImportedCloud cloud = importCloud(write("a.xyz", text));
    ASSERT_TRUE(cloud.cloud) << cloud.problem.english();
    EXPECT_EQ(cloud.cloud->points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
    const ImportedCloud refused = importCloud(write("b.xyz", "1 2 3\n" + std::string(40'000'000, ' ')));
    EXPECT_EQ(refused.problem.english(), "b.xyz:2: the line is too long");
}

} // namespace
} // namespace bolster
