#include "BoundedStep.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bolster {

namespace {

constexpr int mostMeetings = 5;       // rounds in which unknowns meet their bounds
constexpr double dampedAlike = 1e-3;  // times the mean of the diagonal: what does nothing is damped, too
constexpr double withinBounds = 1e-9; // relative

/// The least of the form of squares where some unknowns are held at what `step` has.
Eigen::VectorXd leastWith(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& slope,
                          const std::vector<bool>& held, const Eigen::VectorXd& step)
{
    Eigen::MatrixXd free = matrix;
    Eigen::VectorXd right = -slope;
    for (Eigen::Index k = 0; k < slope.size(); ++k) {
        if (!held[static_cast<std::size_t>(k)])
            continue;
        right -= matrix.col(k) * step[k];
        free.row(k).setZero();
        free.col(k).setZero();
        free(k, k) = 1;
    }
    for (Eigen::Index k = 0; k < slope.size(); ++k)
        if (held[static_cast<std::size_t>(k)])
            right[k] = step[k];
    return free.ldlt().solve(right);
}

} // namespace

Eigen::VectorXd boundedStep(const Eigen::MatrixXd& squares, const Eigen::VectorXd& slope, double damping,
                            const Eigen::VectorXd& from, const StepBounds& bounds)
{
    const double mean = squares.diagonal().mean();
    Eigen::MatrixXd matrix = squares;
    matrix.diagonal() +=
        damping * (squares.diagonal() + Eigen::VectorXd::Constant(slope.size(), dampedAlike * mean));
    std::vector<bool> held(static_cast<std::size_t>(slope.size()), false);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.size());
    for (int round = 0; round < mostMeetings; ++round) { // who meets a bound stays there
        step = leastWith(matrix, slope, held, step);
        bool met = false;
        for (Eigen::Index k = 0; k < slope.size(); ++k) {
            const double bounded = std::clamp(from[k] + step[k], bounds.least[k], bounds.most[k]);
            if (std::abs(from[k] + step[k] - bounded) <= withinBounds * (1 + std::abs(bounded)))
                continue;
            step[k] = bounded - from[k];
            held[static_cast<std::size_t>(k)] = met = true;
        }
        if (!met)
            break;
    }
    return from + step;
}

} // namespace bolster
