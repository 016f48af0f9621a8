// When an iteration is near enough to its limit. The last move alone deceives (docs/solver.md, "Converged").
#pragma once

#include <deque>
#include <functional>
#include <limits>

namespace bolster {

/// Estimates the distance to the limit from successive moves: move / (1 - rho), rho being their ratio. Converged
/// when it has been below the tolerance three times in a row.
class Convergence {
public:
    explicit Convergence(double tolerance)
        : m_tolerance(tolerance)
    {}

    /// How far the surface is from where it was when this was asked last, relative to D.
    using Way = std::function<double()>;

    /// `move` of one more iteration, relative to D, and how much is left as mixing sees it, in moves. Without `way`
    /// it is taken to stay where it is. Returns whether the iteration has converged.
    bool add(double move, double left = std::numeric_limits<double>::infinity(), const Way& way = {});
    /// The moves so far: those of another kind of iteration say nothing of how fast the next ones shrink.
    void forget();
    double estimate() const { return m_estimate; }
    /// The moves have not become smaller for long, and lead nowhere; stays true for some iterations.
    bool stalled() const { return m_plainLeft > 0; }

private:
    void watchForStall(double move, const Way& way);

    double m_tolerance;
    double m_estimate = 1;
    int m_inARow = 0;
    int m_mixedInARow = 0;
    int m_count = 0;
    double m_largestOfStage = 0;
    double m_largestBefore = 0;
    double m_pathOfStage = 0;
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
