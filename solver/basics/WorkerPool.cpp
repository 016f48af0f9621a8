#include "WorkerPool.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

// Some ten microseconds: regions mostly follow each other within that.
constexpr int spins = 300;
// Some hundred more, in which other programs may have the core: to be woken takes about as long, and on a virtual
// machine longer than the work of a region.
constexpr int yields = 1000;

void pause()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

// How a share is divided: the region, the task behind its last one, the next one to be claimed.
constexpr int taskBits = 22; // chunks of 512 of as many things as an int can count
constexpr std::uint64_t taskMask = (std::uint64_t{1} << taskBits) - 1;

std::uint64_t share(std::uint32_t region, int begin, int end)
{
    return std::uint64_t{region} << (2 * taskBits) | static_cast<std::uint64_t>(end) << taskBits |
           static_cast<std::uint64_t>(begin);
}

bool isOf(std::uint64_t next, std::uint32_t region)
{
    return (next ^ share(region, 0, 0)) >> (2 * taskBits) == 0;
}

/// Waits until `value` is no longer `old`; sleeps when that takes long.
template <class T>
void waitForChange(const std::atomic<T>& value, T old)
{
    for (int i = 0; i < spins; ++i) {
        if (value.load(std::memory_order_acquire) != old)
            return;
        pause();
    }
    for (int i = 0; i < yields; ++i) {
        if (value.load(std::memory_order_acquire) != old)
            return;
        std::this_thread::yield();
    }
    value.wait(old, std::memory_order_acquire);
}

} // namespace

WorkerPool::WorkerPool(int threads)
{
    if (threads <= 0)
        threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    m_shares = std::vector<Share>(static_cast<std::size_t>(threads));
    m_used = threads;
    for (int i = 1; i < threads; ++i)
        m_threads.emplace_back([this, i] { work(i); });
}

WorkerPool::~WorkerPool()
{
    m_stopping = true;
    ++m_region;
    m_region.notify_all();
}

void WorkerPool::use(int count)
{
    m_used = std::clamp(count, 1, threads());
}

void WorkerPool::forChunks(int count, const std::function<void(int, int, int)>& body, int size)
{
    forTasks(chunkCount(count, size),
             [&](int chunk) { body(chunk, chunk * size, std::min(count, (chunk + 1) * size)); });
}

void WorkerPool::forTasks(int count, const std::function<void(int)>& body)
{
    const int threads = m_used.load(std::memory_order_relaxed);
    if (threads == 1 || count <= 1) {
        for (int task = 0; task < count; ++task)
            body(task);
        return;
    }
    const std::uint32_t region = m_region.load(std::memory_order_relaxed) + 1;
    m_body.store(&body, std::memory_order_relaxed);
    m_done.store(0, std::memory_order_relaxed);
    m_count.store(count, std::memory_order_relaxed);
    for (int i = 0; i < threads; ++i) {
        const auto begin = static_cast<int>(std::int64_t{count} * i / threads);
        const auto end = static_cast<int>(std::int64_t{count} * (i + 1) / threads);
        m_shares[static_cast<std::size_t>(i)].next.store(share(region, begin, end), std::memory_order_release);
    }
    m_region.store(region, std::memory_order_release);
    m_region.notify_all();
    runTasks(region, 0);
    for (int done = m_done.load(std::memory_order_acquire); done != count;
         done = m_done.load(std::memory_order_acquire))
        waitForChange(m_done, done);
    if (m_thrown.exchange(false))
        std::rethrow_exception(std::exchange(m_exception, nullptr));
}

void WorkerPool::work(int thread)
{
    for (std::uint32_t seen = 0;;) {
        waitForChange(m_region, seen);
        seen = m_region.load(std::memory_order_acquire);
        if (m_stopping)
            return;
        runTasks(seen, thread);
    }
}

/// The own share first, then what others have left.
void WorkerPool::runTasks(std::uint32_t region, int thread)
{
    const int threads = m_used.load(std::memory_order_relaxed); // a latecomer's: then there is nothing to claim
    if (thread >= threads)
        return;
    for (int i = 0; i < threads; ++i)
        runShare(region, m_shares[static_cast<std::size_t>((thread + i) % threads)].next);
}

void WorkerPool::runShare(std::uint32_t region, std::atomic<std::uint64_t>& share)
{
    for (std::uint64_t next = share.load(std::memory_order_acquire); isOf(next, region);) {
        const auto* body =
            m_body.load(std::memory_order_relaxed); // of a later region, perhaps: then the claim fails
        const int task = static_cast<int>(next & taskMask);
        const int end = static_cast<int>(next >> taskBits & taskMask);
        if (task >= end)
            return;
        if (!share.compare_exchange_weak(next, next + 1, std::memory_order_acq_rel, std::memory_order_acquire))
            continue;
        try {
            (*body)(task);
        } catch (...) {
            if (!m_thrown.exchange(true))
                m_exception = std::current_exception();
        }
        const int count = m_count.load(std::memory_order_relaxed); // of this region: it cannot end before this task
        if (m_done.fetch_add(1, std::memory_order_acq_rel) + 1 == count)
            m_done.notify_all();
        next = share.load(std::memory_order_acquire);
    }
}

} // namespace bolster
