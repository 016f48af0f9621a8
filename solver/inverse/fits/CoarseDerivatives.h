// Derivatives of a cover from covers on fewer triangles: these move nearly alike, and cost a fraction of the time.
#pragma once

#include "CoverTeam.h"

namespace bolster {

class CoarseDerivatives {
public:
    /// What is measured of a cover: of its triangles and where they lie in the pattern, of the places of its
    /// vertices, and of its design.
    using Measure = std::function<Eigen::VectorXd(const SurfaceTopology& topology, const std::vector<Vec3>& places,
                                                  const Design& design)>;

    /// `order`: of the covers on fewer triangles. `threads`: 0: as many as the machine has; results do not depend
    /// on it.
    CoarseDerivatives(const SolveInput& input, const WarmOrder& order, int threads,
                      const std::stop_token& stop = {});

    /// Empty when they are at rest at home.
    const Message& problem() const { return m_team.problem(); }
    /// Goes to another design, as WarmCover does. It goes there by itself when it is asked about it; in small steps
    /// it gets there on the same triangles.
    bool moveHome(const Design& design, const std::stop_token& stop = {}) { return m_team.moveHome(design, stop); }
    /// Of the measure of `fine`, at rest at the design `at`, by each freedom, in its own unit.
    Derivatives of(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                   const Measure& measure, const std::function<void(double)>& progress = {},
                   const std::stop_token& stop = {});
    /// The same from the covers that were found the last time, of a design near by; empty when these have got other
    /// triangles since.
    Derivatives again(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                      const Measure& measure, const std::stop_token& stop = {});

private:
    Derivatives carriedTo(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                          const Measure& measure, const std::stop_token& stop);

    CoverTeam m_team;
    Derivatives m_few; // on few triangles, of the places of their vertices
};

} // namespace bolster
