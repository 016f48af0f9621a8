// The same cover once for each processor, so that many designs that differ a little are solved side by side.
#pragma once

#include "Freedom.h"
#include "WarmCover.h"

#include <functional>
#include <memory>
#include <vector>

namespace bolster {

class CoverTeam {
public:
    /// `threads`: 0: as many as the machine has; results do not depend on it.
    CoverTeam(const SolveInput& input, WarmOrder order, int threads, const std::stop_token& stop = {});

    /// Empty when all are at rest at home.
    const Message& problem() const { return m_covers.front()->problem(); }
    const WarmCover& first() const { return *m_covers.front(); }
    WarmCover& first() { return *m_covers.front(); }
    bool moveHome(const Design& design, const std::stop_token& stop = {});
    /// Calls work(cover, task) for 0 .. count - 1, each once, several at a time.
    void forTasks(int count, const std::function<void(WarmCover&, int)>& work);

private:
    std::vector<std::unique_ptr<WarmCover>> m_covers;
};

/// What is measured of a cover, as a row of numbers that is as long for all covers on the same triangles.
using CoverMeasure = std::function<Eigen::VectorXd(const WarmCover&, const Design&)>;

struct Derivatives {
    Eigen::MatrixXd columns; ///< of the measure, by each freedom, in its own unit
    std::vector<bool> known; ///< false: there was no cover beside the present one; its column is 0
};

/// By how much a freedom is changed to see what it does: beside a limit to the side where there is room.
double usualStep(const Freedom& freedom);

/// By differences of covers at rest beside that of `at`, the design at home: forward ones, or central ones, which
/// take twice the time. When stopped they are not all there.
Derivatives differentiate(CoverTeam& team, const Design& at, std::span<const Freedom> freedoms,
                          const CoverMeasure& measure, bool central,
                          const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

/// The vertices of a cover's surface, mm; those that are sewn together once for each patch.
std::vector<Vec3> vertexPlaces(const WarmCover& cover);
/// Where all unknowns of a cover are, mm: x y z after each other.
Eigen::VectorXd placesOf(const WarmCover& cover);

} // namespace bolster
