// A fit of the pattern beside the window.
#pragma once

#include "PatternFit.h"
#include "PointCloud.h"

#include <QString>

#include <memory>

namespace bolster {

/// What the cover shall lie on: one of these, or nothing.
struct FitForm {
    std::optional<Scan> scan;
    std::shared_ptr<const PointCloud> cloud;
    QString file; ///< a mesh or points, mm
};

struct FitWanted {
    int number = 0;
    SolveInput input;
    FitForm form;
    FitOrder order; ///< without a target
};

struct FitFound {
    int number = 0;
    std::vector<Freedom> freedoms;
    FitResult result;
};

/// Reads the form, and fits.
FitFound fitTo(const FitWanted& wanted, const std::function<void(double, const FitRound&)>& progress,
               const std::stop_token& stop);

} // namespace bolster
