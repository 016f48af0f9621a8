// The parts of one iteration.
#include "Convergence.h"
#include "FactoredSystem.h"
#include "FrameSigns.h"
#include "LocalStep.h"
#include "PreparedSheet.h"
#include "SheetKernels.h"
#include "TestDesigns.h"
#include "UnionFind.h"
#include "WorkerPool.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <thread>

namespace bolster {
namespace {

Eigen::Vector4d randomQuaternion(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    return Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random)).normalized();
}

TEST(LocalStep, FindsTheRotationInTheHemisphereOfThePreviousFrame)
{
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector4d q = randomQuaternion(random);
        Eigen::Vector4d previous = randomQuaternion(random);
        const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity() * 50;
        const LocalFit fit = fitVertex(rotationOf(q).leftCols<2>() * rest, rest, 0.01, previous, 0);
        EXPECT_GE(fit.frame.dot(previous), 0);
        EXPECT_NEAR(std::abs(fit.frame.dot(q)), 1, 1e-6);
    }
}

TEST(LocalStep, TargetStretchIsThatOfPlaneStress)
{
    const Eigen::Vector4d identity(1, 0, 0, 0);
    Eigen::Matrix<double, 3, 2> gradient;
    gradient << 1.1, 0, 0, 1.02, 0, 0;
    const LocalFit fit = fitVertex(gradient * 50, Eigen::Matrix2d::Identity() * 50, 0, identity, 0.3);
    EXPECT_NEAR(fit.stretch(0, 0), 1 - 0.3 * 0.02, 1e-9);
    EXPECT_NEAR(fit.stretch(1, 1), 1 - 0.3 * 0.1, 1e-9);
}

TEST(LocalStep, CollapsedRingKeepsItsFrame)
{
    std::mt19937 random(2);
    const Eigen::Vector4d q = randomQuaternion(random);
    const LocalFit fit = fitVertex(Eigen::Matrix<double, 3, 2>::Zero(), Eigen::Matrix2d::Identity(), 1, q, 0.3);
    EXPECT_NEAR(fit.frame.dot(q), 1, 1e-12);
}

TEST(LocalStep, HalfTurnsAreFoundToo)
{
    const Eigen::Vector4d previous(1, 0, 0, 0);
    const Eigen::Matrix3d halfTurn = rotationOf(Eigen::Vector4d(0, 1, 0, 0));
    const Eigen::Matrix2d rest = Eigen::Matrix2d::Identity();
    const LocalFit fit = fitVertex(halfTurn.leftCols<2>(), rest, 0, previous, 0);
    EXPECT_TRUE(rotationOf(fit.frame).isApprox(halfTurn, 1e-9));
}

/// However large or small the triangles are: most of the arithmetic begins in single precision.
TEST(SheetKernels, FitFramesLikeTheLocalStepOfOneVertex)
{
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet = prepareSheet(test::tube(200, 100, 20, 10), cache);
    ASSERT_TRUE(sheet);
    WorkerPool pool(2);
    for (const double scale : {1e-8, 1e-5, 1e-3, 1.0, 1e3, 3e3, 1e4, 1e6}) {
        SewnMesh mesh = sheet->mesh;
        auto topology = std::make_shared<SurfaceTopology>(*mesh.topology);
        for (Vec2& rest : topology->pattern)
            rest *= scale;
        mesh.topology = topology;
        for (double& area : mesh.area)
            area *= scale * scale;
        SheetRings rings;
        rings.measure(mesh, pool);
        const int count = mesh.vertexCount();
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(-1, 1);
        Columns positions = Columns::Zero(4, mesh.unknownCount()), frames(4, count), fitted(4, count);
        Eigen::Matrix4Xf turns(4, count), stretch(4, count);
        for (int u = 0; u < mesh.unknownCount(); ++u)
            positions.col(u).head<3>() = 30 * scale * Vec3(unit(random), unit(random), unit(random));
        std::vector<int> slots(count);
        for (int v = 0; v < count; ++v) {
            frames.col(v) = randomQuaternion(random);
            slots[v] = v;
        }
        SheetResults to;
        to.turnSlots = slots.data();
        to.turns = turns.data();
        to.stretch = stretch.data();
        to.fitted = fitted.data();
        fitFrames(rings, positions, frames, 0.3, 1, 0, count, to);
        for (int v = 0; v < count; ++v) {
            Eigen::Matrix<double, 3, 2> covariance = Eigen::Matrix<double, 3, 2>::Zero();
            Eigen::Matrix2d rest = Eigen::Matrix2d::Zero();
            const auto position = [&](int w) -> Vec3 { return positions.col(mesh.topology->unknown[w]).head<3>(); };
            for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k) {
                const SewnMesh::RingEdge& edge = mesh.ring[k];
                const Vec2 there = mesh.along(v, edge);
                covariance += edge.weight * (position(edge.vertex) - position(v)) * there.transpose();
                rest += edge.weight * there * there.transpose();
            }
            const LocalFit fit = fitVertex(covariance, rest, mesh.area[v], frames.col(v), 0.3);
            ASSERT_LT((fitted.col(v) / mesh.area[v] - fit.frame).norm(), 1e-3) << scale << " vertex " << v;
            ASSERT_NEAR(stretch(0, v), fit.stretch(0, 0) - 1, 1e-3) << scale << " vertex " << v;
            ASSERT_NEAR(stretch(1, v), fit.stretch(0, 1), 1e-3) << scale << " vertex " << v;
            ASSERT_NEAR(stretch(2, v), fit.stretch(1, 1) - 1, 1e-3) << scale << " vertex " << v;
        }
    }
}

Eigen::SparseMatrix<double> chain(int n, double diagonal)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) {
        entries.emplace_back(i, i, diagonal);
        if (i > 0)
            entries.emplace_back(i, i - 1, -1);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

TEST(FrameSigns, AgreeInEachPatchAndKeepTheirRotations)
{
    const Design design = test::tube(200, 100, 20, 10);
    TriangulationCache cache;
    const std::optional<PreparedSheet> sheet = prepareSheet(design, cache);
    ASSERT_TRUE(sheet);
    const SewnMesh& mesh = sheet->mesh;
    std::mt19937 random(3);
    Eigen::Matrix4Xd frames(4, mesh.vertexCount()); // bent by 300 degrees from side to side
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double half = mesh.rest()[v].x() / 200 * 300 * EIGEN_PI / 360;
        frames.col(v) = Eigen::Vector4d(std::cos(half), 0, std::sin(half), 0) * (random() % 2 ? 1 : -1);
    }
    const Eigen::Matrix4Xd before = frames;
    WorkerPool pool(2);
    alignSigns(mesh, pool, frames);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_EQ(frames.col(v).cwiseAbs(), before.col(v).cwiseAbs());
        for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
            EXPECT_GT(frames.col(v).dot(frames.col(mesh.ring[k].vertex)), 0);
    }
    const Eigen::Matrix4Xd aligned = frames;
    alignSigns(mesh, pool, frames);
    EXPECT_EQ(frames, aligned);
}

Eigen::Matrix3Xd line(int points)
{
    Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, points);
    places.row(0).setLinSpaced(points, 0, points);
    return places;
}

/// The Laplacian of a grid plus a little of the identity, its lower triangle, and where its points lie.
struct Grid {
    Eigen::SparseMatrix<double> matrix;
    Eigen::Matrix3Xd places;

    Grid(int columns, int rows)
        : matrix(columns * rows, columns * rows)
        , places(3, columns * rows)
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < columns * rows; ++i) {
            const int x = i % columns, y = i / columns;
            places.col(i) = Vec3(x, y, 0.01 * x * y);
            entries.emplace_back(i, i, 4.1);
            if (x > 0)
                entries.emplace_back(i, i - 1, -1);
            if (y > 0)
                entries.emplace_back(i, i - columns, -1);
        }
        matrix.setFromTriplets(entries.begin(), entries.end());
    }
};

WorkerPool onePool(1);

Eigen::Matrix4Xf solution(FactoredSystem& system, const Eigen::MatrixXd& right, int threads)
{
    WorkerPool pool(threads);
    PackedFactor::Workspace x = system.x();
    for (int i = 0; i < right.cols(); ++i)
        x.col(system.slots()[i]) = right.col(i).cast<float>();
    system.solve(pool);
    Eigen::Matrix4Xf result(4, right.cols());
    for (int i = 0; i < right.cols(); ++i)
        result.col(i) = x.col(system.slots()[i]);
    return result;
}

double error(const Eigen::SparseMatrix<double>& matrix, const Eigen::Matrix4Xf& x, const Eigen::MatrixXd& right)
{
    const Eigen::MatrixXd product = matrix.selfadjointView<Eigen::Lower>() * x.transpose().cast<double>();
    return (product.transpose() - right).norm() / right.norm();
}

TEST(FactoredSystem, IsNotFactoredWhenStopped)
{
    const Grid grid(40, 33);
    std::stop_source source;
    source.request_stop();
    FactoredSystem unordered(grid.matrix, grid.places, source.get_token());
    EXPECT_FALSE(unordered.factor(grid.matrix, onePool)) << "it has no order";
    FactoredSystem ordered(grid.matrix, grid.places);
    EXPECT_FALSE(ordered.factor(grid.matrix, onePool, source.get_token()));
    EXPECT_TRUE(ordered.factor(grid.matrix, onePool));
}

TEST(FactoredSystem, SolvesGridsOfAnySize)
{
    for (const auto& [columns, rows] : {std::pair(1, 1), {3, 1}, {1, 50}, {7, 5}, {40, 33}, {90, 70}}) {
        const Grid grid(columns, rows);
        FactoredSystem system(grid.matrix, grid.places);
        ASSERT_TRUE(system.factor(grid.matrix, onePool));
        const Eigen::MatrixXd right = Eigen::MatrixXd::Random(4, columns * rows);
        const Eigen::Matrix4Xf x = solution(system, right, 1);
        EXPECT_LT(error(grid.matrix, x, right), 1e-5) << columns << " x " << rows;
        for (const int threads : {2, 3})
            EXPECT_EQ(solution(system, right, threads), x) << "bit for bit";
    }
}

TEST(FactoredSystem, SolvesWhatDoesNotHangTogether)
{
    Eigen::SparseMatrix<double> matrix(1000, 1000);
    matrix.setIdentity();
    FactoredSystem system(matrix, line(1000));
    ASSERT_TRUE(system.factor(matrix, onePool));
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(4, 1000);
    EXPECT_LT(error(matrix, solution(system, right, 2), right), 1e-6);
}

TEST(FactoredSystem, TakesOtherNumbers)
{
    const Grid grid(30, 20);
    FactoredSystem system(grid.matrix, grid.places);
    ASSERT_TRUE(system.factor(grid.matrix, onePool));
    const Eigen::SparseMatrix<double> other = 3 * grid.matrix;
    ASSERT_TRUE(system.factor(other, onePool));
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(4, 600);
    EXPECT_LT(error(other, solution(system, right, 1), right), 1e-5);
}

TEST(FactoredSystem, NoticesWhatCannotBeSolved)
{
    FactoredSystem system(chain(50, 3), line(50));
    EXPECT_FALSE(system.ok());
    for (const double diagonal :
         {std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(system.factor(chain(50, diagonal), onePool)) << diagonal;
    EXPECT_TRUE(system.factor(chain(50, 3), onePool));
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_FALSE(system.factor(chain(50, 3), onePool, stopped.get_token()));
}

/// Deep and broad fronts, whose dense parts go other ways through the code than those of meshes.
TEST(FactoredSystem, FactorsDenseMatrices)
{
    for (const int n : {1, 4, 47, 48, 49, 130}) {
        Eigen::MatrixXd full = Eigen::MatrixXd::Random(n, n);
        full = (full * full.transpose() + Eigen::MatrixXd::Identity(n, n)).eval();
        const Eigen::SparseMatrix<double> matrix =
            Eigen::MatrixXd(full.triangularView<Eigen::Lower>()).sparseView();
        FactoredSystem system(matrix, line(n));
        ASSERT_TRUE(system.factor(matrix, onePool));
        const Eigen::MatrixXd right = Eigen::MatrixXd::Random(4, n);
        EXPECT_LT(error(matrix, solution(system, right, 2), right), 1e-4) << n;
    }
}

/// Threads that come late to a region meet the next one, which may have more tasks.
TEST(WorkerPool, DoesEveryTaskOnceInShortRegions)
{
    WorkerPool pool(4);
    std::array<int, 16> done{};
    for (int round = 0; round < 20000; ++round) {
        const int count = 2 + 7 * round % 13;
        done.fill(0);
        pool.forTasks(count, [&](int task) { ++done[static_cast<std::size_t>(task)]; });
        for (int task = 0; task < std::ssize(done); ++task)
            ASSERT_EQ(done[static_cast<std::size_t>(task)], task < count ? 1 : 0) << round;
    }
}

TEST(WorkerPool, UsesNoMoreThreadsThanAsked)
{
    WorkerPool pool(4);
    for (int round = 0; round < 2000; ++round) {
        pool.use(round % 5); // 0 is 1
        std::array<std::thread::id, 16> by;
        pool.forTasks(16, [&](int task) { by[static_cast<std::size_t>(task)] = std::this_thread::get_id(); });
        EXPECT_EQ(std::ranges::count(by, std::thread::id()), 0) << "each is done";
        EXPECT_LE(std::ssize(std::set(by.begin(), by.end())), std::max(1, round % 5));
    }
    pool.use(100);
    EXPECT_EQ(pool.threads(), 4);
}

TEST(WorkerPool, PassesOnWhatABodyThrows)
{
    WorkerPool pool(2);
    for (int round = 0; round < 50; ++round) {
        std::atomic<int> done = 0;
        EXPECT_THROW(pool.forTasks(8,
                                   [&](int task) {
                                       ++done;
                                       if (task % 3 == 1)
                                           throw std::bad_alloc();
                                   }),
                     std::bad_alloc);
        EXPECT_EQ(done, 8);
        pool.forTasks(4, [&](int) { ++done; });
        EXPECT_EQ(done, 12) << "it goes on working";
    }
}

TEST(Convergence, IsNotDeceivedBySlowMoves)
{
    Convergence slow(1e-5);
    double move = 1e-5;
    for (int i = 0; i < 300; ++i)
        EXPECT_FALSE(slow.add(move *= 0.999)) << i; // a hundred times the move is still ahead
    Convergence quick(1e-5);
    move = 1e-2;
    int count = 0;
    while (!quick.add(move *= 0.7))
        ASSERT_LT(++count, 100);
    EXPECT_LT(move, 1e-5);
}

TEST(Convergence, DoesNotCompareMovesOfUnlikeIterations)
{
    Convergence circling(1e-5);
    for (int i = 0; i < 600; ++i)
        EXPECT_FALSE(circling.add(1e-3));
    circling.forget();
    for (int i = 0; i < 300; ++i)
        EXPECT_FALSE(circling.add(1e-6)) << i; // small, and hardly becoming smaller
}

TEST(Convergence, DriftingIsNoCircling)
{
    Convergence drifting(1e-9);
    for (int i = 0; i < 2000; ++i) {
        drifting.add(1e-6, std::numeric_limits<double>::infinity(), [] { return 200 * 1e-6; });
        EXPECT_FALSE(drifting.stalled()) << i;
    }
}

TEST(Convergence, NoticesCircling)
{
    Convergence circling(1e-5);
    bool stalled = false;
    for (int i = 0; i < 1000; ++i) {
        circling.add(1e-3);
        stalled = stalled || circling.stalled();
    }
    EXPECT_TRUE(stalled);
}

TEST(WorkerPool, RunsEveryChunkOnceOnAnyNumberOfThreads)
{
    for (int threads : {1, 2, 5}) {
        WorkerPool pool(threads);
        for (int round = 0; round < 200; ++round) {
            std::vector<int> hits(3 * WorkerPool::chunkSize + 7, 0);
            pool.forChunks(static_cast<int>(hits.size()), [&](int, int begin, int end) {
                for (int i = begin; i < end; ++i)
                    ++hits[i];
            });
            EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), std::ssize(hits));
        }
        pool.forChunks(0, [](int, int, int) { FAIL(); });
    }
}

TEST(UnionFind, LabelsByFirstAppearance)
{
    UnionFind sets(6);
    sets.join(4, 1);
    sets.join(5, 4);
    sets.join(0, 3);
    int count = 0;
    EXPECT_EQ(sets.labels(&count), (std::vector<int>{0, 1, 2, 0, 1, 1}));
    EXPECT_EQ(count, 3);
}

} // namespace
} // namespace bolster
