// Stops a fuzzer at an input that keeps it too long.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace bolster::test {

/// Measures a run from here to the end of the block: what takes more than a second is a hang. Of processor time,
/// which does not depend on what else the machine does; a run that waits for ever is seen by libFuzzer's -timeout.
/// BOLSTER_FUZZ_SECONDS is another limit, for files that are larger than any that is made up.
class TimedRun {
public:
    TimedRun() = default;
    ~TimedRun()
    {
        static const char* const other = std::getenv("BOLSTER_FUZZ_SECONDS");
        static const double limit = other ? std::atof(other) : 1;
        const double seconds = now() - m_begin;
        if (seconds <= limit)
            return;
        std::fprintf(stderr, "hang: a run took %.2f s of processor time\n", seconds);
        std::abort();
    }
    TimedRun(const TimedRun&) = delete;
    TimedRun& operator=(const TimedRun&) = delete;

private:
    static double now()
    {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double m_begin = now();
};

} // namespace bolster::test
