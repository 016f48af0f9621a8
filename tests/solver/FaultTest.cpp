// Memory that runs out, exceptions, numbers that are none, cancelling: a status each, and the solver goes on.
#include "FailingMemory.h"
#include "TestDesigns.h"

#include "PatchEdits.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "Sanitizer.h"
#include "SolverThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <random>
#include <semaphore>
#include <thread>

namespace bolster::test {
namespace {

#if defined(BOLSTER_THREAD_SANITIZER) || defined(BOLSTER_ADDRESS_SANITIZER)
constexpr int rounds = 100;
#else
constexpr int rounds = 1000;
#endif

Design cover(double size)
{
    return box(size, 60, 30, 10, 0.1);
}

TEST(Faults, SolvesThatRunOutOfMemorySaySo)
{
    const Design design = cover(200);
    SolveOptions options;
    options.threads = 2;
    constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
    std::int64_t all = 0;
    {
        const FailingMemory counted(never);
        EXPECT_EQ(solveResting(design, options).status, SolveResult::Status::Solved);
        all = counted.allocations();
    }
    std::mt19937_64 random(1);
    int failed = 0;
    for (int round = 0; round < rounds; ++round) {
        SolveResult result;
        {
            const FailingMemory failing(std::uniform_int_distribution<std::int64_t>(0, all - 1)(random));
            result = solveResting(design, options);
        }
        if (result.status == SolveResult::Status::Solved)
            continue; // allocations vary a little with the threads
        ++failed;
        ASSERT_EQ(result.status, SolveResult::Status::Failed);
        ASSERT_NE(result.reason.english().find("memory"), std::string::npos) << result.reason.english();
        ASSERT_FALSE(result.surface);
    }
    EXPECT_GT(failed, rounds / 2);
}

/// A solver thread that is asked one thing at a time.
class Asker {
public:
    /// Until the solver has nothing more to do for this design.
    SolverOutput ask(const Design& design, const std::function<bool(const SolverOutput&)>& answered)
    {
        m_solver.request(design, ++m_revision);
        for (;;) {
            if (!m_woken.try_acquire_for(std::chrono::seconds(60)))
                throw std::runtime_error("the solver does not answer");
            if (const auto output = m_solver.take();
                output && output->designRevision == m_revision && answered(*output))
                return *output;
        }
    }

private:
    std::uint64_t m_revision = 0;
    std::counting_semaphore<> m_woken{0};
    SolverThread m_solver{[this] { m_woken.release(); }};
};

bool settled(const SolverOutput& output)
{
    return output.status.state == SolverStatus::State::Failed ||
           (output.status.state == SolverStatus::State::Settled && output.status.resting);
}

TEST(Faults, TheSolverThreadOutlivesMemoryThatRunsOut)
{
    const Design good = cover(200);
    Asker asker;
    const SurfaceMeshPtr resting = asker.ask(good, settled).surface;
    ASSERT_TRUE(resting);
    std::mt19937_64 random(2);
    int failed = 0;
    for (int round = 0; round < rounds / 2; ++round) {
        const Design other = cover(200 + 40 * std::generate_canonical<double, 32>(random));
        SolverOutput output;
        {
            const FailingMemory failing(std::uniform_int_distribution<std::int64_t>(0, 6000)(random),
                                        std::this_thread::get_id());
            output = asker.ask(other, settled);
        }
        ASSERT_TRUE(output.surface) << "the last good one must stay";
        if (output.status.state == SolverStatus::State::Failed) {
            ++failed;
            ASSERT_NE(output.status.reason.english().find("memory"), std::string::npos);
        }
        if (round % 20 == 0) {
            const SolverOutput again = asker.ask(good, [](const SolverOutput& o) { return o.status.resting; });
            ASSERT_EQ(again.surface->positions, resting->positions);
        }
    }
    EXPECT_GT(failed, rounds / 10);
}

/// Solves, and asks to stop after `delay`.
SolveResult solveAndStop(const Design& design, std::chrono::microseconds delay)
{
    std::stop_source stop;
    if (delay.count() == 0)
        stop.request_stop();
    const std::jthread canceller([&] {
        std::this_thread::sleep_for(delay);
        stop.request_stop();
    });
    return solveResting(design, {}, stop.get_token());
}

TEST(Faults, SolvesCanBeCancelledAtAnyTime)
{
    using std::chrono::microseconds, std::chrono::steady_clock;
    const Design design = cover(200);
    const auto start = steady_clock::now();
    ASSERT_EQ(solveResting(design, {}).status, SolveResult::Status::Solved);
    const auto whole = std::chrono::duration_cast<microseconds>(steady_clock::now() - start).count();
    std::mt19937 random(3);
    int onTheWay = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto delay = round == 0 ? 0 : std::uniform_int_distribution<microseconds::rep>(0, whole)(random);
        const SolveResult result = solveAndStop(design, microseconds(delay));
        if (result.status == SolveResult::Status::Cancelled) {
            onTheWay += round > 0;
            ASSERT_FALSE(result.surface);
        } else {
            ASSERT_GT(delay, 0) << "it was asked before";
            ASSERT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
        }
    }
    EXPECT_GT(onTheWay, 0);
}

/// Pulls somewhere that is no place, or throws, from some iteration on.
class Faulty : public GhostSource {
public:
    enum class Fault { NotANumber, Huge, Exception };

    Faulty(Fault fault, int after)
        : m_fault(fault)
        , m_after(after)
    {}

    double gamma(const SewnMesh::Part&) const override { return 10; }
    void follow(const SheetMoment&, WorkerPool&) override { ++m_iteration; }
    void displace(const SheetMoment&, const SewnMesh::Part&, int begin, int end,
                  Columns& displacements) const override
    {
        displacements.middleCols(begin, end - begin).setZero();
        if (m_iteration <= m_after)
            return;
        if (m_fault == Fault::Exception)
            throw std::runtime_error("a fault");
        const double pull = m_fault == Fault::Huge ? 1e200 : std::numeric_limits<double>::quiet_NaN();
        displacements(begin % 3, begin) = pull;
    }

private:
    Fault m_fault;
    int m_after;
    int m_iteration = 0;
};

TEST(Faults, NumbersThatAreNoneEndASolveAndKeepTheStateBefore)
{
    TriangulationCache cache;
    const auto sheet = prepareSheet(cover(200), cache);
    WorkerPool pool(2);
    for (const auto fault : {Faulty::Fault::NotANumber, Faulty::Fault::Huge})
        for (int after = 0; after < 40; after += 3) {
            Ghosts ghosts;
            ghosts.push_back(std::make_unique<Faulty>(fault, after));
            Relaxation relaxation(sheet->mesh, pool, 1e-12, std::move(ghosts));
            relaxation.startCanonically();
            while (relaxation.phase() == Relaxation::Phase::Running)
                relaxation.iterate();
            EXPECT_EQ(relaxation.phase(), Relaxation::Phase::Failed);
            EXPECT_NE(relaxation.reason().english().find("ran away"), std::string::npos);
            EXPECT_TRUE(relaxation.state().positions.allFinite());
        }
}

TEST(Faults, ExceptionsReachTheCaller)
{
    TriangulationCache cache;
    const auto sheet = prepareSheet(cover(200), cache);
    WorkerPool pool(3);
    for (int after = 1; after < 10; ++after) {
        Ghosts ghosts;
        ghosts.push_back(std::make_unique<Faulty>(Faulty::Fault::Exception, after));
        Relaxation relaxation(sheet->mesh, pool, 1e-12, std::move(ghosts));
        relaxation.startCanonically();
        EXPECT_THROW(
            {
                for (int i = 0; i < 20; ++i)
                    relaxation.iterate();
            },
            std::runtime_error);
    }
}

/// Nothing ties the vertices of such a sheet to each other.
TEST(Faults, SingularSystemsAreRefused)
{
    TriangulationCache cache;
    const auto sheet = prepareSheet(cover(200), cache);
    WorkerPool pool(2);
    for (const float weight :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0F}) {
        SewnMesh mesh = sheet->mesh;
        for (SewnMesh::RingEdge& edge : mesh.ring)
            edge.weight = weight;
        Relaxation relaxation(mesh, pool, 1e-6);
        EXPECT_EQ(relaxation.phase(), Relaxation::Phase::Failed);
        relaxation.startCanonically();
        relaxation.iterate();
        EXPECT_EQ(relaxation.phase(), Relaxation::Phase::Failed);
        EXPECT_FALSE(relaxation.reason().english().empty());
    }
}

} // namespace
} // namespace bolster::test
