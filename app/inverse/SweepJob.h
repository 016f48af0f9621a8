// Tolerances of a cover beside the window: as if covers were linear first, then by solving pieces.
#pragma once

#include "Sweep.h"

#include <memory>
#include <optional>

namespace bolster {

/// What each tolerance does, and what that makes of many pieces.
struct LinearCovers {
    SurfaceMeshPtr nominal;
    Eigen::MatrixXf columns;          ///< as of Sweep::linear
    std::vector<std::size_t> unknown; ///< tolerances with which no cover was found
    LinearP95 p95;
};

/// Of one design with its tolerances: what more pieces or another limit need not find again.
struct SweepKnown {
    std::shared_ptr<const LinearCovers> linear;
    std::vector<std::shared_ptr<const SweepSample>> pieces; ///< solved; from the first on, by their numbers
};

struct SweepWanted {
    int number = 0;
    SolveInput input;
    Tolerances tolerances;
    int samples = 0;  ///< that are solved; 0: none
    double limit = 0; ///< mm: of what 95 % of a cover do not exceed
    SweepKnown known; ///< of the same design and tolerances, if anything is
};

struct SweepFound {
    int number = 0;
    Message problem; ///< why there is no answer; empty when there is one
    SweepKnown known;
    std::vector<float> p95;        ///< mm, per vertex: by linear covers, which solved ones correct
    std::vector<double> influence; ///< of each tolerance, as shares of the variance
    std::vector<double> mostMoved; ///< mm: how far each moves the cover anywhere
    int solved = 0;                ///< pieces by which p95 is known; 0: linear covers
    int resting = 0;               ///< of them, that came to rest
    int out = 0;                   ///< pieces out of the limit, of the resting ones or of `linearPieces`
    std::optional<double> error;   ///< mm, of the rms of p95, where it is known
    bool whole = false;            ///< there is nothing more to come

    static constexpr int linearPieces = 1000;
};

/// How much is done, and what is known by then.
using SweepNews = std::function<void(double share, const SweepFound* found)>;

/// `news` from time to time.
SweepFound findSweep(const SweepWanted& wanted, const SweepNews& news, const std::stop_token& stop);

} // namespace bolster
