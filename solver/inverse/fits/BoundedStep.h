// A damped step of least squares, within bounds.
#pragma once

#include <Eigen/Core>

namespace bolster {

/// Where unknowns may be, each in its own unit.
struct StepBounds {
    Eigen::VectorXd least, most;
};

/// Where a step leads to from `from`, which lies within `bounds`: it makes step' squares step / 2 + slope' step
/// least, with Levenberg's damping (1: of the squares' diagonal), each unknown as far as it may go. All in the
/// units of the unknowns; `squares` is symmetric and positive.
Eigen::VectorXd boundedStep(const Eigen::MatrixXd& squares, const Eigen::VectorXd& slope, double damping,
                            const Eigen::VectorXd& from, const StepBounds& bounds);

} // namespace bolster
