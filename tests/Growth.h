// How work grows with what there is to do: ratios within one run, whatever else the machine does.
#pragma once

#include <algorithm>
#include <ctime>
#include <malloc.h>

namespace bolster::test {

/// Memory that was given back is kept: what a system takes to hand out pages anew, again and again, is not what
/// grows.
inline void keepMemory()
{
    static const bool kept = mallopt(M_TRIM_THRESHOLD, 1 << 30) && mallopt(M_MMAP_THRESHOLD, 1 << 30);
    (void)kept;
}

/// Seconds that this thread has worked.
inline double workedSeconds()
{
    keepMemory();
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Clearly not quadratic, with room for memory that grows out of caches.
inline constexpr double nearlyLinear = 26;

/// How many times as long work(8 n) takes as work(n): 8 when it is linear, 64 when it is quadratic. `work` gets
/// what `make` returns for a count, which is not measured. What else the machine does to caches and clocks only
/// adds: the least of some tries counts, which end below the `limit`.
template <class Make, class Work>
double growth(int n, const Make& make, const Work& work, double limit = nearlyLinear)
{
    const auto few = make(n);
    const auto many = make(8 * n);
    const auto least = [&](const auto& input) {
        double best = 1e9;
        for (int round = 0; round < 3; ++round) {
            const double before = workedSeconds();
            work(input);
            best = std::min(best, workedSeconds() - before);
        }
        return best;
    };
    double ratio = 1e9;
    for (int tries = 0; tries < 5 && ratio >= limit; ++tries)
        ratio = std::min(ratio, least(many) / std::max(least(few), 1e-6));
    return ratio;
}

} // namespace bolster::test
