// What runs on the solver thread: follows the newest design and computes its resting surface when there is time.
#pragma once

#include "Mailbox.h"
#include "MakeGhosts.h"
#include "PatternWarp.h"
#include "PreparedSheet.h"
#include "Relaxation.h"
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
        bool settle = false;  ///< make the resting surface the live one as soon as it is known
        bool passing = false; ///< others follow at once: a drag
        int opening = 0;      ///< different for designs that have nothing to do with each other
    };

    /// `wake` is called when an output waits and none was waiting before.
    explicit SolverWorker(std::function<void()> wake);

    /// From another thread.
    void request(Request request);
    /// From another thread, as of the next answer.
    void drawField(bool on) { m_drawsField = on; }
    Mailbox<SolverOutput>& out() { return m_out; }
    /// Until stopped.
    void run(std::stop_token stop);

private:
    /// A cover with its solver state.
    struct Sheet {
        PreparedSheet prepared;
        std::unique_ptr<Relaxation> relaxation;
        std::optional<PatternWarp> warp; ///< once outlines have been dragged
        bool canonical = false;          ///< iterates from the canonical start, so it ends as the resting surface
        bool stale = false;              ///< its samples belong to curves as they were before a drag
    };

    std::optional<Request> takeRequest();
    static bool running(const Sheet& sheet);
    bool step();
    SolvePlan planFor(const Request& request);
    void begin(Request request);
    bool republishLive(const Design& design);
    bool retargetLive(const SolveInput& input, SolvePlan plan);
    bool warpLive(const OutlineSampling& sampling);
    bool rebuildLive(const SolveInput& input, bool torn);
    std::unique_ptr<Sheet> makeSheet(const SolveInput& input, double tolerance);
    Ghosts ghostsFor(const PreparedSheet& sheet, Problems& problems);
    void iterateLive();
    void endLive();
    void beginResting();
    void iterateResting();
    void adoptResting();
    void failBy(const std::exception& error);
    void fail(Message reason);
    void publishSurface();
    void updateField();
    void reportLive();
    void publish(SolverStatus::State state);

    Mailbox<Request> m_in;
    Mailbox<SolverOutput> m_out;
    std::mutex m_requestMutex;    // for the mailbox and the source together
    std::stop_source m_preparing; // of what is made for the request taken last
    std::function<void()> m_wake;

    WorkerPool m_pool{1}; // the other cores belong to the window
    TriangulationCache m_cache;
    GhostCache m_ghostCache;
    SolveInput m_input;                    // as requested, bad elements included
    SolvePlan m_owed = SolvePlan::Nothing; // by a light change that was given up halfway
    std::uint64_t m_takenRevision = 0;
    std::uint64_t m_designRevision = 0; // of what is published: the one before until a request has been begun
    bool m_settleWanted = false;
    int m_opening = 0;
    std::unique_ptr<Sheet> m_live;
    std::unique_ptr<Sheet> m_lastWhole; // before patches had to be left out: they come back to where they were
    std::unique_ptr<Sheet> m_resting;
    bool m_restingDone = false;

    std::atomic<bool> m_drawsField{false};
    FieldPicturePtr m_field; // of the live surface; null until it is drawn
    SurfaceMeshPtr m_surface;
    std::uint64_t m_surfaceRevision = 0;
    SolverStatus m_status;
    SolveReport m_report;
    Stopwatch m_sincePublished;
    Stopwatch m_rateWatch;
    int m_rateCount = 0;
};

} // namespace bolster
