// A design goes in, surface meshes come out. Latest wins, nobody waits.
#pragma once

#include "FieldPicture.h"
#include "SolveInput.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

namespace bolster {

/// What the window's status bar says of the solver.
struct SolverStatus {
    enum class State {
        Idle,      ///< nothing to solve
        Preparing, ///< triangulating, factorising
        Moving,    ///< the live surface iterates
        Settled,   ///< the live surface has converged
        Failed     ///< `reason` says why; the last good surface stays
    };

    State state = State::Idle;
    Message reason;
    Problems problems;   ///< elements left out, and warnings
    int iterations = 0;  ///< since the last request
    double movement = 0; ///< last move relative to D
    double iterationsPerSecond = 0;
    bool resting = false;                  ///< the surface is the resting one (within the export tolerance)
    std::optional<double> restingDistance; ///< mm: the resting surface is known and differs; "Settle" is offered
};

struct SolverOutput {
    std::uint64_t designRevision = 0; ///< of the request that this answers
    int opening = 0;                  ///< how often startAnew() had been called then
    SurfaceMeshPtr surface;           ///< null: keep the last one
    SolverStatus status;
    SolveReport report;    ///< of the surface, when it has settled
    FieldPicturePtr field; ///< the forces that act on it; null: none, or not asked for
};

class SolverWorker;

/// Owns the worker. Not copyable; the destructor stops and joins.
class SolverThread {
public:
    /// `wake` is called on the worker when an output waits and none was waiting before.
    explicit SolverThread(std::function<void()> wake);
    ~SolverThread();
    SolverThread(const SolverThread&) = delete;
    SolverThread& operator=(const SolverThread&) = delete;

    /// Another design is opened: nothing of the surface before goes into the next one, and no answer about it
    /// comes any more.
    void startAnew() { ++m_opening; }
    /// Replaces a request that was not taken yet. What is being prepared for an earlier one is given up, unless
    /// more requests are to come soon (`passing`, during a drag): then nothing would ever be finished.
    void request(SolveInput input, std::uint64_t designRevision, bool passing = false);
    /// Makes the resting surface the live one as soon as it is known.
    void settle();
    /// Whether answers have a picture of the forces, as of the next one.
    void drawField(bool on);
    /// The newest output, once.
    std::optional<SolverOutput> take();

private:
    SolveInput m_input; // of the last request
    std::uint64_t m_revision = 0;
    int m_opening = 0;
    std::unique_ptr<SolverWorker> m_worker;
    std::jthread m_thread; // last, so that it ends first
};

} // namespace bolster
