// A fit of the pattern beside the window.
#pragma once

#include "FitForm.h"
#include "PatternFit.h"

namespace bolster {

struct FitWanted {
    int number = 0;
    SolveInput input;
    FitForm form;
    FitOrder order; ///< without a target
};

struct FitFound {
    int number = 0;
    std::vector<Freedom> freedoms;
    bool easeIsFree = false;
    FitResult result;
};

/// Reads the form, and fits.
FitFound fitTo(const FitWanted& wanted, const std::function<void(double, const FitRound&)>& progress,
               const std::stop_token& stop);

} // namespace bolster
