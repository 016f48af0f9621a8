#include "Interrupt.h"

#include <ctime>

namespace bolster::cli {

Interrupt::Interrupt()
{
    sigemptyset(&m_signals);
    sigaddset(&m_signals, SIGINT);
    sigaddset(&m_signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
    m_watcher = std::jthread([this](std::stop_token end) { watch(std::move(end)); });
}

Interrupt::~Interrupt()
{
    m_watcher = {}; // ends and joins
    pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
}

void Interrupt::watch(std::stop_token end)
{
    constexpr timespec pause = {0, 50'000'000};
    while (!end.stop_requested()) {
        if (sigtimedwait(&m_signals, nullptr, &pause) < 0)
            continue;
        m_source.request_stop();
        pthread_sigmask(SIG_UNBLOCK, &m_signals, nullptr); // the next one takes its usual course
        return;
    }
}

} // namespace bolster::cli
