#include "PatternFitJob.h"

#include "SolveFailure.h"

namespace bolster {

FitFound fitTo(const FitWanted& wanted, const std::function<void(double, const FitRound&)>& progress,
               const std::stop_token& stop)
{
    FitFound found{wanted.number, wanted.order.freedoms, !wanted.order.locks.ease, {}};
    found.result.design = wanted.input.design;
    try {
        FitOrder order = wanted.order;
        if (readTarget(wanted.form, order.goals.target, found.result.reason, stop))
            found.result = fitPattern(wanted.input, order, progress, stop);
    } catch (const std::exception& error) {
        found.result.reason = failureMessage(error);
    }
    return found;
}

} // namespace bolster
