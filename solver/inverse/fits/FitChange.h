// The change that values of freedoms are.
#pragma once

#include "Freedom.h"

#include <span>

namespace bolster {

/// How far the control points that an outline's freedoms move have moved, mm; of others their steps.
double largestChange(std::span<const Freedom> freedoms, const Eigen::VectorXd& values);

/// The design with these values of the freedoms. Where eases are free, and seams' sides differ by more or less than
/// before, that is how much they are wanted to differ.
Design withChange(const Design& design, std::span<const Freedom> freedoms, const Eigen::VectorXd& values,
                  bool easeIsFree);

} // namespace bolster
