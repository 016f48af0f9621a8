#include "FitRounds.h"

#include "DesignCheck.h"
#include "FitChange.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bolster {

namespace {

constexpr double settled = 0.03;      // a round that makes less of the error than that is the last one
constexpr double settledPlaces = 0.1; // likewise where the cover lies
constexpr double settledFew = 0.3;    // likewise, where more triangles follow
constexpr double settledStep = 0.05;  // likewise of a step
constexpr double stuckPromise = 0.3;  // of the cost: what no step kept of it is worth shorter ones
constexpr double leastPromise = 0.01; // what a step must promise to be tried
constexpr double leastDamping = 1e-6;
constexpr double dampedMore = 8;     // times, after a step that was none; a step that was one takes it back
constexpr int mostIterations = 300;  // of a cover beside the present one: others are farther away than is tried
constexpr int iterationsBeside = 40; // of covers that derivatives are taken from: they take some 15
constexpr double fewer = 1.4;        // times the edges of the cover, of that which derivatives come from
constexpr int mostStepsOfRound = 5;
constexpr int mostAims = 3;
constexpr double leastGainOfAim = 0.1; // of the cost: for another one to follow
constexpr int mostAttempts = 5;
constexpr double leastEffect = 1e-7; // of a freedom, against the strongest one

/// No farther than each control point may go from where it was; in steps.
StepBounds boundsIn(const FitOrder& order)
{
    StepBounds bounds;
    bounds.least.resize(std::ssize(order.freedoms));
    bounds.most.resize(std::ssize(order.freedoms));
    for (Eigen::Index k = 0; k < std::ssize(order.freedoms); ++k) {
        const Freedom& freedom = order.freedoms[static_cast<std::size_t>(k)];
        const double most = freedom.kind == Freedom::Kind::OutlinePoint
                                ? order.mostChange / std::sqrt(2) / freedom.step
                                : order.mostChange;
        bounds.least[k] = std::max(-most, freedom.least / freedom.step);
        bounds.most[k] = std::min(most, freedom.most / freedom.step);
    }
    return bounds;
}

/// Share of a stage that so many rounds are, about: how many it takes is not known, and a second one mostly ends
/// it.
double doneAfter(double rounds)
{
    return 1 - std::exp2(-1.5 * rounds);
}

} // namespace

FitRounds::FitRounds(const SolveInput& input, const FitOrder& order, double fewEdge, FitResult& result,
                     std::function<void(double)> tell, const std::stop_token& stop)
    : m_input(input)
    , m_order(order)
    , m_stop(stop)
    , m_tell(std::move(tell))
    , m_fewEdge(fewEdge)
    , m_change(input.design, order.freedoms, order.locks.change)
    , m_bounds(boundsIn(order))
    , m_result(result)
    , m_rows(order.goals, order.locks, input.design)
{}

bool FitRounds::fail(Message reason)
{
    if (!m_stop.stop_requested())
        m_result.reason = std::move(reason);
    return false;
}

Design FitRounds::designAt(const Eigen::VectorXd& values) const
{
    return withChange(m_input.design, m_order.freedoms, values, !m_order.locks.ease);
}

void FitRounds::take(const Eigen::VectorXd& values)
{
    m_result.values = values;
    m_result.design = designAt(values);
}

WarmOrder FitRounds::orderFor(double edge) const
{
    WarmOrder order;
    order.edgeLength = edge;
    order.tolerance = restTolerance;
    if (isAboutPlaces())
        order.mostWarmIterations = mostIterations;
    return order;
}

std::unique_ptr<WarmCover> FitRounds::coverOf(const Design& design, double edge, double tolerance)
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

/// What is to be small: rows of goals, and of the change.
double FitRounds::costOf(const Eigen::VectorXd& rows, const Eigen::VectorXd& values) const
{
    return rows.squaredNorm() + m_change.of(values);
}

double FitRounds::costOn(const WarmCover& cover, const Eigen::VectorXd& values, const Design& design)
{
    m_rows.aim(cover);
    return costOf(m_rows.rows(cover, design), values);
}

/// The cover of the present pattern as it comes to rest by itself, and what derivatives come from; null when
/// there is none.
std::unique_ptr<WarmCover> FitRounds::beginRounds(double edge, double derivativesEdge)
{
    std::unique_ptr<WarmCover> cover = coverOf(m_result.design, edge);
    if (!cover || m_stop.stop_requested())
        return nullptr;
    WarmOrder beside = orderFor(derivativesEdge);
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

bool FitRounds::run(double edge, bool few)
{
    const double own = isAboutPlaces() ? std::min(m_fewEdge, fewer * edge) : edge;
    std::unique_ptr<WarmCover> cover = beginRounds(edge, m_fewAreLike ? m_fewEdge : own);
    if (!cover)
        return false;
    double damping = firstDamping;
    bool anew = false, shorter = false;
    for (int round = 0; round < m_order.mostRounds; ++round) {
        // It may be where the last try has left it.
        if (m_stop.stop_requested() || !cover->follow(m_result.design, m_stop))
            return false;
        report(*cover, edge, few, doneAfter(round));
        const Outcome outcome = step(*cover, damping, round, few);
        if (!m_result.reason.empty())
            return false;
        if (outcome == Outcome::Better)
            continue;
        if (!followsForm() || m_promised <= stuckPromise * m_reached)
            break;
        // What is promised does not come: by itself the cover may rest where it does.
        std::unique_ptr<WarmCover> again = std::exchange(anew, true) ? nullptr : beginRounds(edge, edge);
        if (again) {
            cover = std::move(again);
            damping = firstDamping;
        } else if (std::exchange(shorter, true)) {
            break; // else with the shorter steps that damping has come to
        }
        m_result.reason = {}; // it has none
    }
    if (!m_stop.stop_requested() && cover->follow(m_result.design, m_stop))
        report(*cover, edge, few, 1);
    return !m_stop.stop_requested();
}

bool FitRounds::goOnFrom(WarmCover& cover, double damping)
{
    const Derivatives derivatives =
        m_derivatives->again(cover, m_result.design, m_order.freedoms, measure(), m_stop);
    if (derivatives.columns.size() == 0 || m_stop.stop_requested())
        return false;
    RowModel model(derivatives.columns * m_change.steps().asDiagonal());
    Eigen::VectorXd now = m_rows.rows(cover, m_result.design);
    const double cost = costOf(now, m_result.values);
    return nearly * takeSteps(cover, model, now, cost, damping) < cost;
}

/// Derivatives once, and several steps with them: they change little, and cost most of the time.
FitRounds::Outcome FitRounds::step(WarmCover& cover, double& damping, int round, bool few)
{
    m_rows.aim(cover);
    Eigen::VectorXd now = m_rows.rows(cover, m_result.design);
    const Derivatives derivatives = m_derivatives->of(
        cover, m_result.design, m_order.freedoms, measure(),
        [&](double share) { m_tell(doneAfter(round + share)); }, m_stop);
    if (m_stop.stop_requested())
        return Outcome::Settled;
    if (derivatives.columns.size() == 0) {
        fail({QT_TRANSLATE_NOOP("Message", "Nothing that may change does anything to the cover."), {}});
        return Outcome::Settled;
    }
    RowModel model(derivatives.columns * m_change.steps().asDiagonal());
    noteIdle(model.jacobian(), derivatives.known);
    const double first = costOf(now, m_result.values);
    takeSteps(cover, model, now, first, damping);
    if (followsForm() && m_reached < first)
        aimAgain(cover, damping);
    const bool promising = !followsForm() || m_promised > settledPlaces * m_reached;
    return promising && first - m_reached > leastGain(few) * first ? Outcome::Better : Outcome::Settled;
}

/// What a place of the cover is nearest to on the form has changed with it; what the freedoms do to it hardly
/// has.
void FitRounds::aimAgain(WarmCover& cover, double damping)
{
    for (int k = 0; k < mostAims && !m_stop.stop_requested() && cover.follow(m_result.design, m_stop); ++k) {
        m_rows.aim(cover);
        const double before = m_reached;
        if (!goOnFrom(cover, damping) || before - m_reached < leastGainOfAim * before)
            break;
    }
}

CoarseDerivatives::Measure FitRounds::measure() const
{
    return [this](const SurfaceTopology& topology, const std::vector<Vec3>& places, const Design& design) {
        return m_rows.rows(topology, places, design);
    };
}

/// Until they lead no farther. Returns the cost then.
double FitRounds::takeSteps(WarmCover& cover, RowModel& model, Eigen::VectorXd& now, double cost, double& damping)
{
    for (int k = 0; k < mostStepsOfRound && !m_stop.stop_requested(); ++k) {
        const double before = cost;
        if (!takeStep(cover, model, now, cost, damping) || before - cost < settledStep * before)
            break;
    }
    m_reached = cost;
    return cost;
}

/// Of the error: what a round must take away for another one to follow.
double FitRounds::leastGain(bool few) const
{
    if (!isAboutPlaces())
        return settled;
    return few ? settledFew : settledPlaces;
}

/// False when no step makes it better. Derivatives learn from every step that is tried (Broyden).
bool FitRounds::takeStep(WarmCover& cover, RowModel& model, Eigen::VectorXd& now, double& cost, double& damping)
{
    const Eigen::MatrixXd squares = model.squares() + m_change.squares();
    const Eigen::VectorXd slope =
        model.jacobian().transpose() * now + m_change.squares() * m_change.inSteps(m_result.values);
    for (int attempt = 0; attempt < mostAttempts && !m_stop.stop_requested(); ++attempt, damping *= dampedMore) {
        const Eigen::VectorXd values =
            m_change.fromSteps(boundedStep(squares, slope, damping, m_change.inSteps(m_result.values), m_bounds));
        const Eigen::VectorXd moved = m_change.inSteps(values - m_result.values);
        if (attempt == 0) {
            m_promised = cost - costOf(now + model.jacobian() * moved, values);
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
        model.learn(moved, rows - now - model.jacobian() * moved);
        if (!cover.moveHome(design, m_stop) || (!m_fewAreLike && !m_derivatives->moveHome(design, m_stop)))
            return false;
        m_result.values = values;
        m_result.design = design;
        now = rows;
        cost = reached;
        damping = std::max(damping / dampedMore, leastDamping);
        return true;
    }
    return false;
}

/// No outline crosses itself, nothing is out of its limits.
bool FitRounds::isWhole(const Design& design)
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

void FitRounds::noteIdle(const Eigen::MatrixXd& jacobian, const std::vector<bool>& known)
{
    const double most = jacobian.colwise().norm().maxCoeff();
    m_result.idle.clear();
    for (Eigen::Index k = 0; k < jacobian.cols(); ++k)
        if (!known[static_cast<std::size_t>(k)] || jacobian.col(k).norm() <= leastEffect * most)
            m_result.idle.push_back(m_order.freedoms[static_cast<std::size_t>(k)].name);
}

void FitRounds::report(const WarmCover& cover, double edge, bool few, double share)
{
    m_result.rounds.push_back({edge, few, m_rows.figures(cover, m_result.design), m_result.before,
                               largestChange(m_order.freedoms, m_result.values), m_result.values});
    m_tell(share);
}

} // namespace bolster
