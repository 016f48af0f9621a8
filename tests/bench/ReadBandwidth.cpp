#include "ReadBandwidth.h"

#include "Rig.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace bolster::bench {

namespace {

/// In whole numbers, or the compiler would not be allowed to add several at once.
std::uint64_t sum(const std::uint64_t* begin, std::size_t count)
{
    constexpr std::size_t atOnce = 32;
    std::array<std::uint64_t, atOnce> sums{};
    for (std::size_t i = 0; i + atOnce <= count; i += atOnce)
        for (std::size_t k = 0; k < atOnce; ++k)
            sums[k] += begin[i + k];
    std::uint64_t total = 0;
    for (const std::uint64_t s : sums)
        total += s;
    return total;
}

} // namespace

std::function<void()> readOf(std::size_t bytes, WorkerPool& pool)
{
    const auto numbers = std::make_shared<std::vector<std::uint64_t>>(bytes / sizeof(std::uint64_t), 1);
    return [numbers, &pool] {
        static std::atomic<std::uint64_t> sink; // so that the sums are made
        const std::size_t share = numbers->size() / threads;
        pool.forTasks(threads, [&](int thread) {
            const std::size_t begin = share * static_cast<std::size_t>(thread);
            sink.fetch_add(sum(numbers->data() + begin, share), std::memory_order_relaxed);
        });
    };
}

} // namespace bolster::bench
