// Runs loops on a few threads in fixed chunks, so that results do not depend on the number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
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

    /// How many threads work as of the next loop: at least the caller, at most all.
    void use(int threads);
    int threads() const { return static_cast<int>(m_shares.size()); } ///< all

    static constexpr int chunkSize = 512;
    static int chunkCount(int count, int size = chunkSize) { return (count + size - 1) / size; }

    /// Calls body(0) ... body(count - 1), each once, and returns when all are done. Throws one of the exceptions
    /// that bodies have thrown.
    void forTasks(int count, const std::function<void(int)>& body);
    /// Calls body(chunk, begin, end) for every chunk of 0 .. count-1 and returns when all are done. Chunks must
    /// not write to the same place. What takes longer than a vertex wants smaller ones.
    void forChunks(int count, const std::function<void(int, int, int)>& body, int size = chunkSize);

private:
    void work(int thread);
    void runTasks(std::uint32_t region, int thread);
    void runShare(std::uint32_t region, std::atomic<std::uint64_t>& share);

    // What the threads work on. A task is claimed by counting a share up, which also holds the number of the region
    // and where the share ends: who comes late to a region that is over cannot claim anything, so nobody waits for
    // him. The end must not stand apart, or a latecomer could see the next region's and claim what is not there.
    struct alignas(64) Share {
        std::atomic<std::uint64_t> next{0};
    };
    std::vector<Share> m_shares; // of each thread
    std::atomic<int> m_used{1};  // threads
    std::atomic<const std::function<void(int)>*> m_body{nullptr};
    std::atomic<int> m_count{0};
    std::atomic<int> m_done{0};
    std::atomic<std::uint32_t> m_region{0};
    std::atomic<bool> m_thrown{false}; // whoever sets it writes m_exception
    std::exception_ptr m_exception;
    std::atomic<bool> m_stopping{false};
    std::vector<std::jthread> m_threads; // last, so that they have ended before the rest goes
};

} // namespace bolster
