// Anderson's mixing on linear problems, of which everything is known.
#include "Mixing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bolster {
namespace {

/// Places that each plain move brings nearer to 0, by a share of the way that is different for each.
class Shrinking {
public:
    explicit Shrinking(int count, double slowest)
        : m_places(4, count)
        , m_shares(count)
    {
        for (int u = 0; u < count; ++u) {
            m_places.col(u) << 1, -2, 3, 0;
            m_shares[u] = static_cast<float>(slowest * std::pow(1 / slowest, static_cast<double>(u % 7) / 6));
        }
    }

    Eigen::Matrix4Xf moves() const { return -(m_places.array().rowwise() * m_shares.transpose().array()).matrix(); }
    void make(const Eigen::Matrix4Xf& moves) { m_places += moves; }
    double distance() const { return m_places.norm(); }
    const Eigen::Matrix4Xf& places() const { return m_places; }

private:
    Eigen::Matrix4Xf m_places;
    Eigen::VectorXf m_shares;
};

constexpr int unknowns = 3000; // several chunks

TEST(Mixing, NeedsFewStepsWhereMovesShrinkSlowly)
{
    WorkerPool pool(2);
    Shrinking plain(unknowns, 0.01), mixed(unknowns, 0.01);
    const double before = plain.distance();
    Mixing mixing;
    for (int i = 0; i < 60; ++i) {
        plain.make(plain.moves());
        Eigen::Matrix4Xf moves = mixed.moves();
        mixing.mix(1, pool, moves);
        EXPECT_FALSE(mixing.lost()) << i;
        mixed.make(moves);
    }
    EXPECT_GT(plain.distance(), 0.2 * before);
    EXPECT_LT(mixed.distance(), 1e-4 * before);
}

TEST(Mixing, KnowsHowFarItStillIs)
{
    WorkerPool pool(2);
    Shrinking problem(unknowns, 0.01);
    Mixing mixing;
    EXPECT_EQ(mixing.left(), std::numeric_limits<double>::infinity());
    int known = 0;
    for (int i = 0; i < 40; ++i) {
        const double error = problem.distance();
        Eigen::Matrix4Xf moves = problem.moves();
        mixing.mix(1, pool, moves);
        const double said = mixing.left() * moves.norm();
        problem.make(moves);
        if (i < 5) {
            EXPECT_TRUE(std::isinf(said)) << "nothing is known yet";
        }
        if (std::isinf(said))
            continue; // nor when it has begun anew
        ++known;
        EXPECT_GT(said, error / 5) << i;
        EXPECT_LT(said, 10 * error) << i;
    }
    EXPECT_GE(known, 10);
}

TEST(Mixing, TakesAShareOfThePlainMovesAtFirst)
{
    WorkerPool pool(1);
    Mixing mixing;
    Eigen::Matrix4Xf moves = Shrinking(10, 0.5).moves();
    const Eigen::Matrix4Xf half = 0.5F * moves;
    mixing.mix(0.5, pool, moves);
    EXPECT_EQ(moves, half);
}

TEST(Mixing, IsTheSameOnAnyNumberOfThreads)
{
    std::vector<Eigen::Matrix4Xf> ends;
    for (const int threads : {1, 2, 3}) {
        WorkerPool pool(threads);
        Shrinking problem(unknowns, 0.01);
        Mixing mixing;
        for (int i = 0; i < 20; ++i) {
            Eigen::Matrix4Xf moves = problem.moves();
            mixing.mix(1, pool, moves);
            problem.make(moves);
        }
        ends.push_back(problem.places());
    }
    EXPECT_EQ(ends[0], ends[1]);
    EXPECT_EQ(ends[0], ends[2]);
}

TEST(Mixing, SeesThatItLeadsNowhere)
{
    WorkerPool pool(1);
    Mixing mixing;
    const Eigen::Matrix4Xf always = Shrinking(10, 0.5).moves();
    for (int i = 0; i < 40; ++i) {
        Eigen::Matrix4Xf moves = always;
        mixing.mix(1, pool, moves);
        EXPECT_TRUE(moves.allFinite());
        EXPECT_FALSE(mixing.lost()) << i;
    }
    for (int i = 0; i < 30; ++i) {
        Eigen::Matrix4Xf moves = always;
        mixing.mix(1, pool, moves);
    }
    EXPECT_TRUE(mixing.lost()) << "moves that do not become less";

    mixing.forget();
    EXPECT_FALSE(mixing.lost());
    Eigen::Matrix4Xf moves = always;
    mixing.mix(1, pool, moves);
    moves = 11 * always;
    mixing.mix(1, pool, moves);
    EXPECT_TRUE(mixing.lost()) << "moves that become large";
}

TEST(Mixing, StandsStillWhereNothingMoves)
{
    WorkerPool pool(1);
    Mixing mixing;
    for (int i = 0; i < 10; ++i) {
        Eigen::Matrix4Xf moves = Eigen::Matrix4Xf::Zero(4, 10);
        mixing.mix(1, pool, moves);
        EXPECT_EQ(moves.norm(), 0);
    }
    EXPECT_EQ(mixing.left(), 0);
}

} // namespace
} // namespace bolster
