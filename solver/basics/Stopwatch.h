// Milliseconds since it was made or restarted.
#pragma once

#include <chrono>

namespace bolster {

class Stopwatch {
public:
    double elapsed() const
    {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
    }
    double restart()
    {
        const double ms = elapsed();
        m_start = std::chrono::steady_clock::now();
        return ms;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace bolster
