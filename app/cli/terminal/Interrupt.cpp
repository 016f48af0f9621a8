#include "Interrupt.h"

#include "DirectWrite.h"
#include "Output.h"
#include "Subcommands.h"
#include "Unfinished.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <poll.h>
#include <string_view>
#include <unistd.h>

namespace bolster::cli {

Interrupt::Interrupt(std::chrono::milliseconds patience)
    : m_patience(patience)
{
    sigemptyset(&m_signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (struct sigaction now = {}; sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaddset(&m_signals, signal);
    pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
    m_watcher = std::jthread([this](const std::stop_token& end) { watch(end); });
}

Interrupt::~Interrupt()
{
    m_watcher = {}; // ends and joins
    pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
}

void Interrupt::whenEnded(std::function<void()> leave)
{
    const std::scoped_lock lock(m_mutex);
    m_leave = std::move(leave);
}

void Interrupt::beginWriting()
{
    const std::scoped_lock lock(m_mutex);
    m_writing = true;
}

void Interrupt::watch(const std::stop_token& end)
{
    constexpr timespec pause = {0, 50'000'000};
    while (!end.stop_requested()) {
        if (sigtimedwait(&m_signals, nullptr, &pause) < 0)
            continue;
        m_source.request_stop();
        pthread_sigmask(SIG_UNBLOCK, &m_signals, nullptr); // the next one takes its usual course
        endUnlessBack(end);
        return;
    }
}

void Interrupt::endUnlessBack(const std::stop_token& end)
{
    const auto since = std::chrono::steady_clock::now();
    while (!end.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        const std::scoped_lock lock(m_mutex); // so that nobody begins to write meanwhile
        if (std::chrono::steady_clock::now() - since >= m_patience && !end.stop_requested() && mayEnd())
            endHere();
    }
}

/// Files that are being written are put away in order. What goes to a pipe that nobody reads never ends.
bool Interrupt::mayEnd()
{
    return !m_writing || DirectWrite::halted();
}

void Interrupt::endHere()
{
    constexpr std::string_view said = "error: interrupted\n";
    // Whoever does not read what was written does not read this either: nothing here may wait for ever.
    std::thread([] {
        std::this_thread::sleep_for(std::chrono::seconds(2));
        std::_Exit(otherFailure);
    }).detach();
    pollfd errors{STDERR_FILENO, POLLOUT, 0};
    if (::poll(&errors, 1, 0) > 0 && ::write(STDERR_FILENO, said.data(), said.size()) < 0)
        std::_Exit(otherFailure); // nobody is left to tell
    if (m_leave && !m_writing)
        m_leave();
    removeUnfinished();
    std::_Exit(otherFailure);
}

} // namespace bolster::cli
