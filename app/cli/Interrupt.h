// Ctrl+C as a stop token.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace bolster::cli {

/// From construction on, SIGINT and SIGTERM stop the token instead of the program; a second one ends the program.
/// Make it before any other thread is started: they inherit that the signals are not theirs.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_source.get_token(); }

private:
    void watch(std::stop_token end);

    sigset_t m_signals;
    sigset_t m_before;
    std::stop_source m_source;
    std::jthread m_watcher;
};

} // namespace bolster::cli
