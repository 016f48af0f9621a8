#include "PatternDrag.h"

#include "Scenes.h"
#include "Stopwatch.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bolster::bench {

PatternDrag::PatternDrag(Design seat)
    : m_seat(std::move(seat))
{
    request(m_seat, false, [](const SolverOutput& output) {
        return output.surface && output.status.state == SolverStatus::State::Settled;
    });
}

double PatternDrag::move()
{
    const int step = ++m_moves % (2 * steps);
    const double share = farthest * std::min(step, 2 * steps - step) / steps;
    return request(withLongerInsert(m_seat, share), true,
                   [](const SolverOutput& output) { return output.surface != nullptr; });
}

double PatternDrag::release(Until until)
{
    // Never where it was released before: of that the surface is kept.
    const double golden = std::numbers::phi * ++m_releases;
    const double share = farthest * (0.3 + 0.5 * (golden - std::floor(golden)));
    constexpr double last = 0.002; // of the way: the pointer goes on a little while a step is made
    request(withLongerInsert(m_seat, share - last), true,
            [](const SolverOutput& output) { return output.surface != nullptr; });
    const std::uint64_t dragged = m_topology;
    return request(withLongerInsert(m_seat, share), false, [dragged, until](const SolverOutput& output) {
        return output.surface && output.surface->topology->serial != dragged &&
               (until == Until::NewTriangles || output.status.resting);
    });
}

/// The time until an output about this design is the answer, ms.
double PatternDrag::request(Design design, bool passing, const std::function<bool(const SolverOutput&)>& answered)
{
    constexpr std::chrono::seconds patience(60);
    const Stopwatch watch;
    m_thread.request(std::move(design), ++m_revision, passing);
    for (;;) {
        if (!m_woken.try_acquire_for(patience))
            throw std::runtime_error("a benchmark failed: the solver does not answer");
        const std::optional<SolverOutput> output = m_thread.take();
        if (!output)
            continue;
        if (output->status.state == SolverStatus::State::Failed)
            throw std::runtime_error("a benchmark failed: " + output->status.reason.english());
        if (output->designRevision != m_revision || !answered(*output))
            continue;
        m_topology = output->surface->topology->serial;
        return watch.elapsed();
    }
}

} // namespace bolster::bench
