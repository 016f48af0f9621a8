// Ctrl+C as a stop token.
#pragma once

#include <chrono>
#include <csignal>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace bolster::cli {

/// From construction on, SIGINT, SIGTERM and SIGHUP stop the token instead of the program; a second one ends the
/// program. Those that are ignored (nohup) stay so.
/// Who does not come back within `patience` is in the middle of something long that nobody needs to end in order,
/// or writes to a pipe that nobody reads: then the program ends here, and what it has not finished is removed. Make
/// it before any other thread is started: they inherit that the signals are not theirs.
class Interrupt {
public:
    /// `patience`: time for tidying up. Who opens a project has unpacked it somewhere.
    explicit Interrupt(std::chrono::milliseconds patience = std::chrono::milliseconds(500));
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return m_source.get_token(); }
    /// What is still to be done then, on another thread.
    void whenEnded(std::function<void()> leave);
    /// Files are written from now on: they are put away in order, however long that takes.
    void beginWriting();

private:
    void watch(const std::stop_token& end);
    void endUnlessBack(const std::stop_token& end);
    bool mayEnd();
    [[noreturn]] void endHere();

    std::chrono::milliseconds m_patience;
    sigset_t m_signals;
    sigset_t m_before;
    std::stop_source m_source;
    std::mutex m_mutex;
    bool m_writing = false;
    std::function<void()> m_leave;
    std::jthread m_watcher;
};

} // namespace bolster::cli
