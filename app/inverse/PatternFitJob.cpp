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

PartFound measurePart(const PartWanted& wanted, const std::stop_token& stop)
{
    PartFound found{wanted.number, {}};
    try {
        FitOrder order = wanted.fit.order;
        if (Message problem; readTarget(wanted.fit.form, order.goals.target, problem, stop))
            found.figures = measureChange(wanted.fit.input, order, wanted.changed, stop);
    } catch (const std::exception&) {
        found.figures.reset(); // the live solver says why
    }
    return found;
}

} // namespace bolster
