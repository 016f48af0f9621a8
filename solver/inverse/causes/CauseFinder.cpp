#include "CauseFinder.h"

#include "CauseEvidence.h"
#include "ScanField.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bolster {

namespace {

constexpr double usualSteps = 1.5; // of a cause, until it gets no likelier
constexpr double independent = 40; // mm: noise of nearer places, and what no cause explains, is alike
constexpr double fewestPlaces = 10;
constexpr double leastNoise = 0.05; // mm
constexpr double sameField = 0.95;  // cosine
constexpr int mostSteps = 4;        // of solving a cause
constexpr double notably = 1;       // of the logarithm of how likely it is
constexpr int mostLooks = 3;        // each at as many more causes

/// What is measured at the vertices of the nominal cover that the scan shows.
struct Measured {
    std::vector<Eigen::Index> vertices;
    Eigen::VectorXd scale; ///< of rows: all of them stand for as many as there are independent places
    Eigen::VectorXd sound; ///< rows of a sound piece: what the cover is wrong by without any cause
    double places = 0;
    double covered = 0; ///< share of the area

    Eigen::VectorXd rowsOf(const auto& ofVertex) const
    {
        Eigen::VectorXd rows(scale.size());
        for (Eigen::Index k = 0; k < rows.size(); ++k)
            rows[k] = scale[k] * (ofVertex[vertices[static_cast<std::size_t>(k)]]);
        return rows;
    }
};

std::vector<Tolerance> numbersOf(const std::vector<Cause>& causes)
{
    std::vector<Tolerance> all;
    for (const Cause& cause : causes)
        all.insert(all.end(), cause.numbers.begin(), cause.numbers.end());
    return all;
}

ScanField fieldOf(const SurfaceMesh& surface, const FitTarget& scan)
{
    WorkerPool pool(0);
    return scanField(surface, scan, pool);
}

Measured measuredBy(const SurfaceMesh& surface, const std::vector<double>& outside)
{
    std::vector<double> areas(surface.positions.size(), 0);
    for (const auto& t : surface.topology->triangles) {
        const Vec3& a = surface.positions[t[0]];
        const double area = 0.5 * (surface.positions[t[1]] - a).cross(surface.positions[t[2]] - a).norm();
        for (const std::uint32_t v : t)
            areas[v] += area / 3;
    }
    Measured measured;
    std::vector<double> kept;
    for (std::size_t v = 0; v < outside.size(); ++v)
        if (!std::isnan(outside[v])) {
            measured.vertices.push_back(static_cast<Eigen::Index>(v));
            kept.push_back(areas[v]);
        }
    const Eigen::Map<const Eigen::VectorXd> area(kept.data(), std::ssize(kept));
    measured.covered = std::min(1.0, area.sum() / std::accumulate(areas.begin(), areas.end(), 0.0));
    measured.places = std::clamp(area.sum() / (independent * independent), fewestPlaces,
                                 std::max(fewestPlaces, static_cast<double>(kept.size())));
    measured.scale = (area * (measured.places / area.sum())).cwiseSqrt();
    return measured;
}

/// One cause while it is looked at.
struct Candidate {
    std::size_t cause = 0;
    CauseFit fit;
    Eigen::VectorXd numbers; ///< standard deviations
    double evidence = 0;
    double share = 0;
    bool looked = false; ///< a cover was tried
    bool solved = false;
    Eigen::VectorXd remains; ///< of the field, when solved
};

/// Solves covers of candidates where the columns say, and one step further, and keeps what is better.
class CandidateSolver {
public:
    CandidateSolver(Sweep& sweep, const std::vector<Cause>& causes, const CauseEvidence& evidence,
                    const Measured& measured, const FitTarget& scan, std::function<void(int)> news)
        : m_sweep(sweep)
        , m_causes(causes)
        , m_evidence(evidence)
        , m_measured(measured)
        , m_scan(scan)
        , m_news(std::move(news))
    {}

    /// Step by step, as long as a step makes a cause notably likelier.
    void solve(std::vector<Candidate*> candidates, const std::stop_token& stop)
    {
        for (int step = 0; step < mostSteps && !candidates.empty() && !stop.stop_requested(); ++step) {
            std::vector<Eigen::VectorXd> tried;
            std::vector<double> before;
            for (const Candidate* candidate : candidates) {
                tried.push_back(step == 0 ? rounded(candidate->cause, candidate->numbers) : next(*candidate));
                before.push_back(candidate->solved ? candidate->evidence + notably : -1e300);
            }
            solveAt(candidates, tried, stop);
            std::vector<Candidate*> better;
            for (std::size_t k = 0; k < candidates.size(); ++k)
                if (candidates[k]->solved && candidates[k]->evidence > before[k])
                    better.push_back(candidates[k]);
            candidates = std::move(better);
        }
    }

private:
    Eigen::VectorXd rounded(std::size_t cause, Eigen::VectorXd numbers) const
    {
        for (Eigen::Index k = 0; k < numbers.size(); ++k) {
            const Tolerance& tolerance = m_causes[cause].numbers[static_cast<std::size_t>(k)];
            if (tolerance.whole)
                numbers[k] = std::round(numbers[k] * tolerance.spread) / tolerance.spread;
        }
        return numbers;
    }

    Eigen::VectorXd next(const Candidate& candidate) const
    {
        const Eigen::VectorXd step =
            m_evidence.step(static_cast<int>(candidate.cause), candidate.fit, candidate.numbers, candidate.remains);
        Eigen::VectorXd there = rounded(candidate.cause, CauseEvidence::plausible(candidate.numbers + step));
        for (Eigen::Index k = 0; k < there.size(); ++k) {
            const Tolerance& tolerance = m_causes[candidate.cause].numbers[static_cast<std::size_t>(k)];
            if (tolerance.whole && there[k] == candidate.numbers[k]) // the whole number on the other side
                there[k] += std::copysign(1 / tolerance.spread, step[k]);
        }
        return there;
    }

    void solveAt(const std::vector<Candidate*>& candidates, const std::vector<Eigen::VectorXd>& tried,
                 const std::stop_token& stop)
    {
        const std::vector<Eigen::Index>& first = m_evidence.columns().first;
        std::vector<Eigen::VectorXd> numbers;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            numbers.emplace_back(Eigen::VectorXd::Zero(first.back()));
            const std::vector<Tolerance>& tolerances = m_causes[candidates[k]->cause].numbers;
            for (std::size_t n = 0; n < tolerances.size(); ++n) {
                const auto at = static_cast<Eigen::Index>(n);
                numbers.back()[first[candidates[k]->cause] + at] = tried[k][at] * tolerances[n].spread;
            }
        }
        const std::vector<SurfaceMeshPtr> covers = m_sweep.covers(numbers, stop);
        for (std::size_t k = 0; k < candidates.size(); ++k)
            if (covers[k])
                take(*candidates[k], tried[k], *covers[k]);
        m_solved += static_cast<int>(candidates.size());
        m_news(m_solved);
    }

    void take(Candidate& candidate, const Eigen::VectorXd& tried, const SurfaceMesh& cover) const
    {
        const Eigen::VectorXd& field = m_evidence.columns().field;
        Eigen::VectorXd remains = m_measured.rowsOf(fieldOf(cover, m_scan).outside) - m_measured.sound;
        for (Eigen::Index k = 0; k < remains.size(); ++k) // the scan may not show all that it showed before
            if (std::isnan(remains[k]))
                remains[k] = field[k] - candidate.fit.reached[k];
        const double evidence = m_evidence.evidence(candidate.fit, tried, remains);
        if (candidate.solved && evidence <= candidate.evidence)
            return;
        candidate.solved = true;
        candidate.evidence = evidence;
        candidate.numbers = tried;
        candidate.share = field.isZero(0) ? 0 : 1 - remains.squaredNorm() / field.squaredNorm();
        candidate.remains = std::move(remains);
    }

    Sweep& m_sweep;
    const std::vector<Cause>& m_causes;
    const CauseEvidence& m_evidence;
    const Measured& m_measured;
    const FitTarget& m_scan;
    std::function<void(int)> m_news; // covers so far
    int m_solved = 0;
};

std::vector<Candidate> candidatesOf(const CauseEvidence& evidence)
{
    std::vector<Candidate> candidates;
    const double all = evidence.columns().field.squaredNorm();
    for (int cause = 0; cause < evidence.columns().causes(); ++cause) {
        Candidate candidate;
        candidate.cause = static_cast<std::size_t>(cause);
        candidate.fit = evidence.fit(cause);
        candidate.numbers = candidate.fit.numbers;
        candidate.evidence = candidate.fit.evidence;
        candidate.share = all > 0 ? 1 - (evidence.columns().field - candidate.fit.reached).squaredNorm() / all : 0;
        candidates.push_back(std::move(candidate));
    }
    std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::evidence);
    return candidates;
}

/// Until the first ones by what is known are all solved.
void solveFirst(std::vector<Candidate>& candidates, std::size_t count, CandidateSolver& solver,
                const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        std::vector<Candidate*> unsolved;
        for (std::size_t k = 0; k < count; ++k)
            if (!std::exchange(candidates[k].looked, true))
                unsolved.push_back(&candidates[k]);
        if (unsolved.empty())
            return;
        solver.solve(std::move(unsolved), stop);
        std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::evidence);
    }
}

/// Of each candidate the causes that are alike: one of the two can be the field that the other one explains.
std::vector<std::vector<std::size_t>> alikeOf(const std::vector<Candidate>& candidates,
                                              const CauseEvidence& evidence, const std::stop_token& stop)
{
    const Eigen::Index count = std::ssize(candidates);
    Eigen::MatrixXd reached(evidence.columns().field.size(), count);
    for (Eigen::Index k = 0; k < count; ++k)
        reached.col(k) = candidates[static_cast<std::size_t>(k)].fit.reached;
    Eigen::MatrixXd likeness = Eigen::MatrixXd::Zero(count, count); // of a cause to the field of another one
    for (Eigen::Index k = 0; k < count && !stop.stop_requested(); ++k)
        likeness.row(k) =
            evidence.likeness(static_cast<int>(candidates[static_cast<std::size_t>(k)].cause), reached);
    std::vector<std::vector<std::size_t>> alike(candidates.size());
    for (Eigen::Index a = 0; a < count; ++a)
        for (Eigen::Index b = 0; b < count; ++b)
            if (a != b && std::max(likeness(a, b), likeness(b, a)) > sameField)
                alike[static_cast<std::size_t>(a)].push_back(candidates[static_cast<std::size_t>(b)].cause);
    return alike;
}

Explanation explanationOf(const Candidate& candidate, const Cause& cause)
{
    Explanation explanation;
    explanation.cause = candidate.cause;
    explanation.values = candidate.numbers;
    explanation.spreads = candidate.fit.covariance.diagonal().cwiseSqrt();
    for (Eigen::Index k = 0; k < explanation.values.size(); ++k) {
        const Tolerance& tolerance = cause.numbers[static_cast<std::size_t>(k)];
        const double spread = tolerance.spread * unitOf(tolerance);
        explanation.values[k] *= spread;
        explanation.spreads[k] *= spread;
    }
    explanation.evidence = candidate.evidence;
    explanation.share = candidate.share;
    explanation.solved = candidate.solved;
    return explanation;
}

/// One cause or none, each as likely beforehand. What the best one leaves beyond noise is something else, smooth,
/// which has as many independent places as the fewest: of several things at once no one is sure because it explains
/// a little more than the next.
void addProbabilities(Explanations& result, double places)
{
    const double beyond = result.ranked.empty() ? 0 : std::max(0.0, result.leftBy(result.ranked.front().share) - 1);
    const double louder = 1 + beyond * places / fewestPlaces; // than noise, in mean squares
    double most = 0, sum = 0;
    for (const Explanation& one : result.ranked)
        most = std::max(most, one.evidence);
    for (Explanation& one : result.ranked) {
        sum += one.probability = std::exp((one.evidence - most) / louder);
        one.spreads *= std::sqrt(louder);
    }
    result.none = std::exp(-most / louder);
    sum += result.none;
    result.none /= sum;
    for (Explanation& one : result.ranked)
        one.probability /= sum;
}

} // namespace

CauseFinder::CauseFinder(const SolveInput& input, const ExplainOrder& order,
                         const std::function<void(double)>& progress, const std::stop_token& stop)
    : m_causes(possibleCauses(withoutTwins(input.design)))
    , m_sweep({withoutTwins(input.design), input.files}, {.all = numbersOf(m_causes)}, order.threads, stop,
              order.edgeLength)
    , m_solved(order.solved)
{
    m_first.push_back(0);
    for (const Cause& cause : m_causes)
        m_first.push_back(m_first.back() + std::ssize(cause.numbers));
    if (m_sweep.nominal())
        m_linear = m_sweep.linear(progress, stop);
}

Explanations CauseFinder::explain(const FitTarget& scan, const FitTarget& sound,
                                  const std::function<void(double)>& progress, const std::stop_token& stop)
{
    Explanations result;
    const ScanField field = fieldOf(*nominal(), scan);
    std::vector<double> expected(field.outside.size(), 0);
    if (!sound.empty())
        expected = fieldOf(*nominal(), sound).outside;
    std::vector<double> outside = field.outside;
    for (std::size_t v = 0; v < outside.size(); ++v)
        outside[v] -= expected[v];
    Measured measured = measuredBy(*nominal(), outside);
    if (measured.vertices.empty())
        return result;
    measured.sound = measured.rowsOf(expected);
    CauseColumns columns{.field = measured.rowsOf(outside), .up = {}, .down = {}, .first = m_first};
    columns.up.resize(columns.field.size(), m_first.back());
    columns.down.resize(columns.field.size(), m_first.back());
    const auto moved = [&](Eigen::Index column) { // evaluated: rows of a product would be whole products each
        return Eigen::VectorXd(field.mean * m_linear.col(column).cast<double>().eval());
    };
    for (Eigen::Index k = 0; k < m_first.back() && !stop.stop_requested(); ++k) {
        columns.up.col(k) = measured.rowsOf(moved(2 * k));
        columns.down.col(k) = measured.rowsOf(moved(2 * k + 1));
    }
    result.covered = measured.covered;
    result.rms = std::sqrt(columns.field.squaredNorm() / measured.places);
    const CauseEvidence evidence(std::move(columns), measured.places, leastNoise, stop);
    if (stop.stop_requested())
        return result;
    result.noise = evidence.noise();
    std::vector<Candidate> candidates = candidatesOf(evidence);
    CandidateSolver solver(m_sweep, m_causes, evidence, measured, scan, [&](int covers) {
        if (progress)
            progress(1 - std::pow(0.5, covers / (usualSteps * m_solved)));
    });
    // Cloth that gets slack does not do what derivatives say: where the best one leaves much, more are looked at.
    std::size_t looked = 0;
    for (int round = 1; round <= mostLooks && !stop.stop_requested(); ++round) {
        looked = std::min(static_cast<std::size_t>(round) * m_solved, candidates.size());
        solveFirst(candidates, looked, solver, stop);
        if (result.leftBy(candidates.empty() ? 0 : candidates.front().share) < Explanations::muchLeft)
            break;
    }
    std::vector<std::vector<std::size_t>> alike = alikeOf(candidates, evidence, stop);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        result.ranked.push_back(explanationOf(candidates[k], m_causes[candidates[k].cause]));
        result.ranked.back().alike = std::move(alike[k]);
    }
    addProbabilities(result, measured.places);
    return result;
}

} // namespace bolster
