// The one way to run a job off the GUI thread.
#pragma once

#include <QCoreApplication>
#include <QFuture>
#include <QPromise>
#include <QThreadPool>

#include <functional>
#include <memory>

namespace bolster {

/// Of the program alone: Qt paints large areas with threads of the global one and waits for them, so a window would
/// stand still while others have them. What runs at the end of the program is waited for.
inline QThreadPool& backgroundPool()
{
    static QThreadPool pool;
    static const bool waits = [] {
        qAddPostRoutine([] { pool.waitForDone(); });
        return true;
    }();
    (void)waits;
    return pool;
}

/// Runs `work` on a thread of it. Take the result with `.then(receiver, ...)`: it arrives on the receiver's thread,
/// and not at all when the receiver is gone. `work` must not throw.
template <class Result>
QFuture<Result> inBackground(std::function<Result()> work)
{
    auto promise = std::make_shared<QPromise<Result>>();
    QFuture<Result> future = promise->future();
    promise->start();
    backgroundPool().start([promise, work = std::move(work)] {
        promise->addResult(work());
        promise->finish();
    });
    return future;
}

} // namespace bolster
