// Work on a thread of its own of which only the newest counts.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace bolster {

/// Takes the newest request; a newer one asks the running one to stop if its caller says so. What the work holds is
/// destroyed on the thread.
template <class Request, class Result>
class LatestThread {
public:
    using Work = std::function<Result(const Request&, std::stop_token)>;
    using Done = std::function<void(Result)>;

    /// `done` is called on the thread, not for what was stopped.
    LatestThread(Work work, Done done)
        : m_work(std::move(work))
        , m_done(std::move(done))
        , m_thread([this](std::stop_token stop) { run(stop); })
    {}

    /// Waits for what is running, which it asks to stop.
    ~LatestThread()
    {
        cancel();
        m_thread.request_stop();
        m_wake.notify_all();
    }

    /// Replaces a request that was not taken yet; the running one goes on to its end unless `stopRunning`.
    void request(Request request, bool stopRunning = false)
    {
        {
            const std::lock_guard lock(m_mutex);
            m_next = std::move(request);
            if (stopRunning)
                m_running.request_stop();
        }
        m_wake.notify_all();
    }

    void cancel()
    {
        const std::lock_guard lock(m_mutex);
        m_next.reset();
        m_running.request_stop();
    }

private:
    void run(std::stop_token stop)
    {
        const Work work = std::exchange(m_work, nullptr);
        while (!stop.stop_requested()) {
            std::optional<Request> request;
            std::stop_token running;
            {
                std::unique_lock lock(m_mutex);
                if (!m_wake.wait(lock, stop, [this] { return m_next.has_value(); }))
                    return;
                request.swap(m_next);
                m_running = std::stop_source();
                running = m_running.get_token();
            }
            Result result = work(*request, running);
            if (!running.stop_requested())
                m_done(std::move(result));
        }
    }

    Work m_work;
    Done m_done;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Request> m_next;
    std::stop_source m_running;
    std::jthread m_thread; ///< last: it uses the others
};

} // namespace bolster
