// Which cause explains best how far a built piece lies from its design.
#pragma once

#include "Causes.h"
#include "FitGoals.h"
#include "Sweep.h"

namespace bolster {

struct ExplainOrder {
    double edgeLength = 0; ///< of the triangles, mm; 0: the design's
    int solved = 5;  ///< of how many causes covers are solved, after a look at all by derivatives; up to three
                     ///< times as many where the best leaves much
    int threads = 0; ///< 0: as many as the machine has
};

struct Explanation {
    std::size_t cause = 0;          ///< in CauseFinder::causes
    Eigen::VectorXd values;         ///< the likeliest, as many as the cause has numbers, in its unit
    Eigen::VectorXd spreads;        ///< standard deviation of each, when the scan is known and this is the cause
    double evidence = 0;            ///< logarithm: how much likelier the scan is with this cause than with none
    double share = 0;               ///< of the mean square of the deviation that it explains
    double probability = 0;         ///< if it is one cause or none, and each is as likely beforehand
    bool solved = false;            ///< by a cover; else as if covers were linear
    std::vector<std::size_t> alike; ///< causes that the scan does not tell apart from this one
};

struct Explanations {
    double rms = 0;     ///< mm: of the deviation
    double noise = 0;   ///< mm: what remains of it with all causes together
    double covered = 0; ///< share of the cover that the scan shows
    double none = 0;    ///< probability that it is none of the causes
    std::vector<Explanation> ranked;

    /// Most of the deviation is like nothing that a cause does: what the cover gets wrong drowns a small one.
    bool mostlyUnexplained() const { return !nothing() && 2 * noise * noise > rms * rms; }
    /// The scan lies on the cover.
    bool nothing() const { return rms < 0.05; }
    /// The likeliest cause explains less than half: how probable it is says little then, as that is of one cause.
    bool weak() const { return !ranked.empty() && 2 * ranked.front().share < 1; }
    /// The likeliest cause explains most, but leaves more than noise: something else is wrong, too, and what is
    /// said of its amount may be off by more than its spread.
    bool leavesMore() const { return !ranked.empty() && !weak() && leftBy(ranked.front().share) > muchLeft; }
    /// What a cause leaves of the deviation that explains such a share, in mean squares of the noise.
    double leftBy(double share) const { return rms * rms * (1 - share) / (noise * noise); }
    static constexpr double muchLeft = 2;
};

/// Covers of one design beside each cause. Not for several threads at once; uses several itself.
class CauseFinder {
public:
    CauseFinder(const SolveInput& input, const ExplainOrder& order,
                const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

    /// Why there is no cover; empty when there is one.
    const Message& problem() const { return m_sweep.problem(); }
    const std::vector<Cause>& causes() const { return m_causes; }
    SurfaceMeshPtr nominal() const { return m_sweep.nominal(); }
    /// Bayes for one cause at a time: normal priors, white noise whose size is what all causes together leave. The
    /// best are solved and step once more from there. `sound`: the scan of a piece that is as it should be, when
    /// there is one: what covers get wrong is no cause. Nothing is ranked when the scan shows nothing of the cover.
    /// How much there is to be solved shows on the way: `progress` goes towards 1 by less and less.
    Explanations explain(const FitTarget& scan, const FitTarget& sound = {},
                         const std::function<void(double)>& progress = {}, const std::stop_token& stop = {});

private:
    std::vector<Cause> m_causes;
    std::vector<Eigen::Index> m_first; // of all numbers, each cause's
    Sweep m_sweep;
    Eigen::MatrixXf m_linear;
    int m_solved;
};

} // namespace bolster
