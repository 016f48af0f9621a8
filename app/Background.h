// The one way to run a job off the GUI thread.
#pragma once

#include <QFuture>
#include <QPromise>
#include <QThreadPool>

#include <functional>
#include <memory>

namespace bolster {

/// Runs `work` on a pool thread. Take the result with `.then(receiver, ...)`: it arrives on the receiver's thread,
/// and not at all when the receiver is gone. `work` must not throw.
template <class Result>
QFuture<Result> inBackground(std::function<Result()> work)
{
    auto promise = std::make_shared<QPromise<Result>>();
    QFuture<Result> future = promise->future();
    promise->start();
    QThreadPool::globalInstance()->start([promise, work = std::move(work)] {
        promise->addResult(work());
        promise->finish();
    });
    return future;
}

} // namespace bolster
