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

/// A part of what was found, or another share of it.
struct PartWanted {
    int number = 0;
    FitWanted fit;
    Design changed;
};

struct PartFound {
    int number = 0;
    std::optional<MeasuredChange> figures; ///< none when there is no cover
};

/// Reads the form, solves, and measures.
PartFound measurePart(const PartWanted& wanted, const std::stop_token& stop);

} // namespace bolster
