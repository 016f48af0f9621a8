// The change that values of freedoms are: how large it is, and the eases that follow from it.
#pragma once

#include "Freedom.h"

#include <span>

namespace bolster {

/// How far the control points that an outline's freedoms move have moved, mm; of others their steps.
double largestChange(std::span<const Freedom> freedoms, const Eigen::VectorXd& values);

/// Where seams' sides differ by more or less than before, that is how much they are wanted to differ.
Design withEases(const Design& before, const Design& changed);

} // namespace bolster
