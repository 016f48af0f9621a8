#include "PatternFit.h"

#include "DesignCheck.h"
#include "FitRows.h"
#include "PatternSize.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace bolster {

namespace {

constexpr double fewVertices = 3000;   // of the first triangles, about
constexpr double manyVertices = 12000; // of the last ones
constexpr double alike = 0.2;          // what few triangles have led to leaves so much of the cost on more of them
constexpr double farFromFew = 4;       // times what few triangles have reached: they are not alike
constexpr double restTolerance = 1e-5; // relative to D
constexpr double worthIt = 1.7;        // times as many vertices as before
constexpr double settled = 0.03;       // a round that makes less of the error than that is the last one
constexpr double settledPlaces = 0.1;  // likewise where the cover lies
constexpr double settledFew = 0.3;     // likewise, where more triangles follow
constexpr double settledStep = 0.05;   // likewise of a step
constexpr double stuckPromise = 0.5;   // of the cost: what no step kept of it is worth shorter ones
constexpr double leastPromise = 0.01;  // what a step must promise to be tried
constexpr int mostIterations = 600;    // of a cover beside the present one: others are farther away than is tried
constexpr int iterationsBeside = 40;   // of covers that derivatives are taken from: they take some 15
constexpr int mostStepsOfRound = 5;
constexpr int mostAims = 3;
constexpr int mostAttempts = 5;
constexpr int mostVerifications = 10, fewVerifications = 4;
constexpr int mostImprovements = 2;  // on the way
constexpr double leastWorth = 0.999; // times the cost of the pattern as it was: else nothing is gained by a change
constexpr double sprang = 1.5;       // times the cost that the last round had: the cover has come to rest elsewhere
constexpr double nearly = 1.03;      // times the cost: as good,
constexpr double asGood = 1.25;      // or not worth more time
constexpr double leastWantedEase = 0.05, mostWantedEase = 1000; // mm
constexpr double leastEffect = 1e-7;                            // of a freedom, against the strongest one

/// Lengths of edges, mm: the last one is the design's, or what is as fine as it need be.
std::vector<double> edgesFor(const Design& design)
{
    const double area = patternArea(design);
    const double last = std::max(design.settings().edgeLength, edgeLengthFor(area, manyVertices));
    const double first = edgeLengthFor(area, fewVertices);
    return first * first > worthIt * last * last ? std::vector{first, last} : std::vector{last};
}

/// Rows of second differences along an outline: what moves points shall move their neighbours alike.
std::vector<Eigen::Triplet<double>> smoothRows(const Design& design, std::span<const Freedom> freedoms, int& count)
{
    std::map<std::pair<ElementId, int>, std::vector<Eigen::Index>> at; // freedoms of each control point
    for (std::size_t k = 0; k < freedoms.size(); ++k)
        if (freedoms[k].kind == Freedom::Kind::OutlinePoint)
            at[{freedoms[k].element, freedoms[k].index}].push_back(static_cast<Eigen::Index>(k));
    std::vector<Eigen::Triplet<double>> entries;
    count = 0;
    for (const auto& [point, here] : at) {
        if (here.size() != 1)
            continue; // a corner
        const auto& [patch, index] = point;
        const int points = design.find<Patch>(patch)->outline.pointCount();
        const Vec2 direction = freedoms[static_cast<std::size_t>(here.front())].direction;
        for (const auto& [offset, weight] : {std::pair(-1, 1.0), std::pair(0, -2.0), std::pair(1, 1.0)})
            if (const auto found = at.find({patch, (index + offset + points) % points}); found != at.end())
                for (const Eigen::Index k : found->second)
                    entries.emplace_back(count, k,
                                         weight * freedoms[static_cast<std::size_t>(k)].direction.dot(direction));
        ++count;
    }
    return entries;
}

/// What is reckoned with holds more than what is asked for: sides of seams that come nearer to each other are no
/// help when the cover has gone farther from the form, nor is strain below the limit when more is over it.
bool isAsWanted(const FitGoals& goals, const FitFigures& before, const FitFigures& after)
{
    if (goals.isLimitAlone())
        return after.overLimit < before.overLimit ||
               (after.overLimit == before.overLimit && after.strainRms < before.strainRms);
    if (goals.isSmoothnessAlone())
        return after.pressed < before.pressed;
    return !goals.isFormAlone() || after.distanceRms < before.distanceRms;
}

class Fit {
public:
    Fit(const SolveInput& input, const FitOrder& order,
        const std::function<void(double, const FitRound&)>& progress, const std::stop_token& stop)
        : m_input(input)
        , m_order(order)
        , m_progress(progress)
        , m_stop(stop)
        , m_rows(order.goals, order.locks, input.design)
    {
        m_result.design = input.design;
        m_result.values = Eigen::VectorXd::Zero(std::ssize(order.freedoms));
        m_scale.resize(std::ssize(order.freedoms));
        for (Eigen::Index k = 0; k < m_scale.size(); ++k)
            m_scale[k] = order.freedoms[static_cast<std::size_t>(k)].step;
        int count = 0;
        const auto entries = smoothRows(input.design, order.freedoms, count);
        Eigen::SparseMatrix<double> rows(count, m_scale.size());
        rows.setFromTriplets(entries.begin(), entries.end());
        m_change = 4 * Eigen::MatrixXd(rows.transpose() * rows);
        m_change.diagonal().array() += 1;
        m_change *= order.locks.change * order.locks.change;
    }

    FitResult run()
    {
        const std::vector<double> edges = edgesFor(m_input.design);
        m_stages = static_cast<int>(edges.size()) + 1;
        m_fewEdge = edges.front();
        // What is below the limits already need not be changed for them; other goals are never reached wholly.
        if (m_order.goals.isLimitAlone() && begin(edges.back()) && m_result.before.overLimit == 0) {
            m_result.after = m_result.before;
            m_result.status = FitResult::Status::NothingToDo;
            return std::move(m_result);
        }
        bool whole = m_result.reason.empty() && begin(edges.front());
        for (m_stage = 0; whole && m_stage < m_stages - 1; ++m_stage)
            whole =
                goOn(edges[static_cast<std::size_t>(m_stage)]) && improve(edges[static_cast<std::size_t>(m_stage)]);
        if (whole && verify(edges.back()) && goFarther(edges.back()))
            m_result.status = m_result.values.isZero() ? FitResult::Status::NothingToDo : FitResult::Status::Done;
        if (m_stop.stop_requested())
            m_result.status = FitResult::Status::Cancelled;
        if (m_result.status == FitResult::Status::Cancelled || m_result.status == FitResult::Status::Failed) {
            m_result.design = m_input.design;
            m_result.values.setZero();
        }
        return std::move(m_result);
    }

private:
    bool fail(Message reason)
    {
        if (!m_stop.stop_requested())
            m_result.reason = std::move(reason);
        return false;
    }

    /// What is to be small: rows of goals, and of the change.
    double costOf(const Eigen::VectorXd& rows, const Eigen::VectorXd& values) const
    {
        return rows.squaredNorm() + changeCost(values);
    }

    double changeCost(const Eigen::VectorXd& values) const
    {
        const Eigen::VectorXd steps = values.cwiseQuotient(m_scale);
        return steps.dot(m_change * steps);
    }

    WarmOrder orderFor(double edge) const
    {
        WarmOrder order;
        order.edgeLength = edge;
        order.tolerance = restTolerance;
        if (isAboutPlaces())
            order.mostWarmIterations = mostIterations;
        return order;
    }

    /// The cover of a design as it comes to rest by itself; null when it has none.
    std::unique_ptr<WarmCover> coverOf(const Design& design, double edge, double tolerance = restTolerance)
    {
        WarmOrder order = orderFor(edge);
        order.tolerance = tolerance;
        order.threads = m_order.threads;
        auto cover = std::make_unique<WarmCover>(SolveInput(design, m_input.files), order, m_stop);
        if (cover->hasHome())
            return cover;
        fail(cover->problem());
        return nullptr;
    }

    Design designAt(const Eigen::VectorXd& values) const
    {
        const Design design = withFreedoms(m_input.design, m_order.freedoms, values);
        return m_order.locks.ease ? design : withEases(m_input.design, design);
    }

    bool begin(double edge)
    {
        const auto cover = coverOf(m_input.design, edge);
        if (!cover || m_stop.stop_requested())
            return false;
        m_rows.keep(*cover);
        m_result.before = m_rows.figures(*cover, m_input.design);
        if (!m_order.goals.target.empty() && m_result.before.covered == 0 && !m_order.goals.area.isAll())
            return fail(
                {QT_TRANSLATE_NOOP("Message", "No vertex of the area is near the form: make the area larger "
                                              "than the mesh edges, or put the form where the cover is."),
                 {}});
        if (!m_order.goals.target.empty() && m_result.before.covered == 0)
            return fail({QT_TRANSLATE_NOOP("Message", "No place of the cover is near the form: put it where the "
                                                      "cover is, in millimetres."),
                         {}});
        return true;
    }

    double costOn(const WarmCover& cover, const Eigen::VectorXd& values, const Design& design)
    {
        m_rows.aim(cover);
        return costOf(m_rows.rows(cover, design), values);
    }

    /// From what fewer triangles have led to, or nothing, or else half of it: what is best on these.
    bool goOn(double edge)
    {
        if (m_stage == 0)
            return true;
        const Eigen::VectorXd found = m_result.values;
        double least = std::numeric_limits<double>::infinity(), untouched = 0;
        for (const double share : {0.0, 1.0, 0.5}) {
            if (share == 0.5 && m_result.values == found && isAboutPlaces())
                break; // all of it is better than nothing
            const Eigen::VectorXd values = share * found;
            const Design design = designAt(values);
            const auto cover = coverOf(design, edge);
            if (!cover || m_stop.stop_requested())
                return false;
            if (share == 0) {
                m_rows.keep(*cover);
                m_result.before = m_rows.figures(*cover, design);
            }
            if (const double cost = costOn(*cover, values, design); cost < least) {
                least = cost;
                m_result.values = values;
                m_result.design = design;
            }
            untouched = share == 0 ? least : untouched;
        }
        m_untouched = untouched;
        m_fewAreLike = isAboutPlaces() && least < alike * untouched && least < farFromFew * m_reached;
        return true;
    }

    /// With the derivatives of few triangles, and if these have been much nearer than they lead to here, with own
    /// ones.
    bool improve(double edge)
    {
        const double onFew = m_reached;
        if (!goRounds(edge) || !m_fewAreLike || m_reached < sprang * onFew)
            return !m_stop.stop_requested() && m_result.reason.empty();
        m_fewAreLike = false;
        return goRounds(edge);
    }

    /// The cover of the present pattern as it comes to rest by itself, and what derivatives come from; null when
    /// there is none.
    std::unique_ptr<WarmCover> beginRounds(double edge)
    {
        std::unique_ptr<WarmCover> cover = coverOf(m_result.design, edge);
        if (!cover || m_stop.stop_requested())
            return nullptr;
        WarmOrder beside = orderFor(m_fewAreLike ? m_fewEdge : edge);
        beside.iterationsBeside = iterationsBeside;
        const SolveInput here{m_result.design, m_input.files};
        auto derivatives = std::make_unique<CoarseDerivatives>(here, beside, m_order.threads, m_stop);
        if (!derivatives->problem().empty()) {
            fail(derivatives->problem());
            return nullptr;
        }
        m_derivatives = std::move(derivatives);
        return cover;
    }

    /// Rounds until they lead no farther.
    bool goRounds(double edge)
    {
        std::unique_ptr<WarmCover> cover = beginRounds(edge);
        if (!cover)
            return false;
        double damping = 1e-3;
        bool anew = false, shorter = false;
        for (int round = 0; round < m_order.mostRounds; ++round) {
            // It may be where the last try has left it.
            if (m_stop.stop_requested() || !cover->follow(m_result.design, m_stop))
                return false;
            report(*cover, edge, doneAfter(round));
            const Outcome outcome = step(*cover, damping, round);
            if (!m_result.reason.empty())
                return false;
            if (outcome == Outcome::Better)
                continue;
            if (!followsForm() || m_promised <= stuckPromise * m_reached)
                break;
            // What is promised does not come: by itself the cover may rest where it does.
            std::unique_ptr<WarmCover> own = std::exchange(anew, true) ? nullptr : beginRounds(edge);
            if (own) {
                cover = std::move(own);
                damping = 1e-3;
            } else if (std::exchange(shorter, true)) {
                break; // else with the shorter steps that damping has come to
            }
            m_result.reason = {}; // it has none
        }
        if (!m_stop.stop_requested() && cover->follow(m_result.design, m_stop))
            report(*cover, edge, 1);
        return !m_stop.stop_requested();
    }

    /// What counts is the cover of the changed pattern as it comes to rest by itself: that it was found on the way
    /// may have led to other folds. Then it goes on from there; and when that leads nowhere not as far, half the
    /// way to what is good or to the pattern as it was.
    bool verify(double edge, int most = mostVerifications)
    {
        Eigen::VectorXd best = Eigen::VectorXd::Zero(m_result.values.size());
        double least = leastWorth * untouchedCost(edge), reached = m_reached;
        int improvements = 0;
        m_result.after = m_result.before;
        for (int round = 0; round < most && m_result.values != best; ++round) {
            const auto cover = coverOf(m_result.design, edge, WarmOrder().tolerance);
            if (!cover || m_stop.stop_requested())
                return false;
            reached = std::min(reached, m_reached);
            const double cost = costOn(*cover, m_result.values, m_result.design);
            if (!(cost < least)) {
                m_fewAreLike = false;
                if (round > 0)
                    take(0.5 * (best + m_result.values));
                else if (!improve(edge))
                    break;
                continue;
            }
            least = cost;
            best = m_result.values;
            m_result.after = m_rows.figures(*cover, m_result.design);
            if (cost < nearly * reached)
                break;
            if (followsForm() && cost < sprang * reached && goOnFrom(*cover)) // else it has other folds
                continue;
            if (cost < asGood * reached || ++improvements > mostImprovements)
                break;
            m_fewAreLike = false; // they have led elsewhere
            if (!improve(edge))
                break;
        }
        m_result.jumped = least >= sprang * reached;
        if (!isAsWanted(m_order.goals, m_result.before, m_result.after)) {
            best.setZero();
            m_result.after = m_result.before;
        }
        if (best.isZero())
            m_result.after.shapeRms = 0;
        take(best);
        return !m_stop.stop_requested();
    }

    /// From what is found for a limit alone: squares of still smaller strains see still more of what is just over
    /// it, but only near to what is good already they do not lead to another cover. False when it has been stopped.
    bool goFarther(double edge)
    {
        if (!m_order.goals.isLimitAlone() || m_result.values.isZero() || m_result.after.overLimit == 0)
            return !m_stop.stop_requested();
        FitResult found = m_result;
        m_rows.strainFrom(FitRows::farBelowLimit);
        m_untouched.reset();
        const bool whole = improve(edge) && verify(edge, fewVerifications);
        if (m_stop.stop_requested())
            return false;
        const bool keepsShape =
            m_result.after.shapeRms <= std::max(m_order.goals.shapeWithin, found.after.shapeRms);
        if (!whole || m_result.jumped || !keepsShape || !(m_result.after.overLimit < found.after.overLimit)) {
            found.rounds = std::move(m_result.rounds);
            m_result = std::move(found);
        }
        return true;
    }

    void take(const Eigen::VectorXd& values)
    {
        m_result.values = values;
        m_result.design = designAt(values);
    }

    /// The derivatives that are known do for covers that lie near: steps with them from where a cover has come to
    /// rest by itself. False when they lead nowhere.
    bool goOnFrom(WarmCover& cover)
    {
        const Derivatives derivatives =
            m_derivatives->again(cover, m_result.design, m_order.freedoms, measure(), m_stop);
        if (derivatives.columns.size() == 0 || m_stop.stop_requested())
            return false;
        Eigen::MatrixXd jacobian = derivatives.columns * m_scale.asDiagonal();
        Eigen::VectorXd now = m_rows.rows(cover, m_result.design);
        const double cost = costOf(now, m_result.values);
        double damping = 1e-3;
        return nearly * takeSteps(cover, jacobian, now, cost, damping) < cost;
    }

    /// Of the pattern as it was, on the last triangles; infinite when it has no cover there.
    double untouchedCost(double edge)
    {
        if (m_untouched)
            return *m_untouched;
        const auto cover = coverOf(m_input.design, edge);
        return cover && !m_stop.stop_requested()
                   ? costOn(*cover, Eigen::VectorXd::Zero(m_result.values.size()), m_input.design)
                   : std::numeric_limits<double>::infinity();
    }

    void report(const WarmCover& cover, double edge, double share)
    {
        m_result.rounds.push_back({edge, m_stage < m_stages - 2, m_rows.figures(cover, m_result.design),
                                   m_result.before, largestChange(m_order.freedoms, m_result.values),
                                   m_result.values});
        tell(share);
    }

    /// Share of a stage that so many rounds are, about: how many it takes is not known, and a second one mostly
    /// ends it.
    static double doneAfter(double rounds) { return 1 - std::exp2(-1.5 * rounds); }

    /// How much of a stage is done. Progress never goes back, though a verification may lead to more rounds.
    void tell(double share)
    {
        m_told = std::max(m_told, (m_stage + share) / m_stages);
        if (m_progress)
            m_progress(m_told, m_result.rounds.back());
    }

    enum class Outcome { Better, Settled };

    /// Derivatives once, and several steps with them: they change little, and cost most of the time.
    Outcome step(WarmCover& cover, double& damping, int round)
    {
        m_rows.aim(cover);
        Eigen::VectorXd now = m_rows.rows(cover, m_result.design);
        const Derivatives derivatives = m_derivatives->of(
            cover, m_result.design, m_order.freedoms, measure(),
            [&](double share) { tell(doneAfter(round + share)); }, m_stop);
        if (m_stop.stop_requested())
            return Outcome::Settled;
        if (derivatives.columns.size() == 0) {
            fail({QT_TRANSLATE_NOOP("Message", "Nothing that may change does anything to the cover."), {}});
            return Outcome::Settled;
        }
        Eigen::MatrixXd jacobian = derivatives.columns * m_scale.asDiagonal(); // by steps
        noteIdle(jacobian, derivatives.known);
        const double first = costOf(now, m_result.values);
        takeSteps(cover, jacobian, now, first, damping);
        if (followsForm())
            aimAgain(cover);
        const bool promising = !followsForm() || m_promised > settledPlaces * m_reached;
        return promising && first - m_reached > leastGain() * first ? Outcome::Better : Outcome::Settled;
    }

    /// What a place of the cover is nearest to on the form has changed with it; what the freedoms do to it hardly
    /// has.
    void aimAgain(WarmCover& cover)
    {
        for (int k = 0; k < mostAims && !m_stop.stop_requested() && cover.follow(m_result.design, m_stop); ++k) {
            m_rows.aim(cover);
            if (!goOnFrom(cover))
                break;
        }
    }

    CoarseDerivatives::Measure measure()
    {
        return [this](const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design) {
            return m_rows.rows(topology, places, design);
        };
    }

    /// Until they lead no farther. Returns the cost then.
    double takeSteps(WarmCover& cover, Eigen::MatrixXd& jacobian, Eigen::VectorXd& now, double cost,
                     double& damping)
    {
        for (int k = 0; k < mostStepsOfRound && !m_stop.stop_requested(); ++k) {
            const double before = cost;
            if (!takeStep(cover, jacobian, now, cost, damping) || before - cost < settledStep * before)
                break;
        }
        m_reached = cost;
        return cost;
    }

    /// Strains and folds are of single triangles: what these do, no others tell.
    bool isAboutPlaces() const { return !m_order.goals.strain && m_order.goals.smooth.empty(); }
    /// What the derivatives of such covers say holds beyond a step.
    bool followsForm() const { return isAboutPlaces() && !m_order.goals.target.empty(); }
    /// Of the error: what a round must take away for another one to follow.
    double leastGain() const
    {
        if (!isAboutPlaces())
            return settled;
        return m_stage + 2 < m_stages ? settledFew : settledPlaces;
    }

    /// False when no step makes it better. Derivatives learn from every step that is tried (Broyden).
    bool takeStep(WarmCover& cover, Eigen::MatrixXd& jacobian, Eigen::VectorXd& now, double& cost, double& damping)
    {
        const Eigen::MatrixXd squares = jacobian.transpose() * jacobian + m_change;
        const Eigen::VectorXd slope =
            jacobian.transpose() * now + m_change * m_result.values.cwiseQuotient(m_scale);
        for (int attempt = 0; attempt < mostAttempts && !m_stop.stop_requested(); ++attempt, damping *= 8) {
            const Eigen::VectorXd values = bounded(squares, slope, damping);
            const Eigen::VectorXd moved = (values - m_result.values).cwiseQuotient(m_scale);
            if (attempt == 0) {
                m_promised = cost - costOf(now + jacobian * moved, values);
                if (followsForm() && m_promised < leastPromise * cost)
                    return false;
            }
            const Design design = designAt(values);
            if (!isWhole(design) || !cover.follow(design, m_stop))
                continue;
            const Eigen::VectorXd rows = m_rows.rows(cover, design);
            const double reached = costOf(rows, values);
            if (!(reached < cost))
                continue;
            const Eigen::VectorXd expected = now + jacobian * moved;
            jacobian += (rows - expected) * moved.transpose() / moved.squaredNorm();
            if (!cover.moveHome(design, m_stop) || (!m_fewAreLike && !m_derivatives->moveHome(design, m_stop)))
                return false;
            m_result.values = values;
            m_result.design = design;
            now = rows;
            cost = reached;
            damping = std::max(damping / 8, 1e-6);
            return true;
        }
        return false;
    }

    /// The step of least squares, each control point no farther than it may go from where it was.
    Eigen::VectorXd bounded(const Eigen::MatrixXd& squares, const Eigen::VectorXd& slope, double damping) const
    {
        const double mean = squares.diagonal().mean();
        Eigen::MatrixXd matrix = squares;
        matrix.diagonal() += damping * (squares.diagonal() + Eigen::VectorXd::Constant(slope.size(), 1e-3 * mean));
        const Eigen::VectorXd before = m_result.values.cwiseQuotient(m_scale);
        std::vector<bool> held(static_cast<std::size_t>(slope.size()), false);
        Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.size());
        for (int round = 0; round < 5; ++round) { // who meets a bound stays there
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
            step = free.ldlt().solve(right);
            bool met = false;
            for (Eigen::Index k = 0; k < slope.size(); ++k) {
                const auto [least, most] = boundsOf(k);
                const double bounded = std::clamp(before[k] + step[k], least, most);
                if (std::abs(before[k] + step[k] - bounded) <= 1e-9 * (1 + std::abs(bounded)))
                    continue;
                step[k] = bounded - before[k];
                held[static_cast<std::size_t>(k)] = met = true;
            }
            if (!met)
                break;
        }
        return (before + step).cwiseProduct(m_scale);
    }

    /// In steps.
    std::pair<double, double> boundsOf(Eigen::Index k) const
    {
        const Freedom& freedom = m_order.freedoms[static_cast<std::size_t>(k)];
        const double most = freedom.kind == Freedom::Kind::OutlinePoint
                                ? m_order.mostChange / std::sqrt(2) / m_scale[k]
                                : m_order.mostChange;
        return {std::max(-most, freedom.least / m_scale[k]), std::min(most, freedom.most / m_scale[k])};
    }

    /// No outline crosses itself, nothing is out of its limits.
    bool isWhole(const Design& design)
    {
        bool whole = true;
        design.each<Patch>([&](ElementId id, const Patch& patch) {
            const Patch* before = m_result.design.find<Patch>(id);
            if (before && !(before->outline == patch.outline) && outlineProblem(patch.outline)) {
                Message note{QT_TRANSLATE_NOOP("Message", "A step would have turned the outline of "
                                                          "%1 over itself; a smaller one was taken"),
                             {patch.name}};
                if (std::ranges::find(m_result.notes, note) == m_result.notes.end())
                    m_result.notes.push_back(std::move(note));
                whole = false;
            }
        });
        return whole;
    }

    void noteIdle(const Eigen::MatrixXd& jacobian, const std::vector<bool>& known)
    {
        const double most = jacobian.colwise().norm().maxCoeff();
        m_result.idle.clear();
        for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
            if (!known[static_cast<std::size_t>(k)] || jacobian.col(k).norm() <= leastEffect * most)
                m_result.idle.push_back(m_order.freedoms[static_cast<std::size_t>(k)].name);
    }

    const SolveInput& m_input;
    const FitOrder& m_order;
    const std::function<void(double, const FitRound&)>& m_progress;
    const std::stop_token& m_stop;
    FitRows m_rows;
    std::unique_ptr<CoarseDerivatives> m_derivatives;
    Eigen::VectorXd m_scale;  // steps of the freedoms
    Eigen::MatrixXd m_change; // the cost of a change is a form of squares of its steps
    FitResult m_result;
    double m_reached = 0;              // cost of the last round
    double m_promised = 0;             // by which derivatives would make it less in one step
    std::optional<double> m_untouched; // cost of the pattern as it was, on the last triangles
    int m_stage = 0, m_stages = 1;
    double m_fewEdge = 0;      // mm, of the first triangles
    bool m_fewAreLike = false; // covers on them move as those on more triangles do
    double m_told = 0;         // share of the work
};

} // namespace

double largestChange(std::span<const Freedom> freedoms, const Eigen::VectorXd& values)
{
    std::map<std::tuple<ElementId, Freedom::Kind, int>, double> squares;
    for (std::size_t k = 0; k < freedoms.size(); ++k)
        if (freedoms[k].kind != Freedom::Kind::Number && freedoms[k].kind != Freedom::Kind::Size)
            squares[{freedoms[k].element, freedoms[k].kind, freedoms[k].index}] +=
                std::pow(values[static_cast<Eigen::Index>(k)], 2);
    double most = 0;
    for (const auto& [place, square] : squares)
        most = std::max(most, std::sqrt(square));
    return most;
}

Design withEases(const Design& before, const Design& changed)
{
    Edit edit;
    changed.each<Seam>([&](ElementId id, const Seam& seam) {
        const auto* old = before.find<Seam>(id);
        if (!old)
            return;
        const double more = seamDifference(changed, seam) - seamDifference(before, *old);
        if (std::abs(more) < leastWantedEase)
            return;
        Seam eased = seam;
        eased.ease = std::clamp(old->ease + more, -mostWantedEase, mostWantedEase);
        edit.changes.push_back({id, changed.element(id), makeElement(std::move(eased))});
    });
    return edit.empty() ? changed : changed.with(edit);
}

FitResult fitPattern(const SolveInput& input, const FitOrder& order,
                     const std::function<void(double, const FitRound&)>& progress, const std::stop_token& stop)
{
    FitResult result;
    result.design = input.design;
    if (order.freedoms.empty()) {
        result.reason = {QT_TRANSLATE_NOOP("Message", "Nothing may change."), {}};
        return result;
    }
    return Fit(input, order, progress, stop).run();
}

std::optional<MeasuredChange> measureChange(const SolveInput& input, const FitOrder& order, const Design& changed,
                                            const std::stop_token& stop)
{
    WarmOrder warm;
    warm.edgeLength = edgesFor(input.design).back();
    warm.tolerance = restTolerance;
    warm.threads = order.threads;
    FitRows rows(order.goals, order.locks, input.design);
    const WarmCover before(input, warm, stop);
    if (!before.hasHome())
        return std::nullopt;
    rows.keep(before);
    MeasuredChange measured;
    measured.before = rows.figures(before, input.design);
    rows.aim(before);
    const double cost = rows.rows(before, input.design).squaredNorm();
    const WarmCover cover(SolveInput(changed, input.files), warm, stop);
    if (!cover.hasHome())
        return std::nullopt;
    rows.aim(cover);
    measured.after = rows.figures(cover, changed);
    measured.better =
        rows.rows(cover, changed).squaredNorm() < cost && isAsWanted(order.goals, measured.before, measured.after);
    return measured;
}

} // namespace bolster
