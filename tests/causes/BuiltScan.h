// Scans of pieces as they might have been built.
#pragma once

#include "CauseFinder.h"
#include "WarmCover.h"

namespace bolster::test {

/// Points about `spacing` mm from each other on a cover, with normal noise of `noise` mm in all directions, and
/// three holes that are 100 mm wide (in covers that are less than 500 mm large: a fifth of that). Another seed
/// gives other noise and holes.
FitTarget scanOf(const SurfaceMesh& built, double spacing, double noise, unsigned seed);

/// A cause and how large it is.
struct Injected {
    std::size_t cause = 0;
    Eigen::VectorXd values;
};

/// Kinds take turns; 0.4 to 1 times the most that a cause may be, upwards or downwards; of a fixation that far in
/// some direction.
Injected injected(const std::vector<Cause>& causes, unsigned seed);

/// Whether the first one is the cause, or one that is not told apart from it.
bool isFound(const Explanations& explanations, std::size_t cause);

} // namespace bolster::test
