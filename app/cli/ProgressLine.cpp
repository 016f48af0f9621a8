#include "ProgressLine.h"

#include <chrono>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace bolster::cli {

namespace {

constexpr const char* emptyLine = "\r\033[K";

} // namespace

ProgressLine::ProgressLine(std::string doing)
    : m_doing(std::move(doing))
{
    m_thread = std::jthread([this](const std::stop_token& over) { show(over); });
}

ProgressLine::~ProgressLine() = default;

void ProgressLine::say(std::string doing)
{
    const std::scoped_lock lock(m_mutex);
    m_doing = std::move(doing);
}

void ProgressLine::show(const std::stop_token& over)
{
    using Clock = std::chrono::steady_clock;
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    const std::chrono::milliseconds pause(terminal ? 500 : 30'000);
    const Clock::time_point begin = Clock::now();
    std::unique_lock lock(m_mutex);
    bool shown = false;
    while (!m_changed.wait_for(lock, over, pause, [&] { return over.stop_requested(); })) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin).count();
        std::fprintf(stderr, "%s%s, %lld s%s", terminal ? emptyLine : "", m_doing.c_str(),
                     static_cast<long long>(seconds), terminal ? "" : "\n");
        std::fflush(stderr);
        shown = terminal;
    }
    if (shown)
        std::fputs(emptyLine, stderr);
}

} // namespace bolster::cli
