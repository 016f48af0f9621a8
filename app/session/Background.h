// The one way to run a job off the GUI thread.
#pragma once

#include <QCoreApplication>
#include <QFuture>
#include <QFutureWatcher>
#include <QPromise>
#include <QThreadPool>

#include <functional>
#include <memory>
#include <utility>

namespace bolster {

/// Threads of the program alone: Qt paints large areas with threads of the global pool and waits for them, so a
/// window would stand still while others have them. What runs at the end of the program is waited for.
template <int Which>
QThreadPool& poolWaitedFor()
{
    static QThreadPool pool;
    static const bool waits = [] {
        qAddPostRoutine([] { pool.waitForDone(); });
        return true;
    }();
    (void)waits;
    return pool;
}

inline QThreadPool& backgroundPool()
{
    return poolWaitedFor<0>();
}

/// For what keeps people's work: it must not stand behind pictures that are being made.
inline QThreadPool& savingPool()
{
    return poolWaitedFor<1>();
}

/// Work that was begun.
template <class Result>
class Background {
public:
    explicit Background(QFuture<Result> future)
        : m_future(std::move(future))
    {}

    /// Calls take(result) on the receiver's thread, which must be this one; not at all when the receiver is gone.
    /// (QFuture::then looks for its receiver on the thread of the work, where it may go at that very moment.)
    template <class Take>
    void then(QObject* receiver, Take take) const
    {
        auto* watcher = new QFutureWatcher<Result>(receiver);
        QObject::connect(watcher, &QFutureWatcherBase::finished, receiver,
                         [watcher, take = std::move(take)]() mutable {
                             watcher->deleteLater();
                             take(watcher->result());
                         });
        watcher->setFuture(m_future);
    }

private:
    QFuture<Result> m_future;
};

/// Runs `work` on a thread of the pool. `work` must not throw.
template <class Result>
Background<Result> inBackground(std::function<Result()> work, QThreadPool& pool = backgroundPool())
{
    auto promise = std::make_shared<QPromise<Result>>();
    Background<Result> begun(promise->future());
    promise->start();
    pool.start([promise, work = std::move(work)] {
        promise->addResult(work());
        promise->finish();
    });
    return begun;
}

} // namespace bolster
