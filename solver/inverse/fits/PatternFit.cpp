#include "PatternFit.h"

#include "FitRounds.h"
#include "FitRows.h"
#include "PatternSize.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace bolster {

namespace {

constexpr double fewVertices = 3000;   // of the first triangles, about
constexpr double manyVertices = 12000; // of the last ones
constexpr double worthIt = 1.7;        // times as many vertices as before
constexpr double alike = 0.2;          // what few triangles have led to leaves so much of the cost on more of them
constexpr double farFromFew = 4;       // times what few triangles have reached: they are not alike
constexpr int mostVerifications = 10, fewVerifications = 4;
constexpr int mostImprovements = 2;  // on the way
constexpr double leastWorth = 0.999; // times the cost of the pattern as it was: else nothing is gained by a change
constexpr double sprang = 1.5;       // times the cost that the last round had: the cover has come to rest elsewhere
constexpr double asGood = 1.5;       // times the cost that was reached: not worth more time

/// Lengths of edges, mm: the last one is the design's, or what is as fine as it need be.
std::vector<double> edgesFor(const Design& design)
{
    const double area = patternArea(design);
    const double last = std::max(design.settings().edgeLength, edgeLengthFor(area, manyVertices));
    const double first = edgeLengthFor(area, fewVertices);
    return first * first > worthIt * last * last ? std::vector{first, last} : std::vector{last};
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
        , m_edges(edgesFor(input.design))
        , m_rounds(
              input, order, m_edges.front(), m_result, [this](double share) { tell(share); }, stop)
        , m_stages(static_cast<int>(m_edges.size()) + 1)
    {
        m_result.design = input.design;
        m_result.values = Eigen::VectorXd::Zero(std::ssize(order.freedoms));
    }

    FitResult run()
    {
        // What is below the limits already need not be changed for them; other goals are never reached wholly.
        if (m_order.goals.isLimitAlone() && begin(m_edges.back()) && m_result.before.overLimit == 0) {
            m_result.after = m_result.before;
            m_result.status = FitResult::Status::NothingToDo;
            return std::move(m_result);
        }
        bool whole = m_result.reason.empty() && begin(m_edges.front());
        for (m_stage = 0; whole && m_stage < m_stages - 1; ++m_stage)
            whole = goOn(stageEdge()) && improve(stageEdge());
        if (whole && verify(m_edges.back()) && goFarther(m_edges.back()))
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
    double stageEdge() const { return m_edges[static_cast<std::size_t>(m_stage)]; } // mm

    bool begin(double edge)
    {
        const auto cover = m_rounds.coverOf(m_input.design, edge);
        if (!cover || m_stop.stop_requested())
            return false;
        m_rounds.rows().keep(*cover);
        m_result.before = m_rounds.rows().figures(*cover, m_input.design);
        if (!m_order.goals.target.empty() && m_result.before.covered == 0 && !m_order.goals.area.isAll())
            return m_rounds.fail(
                {QT_TRANSLATE_NOOP("Message", "No vertex of the area is near the form: make the area larger "
                                              "than the mesh edges, or put the form where the cover is."),
                 {}});
        if (!m_order.goals.target.empty() && m_result.before.covered == 0)
            return m_rounds.fail(
                {QT_TRANSLATE_NOOP("Message", "No place of the cover is near the form: put it where the "
                                              "cover is, in millimetres."),
                 {}});
        return true;
    }

    /// From what fewer triangles have led to, or nothing, or else half of it: what is best on these.
    bool goOn(double edge)
    {
        if (m_stage == 0)
            return true;
        const Eigen::VectorXd found = m_result.values;
        double least = std::numeric_limits<double>::infinity(), untouched = 0;
        for (const double share : {0.0, 1.0, 0.5}) {
            if (share == 0.5 && m_result.values == found && m_rounds.isAboutPlaces())
                break; // all of it is better than nothing
            const Eigen::VectorXd values = share * found;
            const Design design = m_rounds.designAt(values);
            const auto cover = m_rounds.coverOf(design, edge);
            if (!cover || m_stop.stop_requested())
                return false;
            if (share == 0) {
                m_rounds.rows().keep(*cover);
                m_result.before = m_rounds.rows().figures(*cover, design);
            }
            if (const double cost = m_rounds.costOn(*cover, values, design); cost < least) {
                least = cost;
                m_result.values = values;
                m_result.design = design;
            }
            untouched = share == 0 ? least : untouched;
        }
        m_untouched = untouched;
        m_rounds.setFewAreLike(m_rounds.isAboutPlaces() && least < alike * untouched &&
                               least < farFromFew * m_rounds.reached());
        return true;
    }

    /// With the derivatives of few triangles, and if these have been much nearer than they lead to here, with own
    /// ones.
    bool improve(double edge)
    {
        const double onFew = m_rounds.reached();
        const bool few = m_stage + 2 < m_stages;
        if (!m_rounds.run(edge, few) || !m_rounds.areFewLike() || m_rounds.reached() < sprang * onFew)
            return !m_stop.stop_requested() && m_result.reason.empty();
        m_rounds.setFewAreLike(false);
        return m_rounds.run(edge, few);
    }

    /// What counts is the cover of the changed pattern as it comes to rest by itself: that it was found on the way
    /// may have led to other folds. Then it goes on from there; and when that leads nowhere not as far, half the
    /// way to what is good or to the pattern as it was.
    bool verify(double edge, int most = mostVerifications)
    {
        Eigen::VectorXd best = Eigen::VectorXd::Zero(m_result.values.size());
        double least = leastWorth * untouchedCost(edge), reached = m_rounds.reached();
        int improvements = 0;
        m_result.after = m_result.before;
        for (int round = 0; round < most && m_result.values != best; ++round) {
            const auto cover = m_rounds.coverOf(m_result.design, edge, WarmOrder().tolerance);
            if (!cover || m_stop.stop_requested())
                return false;
            reached = std::min(reached, m_rounds.reached());
            const double cost = m_rounds.costOn(*cover, m_result.values, m_result.design);
            if (!(cost < least)) {
                m_rounds.setFewAreLike(false);
                if (round > 0)
                    m_rounds.take(0.5 * (best + m_result.values));
                else if (!improve(edge))
                    break;
                continue;
            }
            least = cost;
            best = m_result.values;
            m_result.after = m_rounds.rows().figures(*cover, m_result.design);
            if (cost < FitRounds::nearly * reached)
                break;
            const bool sameFolds = cost < sprang * reached;
            if (m_rounds.followsForm() && sameFolds && m_rounds.goOnFrom(*cover))
                continue;
            if (cost < asGood * reached || ++improvements > mostImprovements)
                break;
            m_rounds.setFewAreLike(false); // they have led elsewhere
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
        m_rounds.take(best);
        return !m_stop.stop_requested();
    }

    /// From what is found for a limit alone: squares of still smaller strains see still more of what is just over
    /// it, but only near to what is good already they do not lead to another cover. False when it has been stopped.
    bool goFarther(double edge)
    {
        if (!m_order.goals.isLimitAlone() || m_result.values.isZero() || m_result.after.overLimit == 0)
            return !m_stop.stop_requested();
        FitResult found = m_result;
        m_rounds.rows().strainFrom(FitRows::farBelowLimit);
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

    /// Of the pattern as it was, on the last triangles; infinite when it has no cover there.
    double untouchedCost(double edge)
    {
        if (m_untouched)
            return *m_untouched;
        const auto cover = m_rounds.coverOf(m_input.design, edge);
        return cover && !m_stop.stop_requested()
                   ? m_rounds.costOn(*cover, Eigen::VectorXd::Zero(m_result.values.size()), m_input.design)
                   : std::numeric_limits<double>::infinity();
    }

    /// How much of a stage is done. Progress never goes back, though a verification may lead to more rounds.
    void tell(double share)
    {
        m_told = std::max(m_told, (m_stage + share) / m_stages);
        if (m_progress)
            m_progress(m_told, m_result.rounds.back());
    }

    const SolveInput& m_input;
    const FitOrder& m_order;
    const std::function<void(double, const FitRound&)>& m_progress;
    const std::stop_token& m_stop;
    const std::vector<double> m_edges; // mm, of the triangles of each stage but the last, which verifies
    FitResult m_result;
    FitRounds m_rounds;
    std::optional<double> m_untouched; // cost of the pattern as it was, on the last triangles
    int m_stage = 0, m_stages = 1;
    double m_told = 0; // share of the work
};

} // namespace

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
    warm.tolerance = FitRounds::restTolerance;
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
