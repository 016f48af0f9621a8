// How work grows with what there is to do: ratios within one run, whatever else the machine does.
#pragma once

#include <algorithm>
#include <ctime>

namespace bolster::test {

/// Seconds that this thread has worked.
inline double workedSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How many times as long work(8 n) takes as work(n): 8 when it is linear, 64 when it is quadratic. `work` gets
/// what `make` returns for a count, which is not measured.
template <class Make, class Work>
double growth(int n, const Make& make, const Work& work)
{
    const auto least = [&](int count) {
        const auto input = make(count);
        double best = 1e9;
        for (int round = 0; round < 3; ++round) {
            const double before = workedSeconds();
            work(input);
            best = std::min(best, workedSeconds() - before);
        }
        return best;
    };
    const double few = least(n);
    return least(8 * n) / std::max(few, 1e-6);
}

/// Clearly not quadratic, with room for memory that grows out of caches.
inline constexpr double nearlyLinear = 26;

} // namespace bolster::test
