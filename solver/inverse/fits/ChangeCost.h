// What a change of a pattern costs: without a price, freedoms that hardly matter would go anywhere.
#pragma once

#include "Freedom.h"

#include <Eigen/Core>

#include <span>

namespace bolster {

/// A form of squares of the freedoms' steps: how far they go, and how unlike their neighbours along an outline.
class ChangeCost {
public:
    /// `weight`: of one step (FitLocks::change).
    ChangeCost(const Design& design, std::span<const Freedom> freedoms, double weight);

    /// Of each freedom its step, in its own unit.
    const Eigen::VectorXd& steps() const { return m_steps; }
    Eigen::VectorXd inSteps(const Eigen::VectorXd& values) const { return values.cwiseQuotient(m_steps); }
    Eigen::VectorXd fromSteps(const Eigen::VectorXd& steps) const { return steps.cwiseProduct(m_steps); }
    /// Its squares; half of its second derivative by steps.
    const Eigen::MatrixXd& squares() const { return m_squares; }
    /// Of values in the freedoms' own units.
    double of(const Eigen::VectorXd& values) const;

private:
    Eigen::VectorXd m_steps;
    Eigen::MatrixXd m_squares;
};

} // namespace bolster
