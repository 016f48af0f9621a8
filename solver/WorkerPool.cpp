#include "WorkerPool.h"

#include <algorithm>

namespace bolster {

WorkerPool::WorkerPool(int threads)
{
    if (threads <= 0)
        threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    for (int i = 1; i < threads; ++i)
        m_threads.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool()
{
    m_stopping = true;
    ++m_generation;
    m_generation.notify_all();
}

void WorkerPool::forChunks(int count, const std::function<void(int, int, int)>& body)
{
    m_body = &body;
    m_count = count;
    m_nextChunk = 0;
    m_busy = static_cast<int>(m_threads.size());
    if (!m_threads.empty()) {
        ++m_generation;
        m_generation.notify_all();
    }
    runChunks();
    for (int busy = m_busy; busy > 0; busy = m_busy)
        m_busy.wait(busy);
}

void WorkerPool::work()
{
    for (int seen = 0;;) {
        m_generation.wait(seen);
        seen = m_generation;
        if (m_stopping)
            return;
        runChunks();
        if (--m_busy == 0)
            m_busy.notify_all();
    }
}

void WorkerPool::runChunks()
{
    const int chunks = chunkCount(m_count);
    for (int chunk = m_nextChunk++; chunk < chunks; chunk = m_nextChunk++)
        (*m_body)(chunk, chunk * chunkSize, std::min(m_count, (chunk + 1) * chunkSize));
}

} // namespace bolster
