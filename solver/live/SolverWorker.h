// What runs on the solver thread: follows gestures with a live surface, and finds the resting surface of any other
// design.
#pragma once

#include "Mailbox.h"
#include "MakeGhosts.h"
#include "PatternWarp.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
#include "RestingCache.h"
#include "SolveFailure.h"
#include "SolvePlan.h"
#include "SolverThread.h"
#include "Stopwatch.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

namespace bolster {

class SolverWorker {
public:
    struct Request {
        SolveInput input;
        std::uint64_t revision = 0;
        bool passing = false; ///< a gesture is running: others follow at once
        int opening = 0;      ///< different for designs that have nothing to do with each other
    };

    /// `wake` is called when an output waits and none was waiting before. `kept` as in SolverThread.
    SolverWorker(std::function<void()> wake, std::shared_ptr<RestingCache> kept);

    /// From another thread.
    void request(Request request);
    /// From another thread, as of the next answer.
    void drawField(bool on) { m_drawsField = on; }
    void setStepBudget(double ms) { m_stepBudget = ms; }
    Mailbox<SolverOutput>& out() { return m_out; }
    const std::shared_ptr<RestingCache>& kept() const { return m_kept; }
    /// Until stopped.
    void run(std::stop_token stop);

private:
    static constexpr double liveTolerance = 1e-5; // relative to D

    /// A cover with its solver state.
    struct Sheet {
        PreparedSheet prepared;
        std::unique_ptr<Relaxation> relaxation;
        std::optional<PatternWarp> warp; ///< once outlines have been dragged
        bool stale = false;              ///< its samples belong to curves as they were before a drag
        bool standsIn = false;           ///< for one with more triangles, as long as a gesture is running
        bool alone = false;              ///< none can stand in for it

        int vertices() const { return prepared.mesh.vertexCount(); }
    };

    std::optional<Request> takeRequest();
    static bool running(const Sheet& sheet);
    bool step();
    void begin(Request request);
    void forgetAll();
    std::unique_ptr<Sheet> prepare(const SolveInput& input, TriangulationCache& triangulations);
    bool factor(Sheet& sheet, double tolerance);
    std::unique_ptr<Sheet> makeSheet(const SolveInput& input, double tolerance);
    Ghosts ghostsFor(const PreparedSheet& sheet, Problems& problems);

    // The live surface, while a gesture is running.
    void beginLive(Request request);
    bool startLive(const SolveInput& input);
    bool republishLive(const Design& design);
    bool retargetLive(const SolveInput& input, SolvePlan plan);
    bool rebuildLive(const SolveInput& input, bool torn);
    void iterateLive();
    void endLive();

    // Fewer triangles for the live surface of a large design.
    bool tooLarge(const Sheet& sheet) const;
    double standInEdge(const Sheet& sheet) const;
    double standInVertices() const;
    std::unique_ptr<Sheet> makeStandIn(const SolveInput& input, double edge);
    std::unique_ptr<Sheet> makeLive(const SolveInput& input);
    bool standIn();
    bool prepareStandIn();
    void learnStepTime();

    // The resting surface.
    void beginRest(Request request);
    bool restsAlready(const SolveInput& input);
    void showKept(RestingSurfacePtr kept, const SolveInput& input, bool atOnce);
    bool continueKept();
    void keepResting();
    void startResting(const SolveInput& input, bool afterGesture);
    std::unique_ptr<Sheet> sheetAtStart(const SolveInput& input, bool afterGesture);
    void showCoarse(const Sheet& sheet, const SheetState& coarse);
    void showOnNewTriangles(const Sheet& sheet);
    void iterateResting();
    void endResting();
    void adoptResting();
    void restEmpty();
    void beAtRest();
    double strandedDistance(double distance) const;

    void failBy(const std::exception& error);
    void fail(SolveFailure failure);
    void failIn(const Sheet& sheet);
    SurfaceMeshPtr surfaceOf(const Sheet& sheet);
    void publishSurface(SurfaceMeshPtr surface);
    void updateField();
    void reportLive();
    void publish(SolverStatus::State state);

    Mailbox<Request> m_in;
    Mailbox<SolverOutput> m_out;
    std::mutex m_requestMutex;                // for the mailbox, the source and the flag together
    std::stop_source m_preparing;             // of what is made for the request taken last
    std::optional<SolveInput> m_preparesRest; // what is made ready for it, which no gesture waits for
    std::function<void()> m_wake;

    WorkerPool m_pool{0};
    TriangulationCache m_triangulations;
    TriangulationCache m_standInTriangulations;
    GhostCache m_ghostCache;
    bool m_keptIsShared; // and somebody else's
    std::shared_ptr<RestingCache> m_kept;
    std::uint64_t m_takenRevision = 0;
    std::uint64_t m_designRevision = 0; // of what is published
    int m_opening = 0;
    bool m_gesture = false; // the request taken last belongs to one

    std::unique_ptr<Sheet> m_live; // from which a gesture goes on: the surface that is shown, or of fewer triangles
    SolveInput m_liveInput;        // its design, bad elements included
    SolvePlan m_owed = SolvePlan::Nothing; // by a light change that was given up halfway
    bool m_liveEnded = false;              // it has converged during the gesture
    std::unique_ptr<Sheet> m_standIn;      // for m_live when the next gesture begins; may be null
    SolveInput m_standInInput;             // its design, but for the length of edges
    double m_stepTime = 5e-4;              // ms that a step of a gesture takes for each vertex, about
    std::unique_ptr<Sheet> m_lastWhole;    // before patches had to be left out: they come back to where they were

    std::unique_ptr<Sheet> m_resting; // on its way from the canonical start
    SolveInput m_restingInput;
    bool m_restingWaits = false; // for the end of the gesture: it has been solved, but differs

    bool m_atRest = false;         // the surface that is shown is the resting one of
    SolveInput m_restInput;        //
    SolverStatus m_restStatus;     // with this status
    RestingSurfacePtr m_shownKept; // and comes from those that are kept: there is no sheet of it yet
    bool m_restKept = false;       // and is among those that are kept

    std::atomic<bool> m_drawsField{false};
    std::atomic<double> m_stepBudget{16}; // ms
    FieldPicturePtr m_field;              // of the live surface; null until it is drawn
    SurfaceMeshPtr m_surface;
    SurfaceMeshPtr m_from; // as in SolverOutput, of m_surface
    std::uint64_t m_surfaceRevision = 0;
    SolverStatus m_status;
    SolveReport m_report;
    Stopwatch m_sincePublished;
    Stopwatch m_rateWatch;
    int m_rateCount = 0;
};

} // namespace bolster
