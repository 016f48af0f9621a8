// A pattern that follows a goal: what of it may change, changes until the cover at rest is as it is wished.
#pragma once

#include "FitGoals.h"
#include "Freedom.h"
#include "SolveInput.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bolster {

struct FitOrder {
    FitGoals goals;
    FitLocks locks;
    std::vector<Freedom> freedoms;
    double mostChange = 20; ///< mm that a control point may move; of other freedoms: 20 steps
    static constexpr double leastChange = 0.01, farthestChange = 1000; ///< what can be asked for
    int mostRounds = 16;                                               ///< of each triangulation
    int threads = 0;                                                   ///< 0: as many as the machine has
};

/// What was reached: for progress, for reports, and for who stops and keeps it.
struct FitRound {
    double edgeLength = 0; ///< of the triangles, mm
    bool few = false;      ///< they are larger than those at the end: figures will be others
    FitFigures figures;
    FitFigures before;        ///< of the design as it was, on the same triangles
    double largestChange = 0; ///< mm, since the beginning
    Eigen::VectorXd values;   ///< of the freedoms
};

struct FitResult {
    enum class Status { Done, NothingToDo, Failed, Cancelled };

    Status status = Status::Failed;
    Message reason; ///< when failed
    Design design;  ///< as it was, when failed or cancelled
    FitFigures before, after;
    std::vector<FitRound> rounds;
    Eigen::VectorXd values;        ///< of the freedoms
    std::vector<std::string> idle; ///< names of freedoms that change nothing
    std::vector<Message> notes;    ///< steps that were cut short, and why
    bool jumped = false;           ///< folds came or went on the way
};

/// Gauss-Newton steps with Levenberg's damping, whose derivatives are differences of covers at rest; first on few
/// triangles, then on those of the design, whose derivatives are still those of the few where these have led to
/// what is right on many, too. A step is taken only if the cover that comes to rest is better. `progress`: share of
/// the work, about, and what was reached. The result is the same on any number of threads.
FitResult fitPattern(const SolveInput& input, const FitOrder& order,
                     const std::function<void(double, const FitRound&)>& progress = {},
                     const std::stop_token& stop = {});

struct MeasuredChange {
    FitFigures before, after;
    bool better = false; ///< all goals together
};

/// What another change of the same pattern comes to, on the same last triangles. Nothing when its cover cannot be
/// solved, or `stop`.
std::optional<MeasuredChange> measureChange(const SolveInput& input, const FitOrder& order, const Design& changed,
                                            const std::stop_token& stop = {});

} // namespace bolster
