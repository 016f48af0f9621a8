#include "SolverThread.h"

#include "SolverWorker.h"

namespace bolster {

SolverThread::SolverThread(std::function<void()> wake)
    : m_worker(std::make_unique<SolverWorker>(std::move(wake)))
    , m_thread([worker = m_worker.get()](std::stop_token stop) { worker->run(stop); })
{}

SolverThread::~SolverThread() = default;

void SolverThread::request(Design design, std::uint64_t designRevision)
{
    m_design = design;
    m_revision = designRevision;
    m_worker->in().put({std::move(design), designRevision, false});
}

void SolverThread::settle()
{
    m_worker->in().put({m_design, m_revision, true});
}

std::optional<SolverOutput> SolverThread::take()
{
    return m_worker->out().take();
}

} // namespace bolster
