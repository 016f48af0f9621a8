// What a command is doing, for whoever waits for it.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bolster::cli {

/// The last line on a terminal, from half a second on: what is done, and for how long. It goes with this; nothing
/// else is to be printed meanwhile. Where stderr is no terminal, a line every half minute, which stays.
class ProgressLine {
public:
    explicit ProgressLine(std::string doing);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void say(std::string doing);

private:
    void show(const std::stop_token& over);

    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::string m_doing;
    std::jthread m_thread; // last, so that it has ended before the rest goes
};

} // namespace bolster::cli
