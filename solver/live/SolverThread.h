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
        Moving,    ///< iterating: the live surface during a gesture, else what will be the resting one
        Settled,   ///< it has converged
        Failed     ///< `reason` says why; the last good surface stays
    };

    /// What takes its time while a cover is prepared.
    enum class Stage {
        Triangles,      ///< checking, sampling, triangulating
        FewerTriangles, ///< a large cover comes to rest on these first
        Equations       ///< fields of cushions, factorising
    };

    State state = State::Idle;
    Stage stage = Stage::Triangles; ///< while preparing
    Message reason;
    ElementId culprit{}; ///< of a failure: the element that is most likely at fault; none: {}
    Problems problems;   ///< elements left out, and warnings
    int iterations = 0;  ///< since the last request
    double movement = 0; ///< last move relative to D
    double iterationsPerSecond = 0;
    bool resting = false; ///< the surface is the resting one, which follows from the design alone
    /// mm: after a gesture the resting surface lies this far from where the gesture had led, because cloth that is
    /// folded has several shapes.
    std::optional<double> sprang;
};

struct SolverOutput {
    /// Of the request that the surface answers. While a resting surface is being solved for, the one before.
    std::uint64_t designRevision = 0;
    int opening = 0;        ///< how often startAnew() had been called then
    SurfaceMeshPtr surface; ///< null: keep the last one
    SurfaceMeshPtr from;    ///< its triangles where the surface before was, when it differs visibly; else null
    SolverStatus status;
    SolveReport report;    ///< of the surface, when it has settled
    FieldPicturePtr field; ///< the forces that act on it; null: none, or not asked for
};

class RestingCache;
class SolverWorker;

/// Owns the worker. Not copyable; the destructor stops and joins.
class SolverThread {
public:
    /// `wake` is called on the worker when an output waits and none was waiting before. `kept`: of another thread,
    /// whose resting surfaces are found there and which gets those that are solved here; none: its own.
    explicit SolverThread(std::function<void()> wake, std::shared_ptr<RestingCache> kept = nullptr);
    ~SolverThread();
    SolverThread(const SolverThread&) = delete;
    SolverThread& operator=(const SolverThread&) = delete;

    /// Another design is opened: nothing of the surface before goes into the next one, and no answer about it
    /// comes any more.
    void startAnew() { ++m_opening; }
    /// Replaces a request that was not taken yet. What is being prepared for an earlier one is given up, unless
    /// more requests are to come soon: then nothing would ever be finished.
    /// `passing`: a gesture is running, the live surface follows it. Otherwise the answer is the resting surface.
    void request(SolveInput input, std::uint64_t designRevision, bool passing = false);
    /// Whether answers have a picture of the forces, as of the next one.
    void drawField(bool on);
    /// How long a step of a gesture should take, ms: large designs have fewer triangles then. As of the next one.
    void setStepBudget(double ms);
    /// The newest output, once.
    std::optional<SolverOutput> take();
    const std::shared_ptr<RestingCache>& kept() const;

private:
    int m_opening = 0;
    std::unique_ptr<SolverWorker> m_worker;
    std::jthread m_thread; // last, so that it ends first
};

} // namespace bolster
