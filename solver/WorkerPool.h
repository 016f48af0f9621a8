// Runs loops on a few threads in fixed chunks, so that results do not depend on the number of threads.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace bolster {

class WorkerPool {
public:
    /// `threads` counts the caller; 0 means as many as the machine has.
    explicit WorkerPool(int threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    static constexpr int chunkSize = 512;
    static int chunkCount(int count) { return (count + chunkSize - 1) / chunkSize; }

    /// Calls body(chunk, begin, end) for every chunk of 0 .. count-1 and returns when all are done. The body must
    /// not throw, and chunks must not write to the same place.
    void forChunks(int count, const std::function<void(int, int, int)>& body);

private:
    void work();
    void runChunks();

    const std::function<void(int, int, int)>* m_body = nullptr;
    int m_count = 0;
    std::atomic<int> m_nextChunk{0};
    std::atomic<int> m_generation{0};
    std::atomic<int> m_busy{0};
    std::atomic<bool> m_stopping{false};
    std::vector<std::jthread> m_threads; // last, so that they have ended before the rest goes
};

} // namespace bolster
