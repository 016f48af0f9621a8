// Tolerances of a cover beside the window: as if covers were linear first, then by solving pieces.
#pragma once

#include "Sweep.h"

#include <optional>

namespace bolster {

struct SweepWanted {
    int number = 0;
    SolveInput input;
    Tolerances tolerances;
    int samples = 0;  ///< that are solved; 0: none
    double limit = 0; ///< mm: of what 95 % of a cover do not exceed
};

struct SweepFound {
    int number = 0;
    Message problem; ///< why there is no answer; empty when there is one
    SurfaceMeshPtr nominal;
    std::vector<float> p95;           ///< mm, per vertex: by linear covers, which solved ones correct
    std::vector<double> influence;    ///< of each tolerance, as shares of the variance
    std::vector<double> mostMoved;    ///< mm: how far each moves the cover anywhere
    std::vector<std::size_t> unknown; ///< tolerances with which no cover was found
    int solved = 0;                   ///< pieces by which p95 is known; 0: linear covers
    int resting = 0;                  ///< of them, that came to rest
    int out = 0;                      ///< pieces out of the limit, of the solved ones or of all linear ones
    std::optional<double> error;      ///< mm, of the rms of p95, where it is known
    bool whole = false;               ///< there is nothing more to come

    static constexpr int linearSamples = 10'000;
    /// Share of pieces that are out of the limit.
    double outShare() const;
};

/// How much is done, and what is known by then if that is more than before.
using SweepNews = std::function<void(double share, const SweepFound* found)>;

/// `news` from time to time: the share that is done, and what is known when there is more than before.
SweepFound findSweep(const SweepWanted& wanted, const SweepNews& news, const std::stop_token& stop);

} // namespace bolster
