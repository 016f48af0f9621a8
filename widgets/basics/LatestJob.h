// Work beside the GUI thread of which only the newest counts.
#pragma once

#include "LatestThread.h"

#include <QObject>

#include <utility>

namespace bolster {

/// A LatestThread whose results arrive on the thread that made the job; after destruction none do.
template <class Request, class Result>
class LatestJob {
public:
    using Work = typename LatestThread<Request, Result>::Work;
    using Done = typename LatestThread<Request, Result>::Done;

    LatestJob(Work work, Done done)
        : m_done(std::move(done))
        , m_thread(std::move(work), [this](Result result) { deliver(std::move(result)); })
    {}

    /// Replaces a request that was not taken yet; the running one goes on to its end unless `stopRunning`.
    void request(Request request, bool stopRunning = false) { m_thread.request(std::move(request), stopRunning); }
    void cancel() { m_thread.cancel(); }

private:
    void deliver(Result result)
    {
        QMetaObject::invokeMethod(
            &m_receiver, [this, result = std::move(result)]() mutable { m_done(std::move(result)); },
            Qt::QueuedConnection);
    }

    Done m_done;
    QObject m_receiver;                     ///< drops results that come too late
    LatestThread<Request, Result> m_thread; ///< last: it uses the others
};

} // namespace bolster
