// A solver thread whose outputs can be waited for, and designs to give to it.
#pragma once

#include "CurveEdits.h"
#include "SolverThread.h"
#include "TestDesigns.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace bolster::test {

/// As an event loop would.
class Listener {
public:
    explicit Listener(std::shared_ptr<RestingCache> kept = nullptr)
        : m_kept(std::move(kept))
    {}
    const std::shared_ptr<RestingCache>& kept() const { return m_solver.kept(); }
    void startAnew() { m_solver.startAnew(); }

    void request(const Design& design, std::uint64_t revision, bool passing = false)
    {
        m_solver.request(design, revision, passing);
    }
    void request(const SolveInput& input, std::uint64_t revision) { m_solver.request(input, revision); }
    void setStepBudget(double ms) { m_solver.setStepBudget(ms); }
    void drawField(bool on) { m_solver.drawField(on); }

    /// Outputs until one satisfies the condition; nothing if that takes longer than a minute.
    template <class Condition>
    std::optional<SolverOutput> waitFor(Condition condition)
    {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < deadline) {
            {
                std::unique_lock lock(m_mutex);
                m_wake.wait_for(lock, std::chrono::seconds(1), [this] { return m_woken; });
                m_woken = false;
            }
            if (std::optional<SolverOutput> output = m_solver.take(); output && condition(*output))
                return output;
        }
        return std::nullopt;
    }

private:
    void wake()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_woken = true;
        }
        m_wake.notify_one();
    }

    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_woken = false;
    std::shared_ptr<RestingCache> m_kept;
    SolverThread m_solver{[this] { wake(); }, m_kept};
};

template <class Kind>
ElementId firstOf(const Design& design)
{
    ElementId result{};
    design.each<Kind>([&](ElementId id, const Kind&) {
        if (result == noElement)
            result = id;
    });
    return result;
}

inline Design withCurveMoved(const Design& design, const Vec3& delta)
{
    const int points[] = {1};
    return design.with(edits::moveCurvePoints(design, firstOf<FixationCurve>(design), points, delta));
}

/// A sheet stretched between two curves: one shape only, whatever the way there.
inline Design hammock()
{
    DesignBuilder b(14);
    const ElementId patch = b.patch(rectangle(300, 200), b.fabric(0.3, 8));
    b.fix({patch, 0, 1}, BSpline3(3, false, {{0, 0, 0}, {100, 0, 20}, {200, 0, 20}, {300, 0, 0}}));
    b.fix({patch, 2, 3}, BSpline3(3, false, {{300, 210, 0}, {200, 210, 30}, {100, 210, 30}, {0, 210, 0}}));
    return b.design();
}

} // namespace bolster::test
