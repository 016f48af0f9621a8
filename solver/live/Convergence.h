// When an iteration is near enough to its limit. The last move alone deceives (docs/solver.md, "Converged").
#pragma once

#include <deque>
#include <limits>

namespace bolster {

/// Estimates the distance to the limit from successive moves: move / (1 - rho), rho being their ratio. Converged
/// when it has been below the tolerance three times in a row.
class Convergence {
public:
    explicit Convergence(double tolerance)
        : m_tolerance(tolerance)
    {}

    /// `move` of one more iteration, relative to D, and how much is left as mixing sees it, in moves. Returns
    /// whether the iteration has converged.
    bool add(double move, double left = std::numeric_limits<double>::infinity());
    /// The moves so far: those of another kind of iteration say nothing of how fast the next ones shrink.
    void forget();
    double estimate() const { return m_estimate; }
    /// The moves have not become smaller for long; stays true for some iterations.
    bool stalled() const { return m_plainLeft > 0; }

private:
    void watchForStall(double move);

    double m_tolerance;
    double m_estimate = 1;
    int m_inARow = 0;
    int m_mixedInARow = 0;
    int m_count = 0;
    double m_largestOfStage = 0;
    double m_largestBefore = 0;
    int m_plainLeft = 0;
    std::deque<double> m_moves;
};

/// When a fit has settled: its misfit changes by less than 0.1 % over 10 steps, in the mean of 10. Its targets
/// switch from point to point, so that neither its moves nor its misfit ever stand still.
class FitConvergence {
public:
    /// `misfit` after one more iteration; any unit. Returns whether the fit has settled.
    bool add(double misfit);

private:
    std::deque<double> m_misfits;
};

} // namespace bolster
