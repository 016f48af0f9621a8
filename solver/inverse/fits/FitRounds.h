// The rounds of a fit on given triangles: derivatives of the cover, steps with them, and what they reach.
#pragma once

#include "BoundedStep.h"
#include "ChangeCost.h"
#include "CoarseDerivatives.h"
#include "FitRows.h"
#include "PatternFit.h"
#include "RowModel.h"

#include <functional>
#include <memory>
#include <stop_token>

namespace bolster {

/// Values and design of a result go on from where they are, and only to what is better. What is said on the way
/// (rounds, notes, idle freedoms, the reason of a failure) goes into the result, too.
class FitRounds {
public:
    /// `fewEdge`: of the triangles that derivatives may come from while others are tried, mm. `tell`: the share of
    /// the rounds that is done. All but `tell` are to outlive this.
    FitRounds(const SolveInput& input, const FitOrder& order, double fewEdge, FitResult& result,
              std::function<void(double)> tell, const std::stop_token& stop);

    static constexpr double restTolerance = 1e-5; ///< of covers on the way, relative to D
    static constexpr double nearly = 1.03;        ///< times the cost: as good
    static constexpr double firstDamping = 1e-3;  ///< of derivatives that are new

    /// Covers on few triangles move as those on more do: derivatives come from them.
    void setFewAreLike(bool are) { m_fewAreLike = are; }
    bool areFewLike() const { return m_fewAreLike; }
    /// Strains and folds are of single triangles: what these do, no others tell.
    bool isAboutPlaces() const { return !m_order.goals.strain && m_order.goals.smooth.empty(); }
    /// What the derivatives of such covers say holds beyond a step.
    bool followsForm() const { return isAboutPlaces() && !m_order.goals.target.empty(); }

    FitRows& rows() { return m_rows; }
    Design designAt(const Eigen::VectorXd& values) const;
    void take(const Eigen::VectorXd& values);
    /// The cover of a design as it comes to rest by itself; null when it has none. `edge`: of its triangles, mm.
    std::unique_ptr<WarmCover> coverOf(const Design& design, double edge, double tolerance = restTolerance);
    /// Of a cover, its places being aimed at the goals anew.
    double costOn(const WarmCover& cover, const Eigen::VectorXd& values, const Design& design);

    /// Rounds until they lead no farther. `few`: more triangles follow. False when there is no cover, or when
    /// stopped.
    bool run(double edge, bool few);
    /// The derivatives that are known do for covers that lie near: steps with them from where a cover has come to
    /// rest by itself. False when they lead nowhere.
    bool goOnFrom(WarmCover& cover, double damping = firstDamping);
    /// The cost that the last rounds have come to.
    double reached() const { return m_reached; }
    /// False; says why, unless it has been stopped.
    bool fail(Message reason);

private:
    enum class Outcome { Better, Settled };

    double costOf(const Eigen::VectorXd& rows, const Eigen::VectorXd& values) const;
    WarmOrder orderFor(double edge) const;
    CoarseDerivatives::Measure measure() const;
    std::unique_ptr<WarmCover> beginRounds(double edge, double derivativesEdge);
    Outcome step(WarmCover& cover, double& damping, int round, bool few);
    void aimAgain(WarmCover& cover, double damping);
    double takeSteps(WarmCover& cover, RowModel& model, Eigen::VectorXd& now, double cost, double& damping);
    bool takeStep(WarmCover& cover, RowModel& model, Eigen::VectorXd& now, double& cost, double& damping);
    bool isWhole(const Design& design);
    double leastGain(bool few) const;
    void noteIdle(const Eigen::MatrixXd& jacobian, const std::vector<bool>& known);
    void report(const WarmCover& cover, double edge, bool few, double share);

    const SolveInput& m_input;
    const FitOrder& m_order;
    const std::stop_token& m_stop;
    const std::function<void(double)> m_tell;
    const double m_fewEdge; // mm
    const ChangeCost m_change;
    const StepBounds m_bounds; // in steps
    FitResult& m_result;
    FitRows m_rows;
    std::unique_ptr<CoarseDerivatives> m_derivatives;
    double m_reached = 0;  // cost of the last round
    double m_promised = 0; // by which derivatives would make it less in one step
    bool m_fewAreLike = false;
};

} // namespace bolster
