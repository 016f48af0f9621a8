#include "SolverThread.h"

#include "SolverWorker.h"

namespace bolster {

SolverThread::SolverThread(std::function<void()> wake, std::shared_ptr<RestingCache> kept)
    : m_worker(std::make_unique<SolverWorker>(std::move(wake), std::move(kept)))
    , m_thread([worker = m_worker.get()](std::stop_token stop) { worker->run(stop); })
{}

SolverThread::~SolverThread() = default;

void SolverThread::request(SolveInput input, std::uint64_t designRevision, bool passing)
{
    m_worker->request({std::move(input), designRevision, passing, m_opening});
}

void SolverThread::drawField(bool on)
{
    m_worker->drawField(on);
}

void SolverThread::setStepBudget(double ms)
{
    m_worker->setStepBudget(ms);
}

std::optional<SolverOutput> SolverThread::take()
{
    std::optional<SolverOutput> output = m_worker->out().take();
    return output && output->opening == m_opening ? std::move(output) : std::nullopt;
}

const std::shared_ptr<RestingCache>& SolverThread::kept() const
{
    return m_worker->kept();
}

} // namespace bolster
