// Work on files beside the window, with progress that can be cancelled.
#pragma once

#include "Ask.h"
#include "Background.h"
#include "ImportWatch.h"
#include "Jobs.h"

#include <QPointer>
#include <QProgressBar>
#include <QProgressDialog>

#include <memory>
#include <stop_token>
#include <utility>

namespace bolster {

/// `done` gets what came of `read`, unless that was cancelled or `context` is gone.
template <class Result, class Read, class Done>
void withProgress(QObject* context, QWidget* window, const QString& text, Read read, Done done)
{
    constexpr int steps = 100;
    const auto [progress, bar] = openProgress(window, text, steps);
    std::stop_source stop;
    QObject::connect(progress, &QProgressDialog::canceled, context, [stop]() mutable { stop.request_stop(); });
    QObject::connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    auto job = std::make_shared<RunningJob>(text, [progress = QPointer(progress)] {
        if (progress)
            progress->cancel();
    });
    const auto report = [context, shown = std::make_shared<int>(0), bar = QPointer(bar),
                         job = std::weak_ptr(job)](double share) {
        const int step = static_cast<int>(share * steps);
        if (step <= std::exchange(*shown, step))
            return;
        QMetaObject::invokeMethod(context, [bar, step, job] {
            if (bar)
                bar->setValue(step);
            if (const auto running = job.lock())
                running->report(double(step) / steps);
        });
    };
    inBackground<Result>([read, watch = ImportWatch{stop.get_token(), report, {}}] {
        return read(watch);
    }).then(context, [done, job, progress = QPointer(progress)](const Result& result) mutable {
        const bool cancelled = !progress || progress->wasCanceled();
        closeProgress(progress);
        job.reset();
        if (!cancelled)
            done(result);
    });
}

} // namespace bolster
