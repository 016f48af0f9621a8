#include "PatternFit.h"

#include "DesignCheck.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace bolster {

namespace {

constexpr double fewVertices = 3000;   // of the first triangles, about
constexpr double manyVertices = 12000; // of the last ones
constexpr double worthIt = 1.7;        // times as many vertices as before
constexpr double settled = 0.02;       // a round that makes less of the error than that is the last one
constexpr double leastEffect = 1e-7;   // of a freedom, against the strongest one

/// Lengths of edges, mm: the last one is the design's, or what is as fine as it need be.
std::vector<double> edgesFor(const Design& design)
{
    double area = 0;
    design.each<Patch>([&](ElementId, const Patch& patch) { area += std::abs(patch.outline.signedArea()); });
    const auto edgeFor = [&](double vertices) { return std::sqrt(area / (vertices * std::sqrt(0.75))); };
    const double last = std::max(design.settings().edgeLength, edgeFor(manyVertices));
    const double first = edgeFor(fewVertices);
    return first * first > worthIt * last * last ? std::vector{first, last} : std::vector{last};
}

/// Freedoms that move points along one outline, and their neighbours: changes shall be smooth.
struct Neighbours {
    Eigen::Index before, here, after;
};

std::vector<Neighbours> neighboursOf(const Design& design, std::span<const Freedom> freedoms)
{
    std::vector<Neighbours> found;
    for (std::size_t k = 0; k < freedoms.size(); ++k) {
        const Freedom& here = freedoms[k];
        if (here.kind != Freedom::Kind::OutlinePoint)
            continue;
        const int count = design.find<Patch>(here.element)->outline.pointCount();
        const auto at = [&](int index) {
            return std::ranges::find_if(freedoms, [&](const Freedom& other) {
                       return other.kind == here.kind && other.element == here.element &&
                              other.axis == here.axis && other.index == (index + count) % count;
                   }) -
                   freedoms.begin();
        };
        const auto before = at(here.index - 1), after = at(here.index + 1);
        if (before < std::ssize(freedoms) && after < std::ssize(freedoms))
            found.push_back({before, static_cast<Eigen::Index>(k), after});
    }
    return found;
}

class Fit {
public:
    Fit(const SolveInput& input, const FitOrder& order, const std::function<void(double, const FitRound&)>& progress,
        const std::stop_token& stop)
        : m_input(input)
        , m_order(order)
        , m_progress(progress)
        , m_stop(stop)
        , m_neighbours(neighboursOf(input.design, order.freedoms))
        , m_rows(order.goals, order.locks, input.design)
    {
        m_result.design = input.design;
        m_result.values = Eigen::VectorXd::Zero(std::ssize(order.freedoms));
        m_scale.resize(std::ssize(order.freedoms));
        for (Eigen::Index k = 0; k < m_scale.size(); ++k)
            m_scale[k] = order.freedoms[static_cast<std::size_t>(k)].step;
    }

    FitResult run()
    {
        const std::vector<double> edges = edgesFor(m_input.design);
        m_stages = static_cast<int>(edges.size());
        for (m_stage = 0; m_stage < m_stages; ++m_stage)
            if (!onTriangles(edges[static_cast<std::size_t>(m_stage)]))
                break;
        if (m_stop.stop_requested())
            m_result.status = FitResult::Status::Cancelled;
        else if (m_result.reason.empty())
            m_result.status =
                m_result.values.isZero() ? FitResult::Status::NothingToDo : FitResult::Status::Done;
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
        double cost = m_order.locks.change * m_order.locks.change * steps.squaredNorm();
        for (const Neighbours& n : m_neighbours)
            cost += std::pow(2 * m_order.locks.change * (steps[n.before] - 2 * steps[n.here] + steps[n.after]), 2);
        return cost;
    }

    /// Second derivatives of that cost, halved, in steps.
    Eigen::MatrixXd changeMatrix() const
    {
        const double w = m_order.locks.change * m_order.locks.change;
        Eigen::MatrixXd matrix = w * Eigen::MatrixXd::Identity(m_scale.size(), m_scale.size());
        for (const Neighbours& n : m_neighbours) {
            const std::array<std::pair<Eigen::Index, double>, 3> row{
                std::pair(n.before, 1.0), std::pair(n.here, -2.0), std::pair(n.after, 1.0)};
            for (const auto& [i, a] : row)
                for (const auto& [j, b] : row)
                    matrix(i, j) += 4 * w * a * b;
        }
        return matrix;
    }

    bool onTriangles(double edge)
    {
        WarmOrder warm;
        warm.edgeLength = edge;
        warm.tolerance = 1e-5;
        CoverTeam team(m_input, warm, m_order.threads, m_stop);
        if (!team.problem().empty())
            return fail(team.problem());
        if (m_stop.stop_requested())
            return false;
        m_rows.keep(team.first());
        m_rows.aim(team.first());
        m_result.before = m_rows.figures(team.first(), m_input.design);
        if (!m_order.goals.target.empty() && m_result.before.covered == 0)
            return fail({QT_TRANSLATE_NOOP("Message", "No place of the cover is near the form: put it where the "
                                                      "cover is, in millimetres."),
                         {}});
        if (!m_result.values.isZero() && !team.moveHome(m_result.design, m_stop))
            return fail(team.problem());
        double damping = 1e-3;
        for (int round = 0; round < m_order.mostRounds; ++round) {
            report(team, edge, static_cast<double>(round) / m_order.mostRounds);
            const Outcome outcome = step(team, damping, round);
            if (m_stop.stop_requested() || !m_result.reason.empty())
                return false;
            if (outcome != Outcome::Better)
                break;
        }
        m_result.after = m_rows.figures(team.first(), m_result.design);
        report(team, edge, 1);
        return true;
    }

    void report(CoverTeam& team, double edge, double share)
    {
        FitRound round{edge, m_rows.figures(team.first(), m_result.design),
                       largestChange(m_order.freedoms, m_result.values)};
        m_result.rounds.push_back(round);
        if (m_progress)
            m_progress((m_stage + share) / m_stages, round);
    }

    enum class Outcome { Better, Settled };

    Outcome step(CoverTeam& team, double& damping, int round)
    {
        m_rows.aim(team.first());
        const CoverMeasure measure = [this](const WarmCover& cover, const Design& design) {
            return m_rows.rows(cover, design);
        };
        const Eigen::VectorXd now = measure(team.first(), m_result.design);
        const auto tell = [&](double share) {
            if (m_progress)
                m_progress((m_stage + (round + share) / m_order.mostRounds) / m_stages, m_result.rounds.back());
        };
        const Derivatives derivatives =
            differentiate(team, m_result.design, m_order.freedoms, measure, false, tell, m_stop);
        if (m_stop.stop_requested())
            return Outcome::Settled;
        if (derivatives.columns.size() == 0) {
            fail({QT_TRANSLATE_NOOP("Message", "Nothing that may change does anything to the cover."), {}});
            return Outcome::Settled;
        }
        Eigen::MatrixXd jacobian = derivatives.columns * m_scale.asDiagonal(); // by steps
        noteIdle(jacobian, derivatives.known);
        const double cost = costOf(now, m_result.values);
        const Eigen::MatrixXd squares = jacobian.transpose() * jacobian + changeMatrix();
        const Eigen::VectorXd slope =
            jacobian.transpose() * now + changeMatrix() * m_result.values.cwiseQuotient(m_scale);
        for (int attempt = 0; attempt < 6; ++attempt, damping *= 8) {
            const Eigen::VectorXd values = bounded(squares, slope, damping);
            const Design design = withFreedoms(m_input.design, m_order.freedoms, values);
            if (!isWhole(design))
                continue;
            if (!team.first().follow(design, m_stop))
                continue;
            const double reached = costOf(m_rows.rows(team.first(), design), values);
            if (!(reached < cost))
                continue;
            const Eigen::VectorXd moved = (values - m_result.values).cwiseQuotient(m_scale);
            const double predicted = (now + jacobian * moved).squaredNorm() + changeCost(values);
            m_result.jumped = m_result.jumped || reached - predicted > 0.5 * (cost - predicted);
            if (!team.moveHome(design, m_stop))
                return Outcome::Settled;
            m_result.values = values;
            m_result.design = design;
            damping = std::max(damping / 8, 1e-6);
            return cost - reached > settled * cost ? Outcome::Better : Outcome::Settled;
        }
        return Outcome::Settled;
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
                const double most = boundOf(k);
                if (std::abs(before[k] + step[k]) <= most * (1 + 1e-9))
                    continue;
                step[k] = std::clamp(before[k] + step[k], -most, most) - before[k];
                held[static_cast<std::size_t>(k)] = met = true;
            }
            if (!met)
                break;
        }
        return (before + step).cwiseProduct(m_scale);
    }

    /// In steps.
    double boundOf(Eigen::Index k) const
    {
        return m_order.freedoms[static_cast<std::size_t>(k)].kind == Freedom::Kind::OutlinePoint
                   ? m_order.mostChange / std::sqrt(2) / m_scale[k]
                   : m_order.mostChange;
    }

    /// No outline crosses itself, nothing is out of its limits.
    bool isWhole(const Design& design)
    {
        bool whole = true;
        design.each<Patch>([&](ElementId id, const Patch& patch) {
            const Patch* before = m_result.design.find<Patch>(id);
            if (before && !(before->outline == patch.outline) && outlineProblem(patch.outline)) {
                if (whole)
                    m_result.notes.push_back({QT_TRANSLATE_NOOP("Message", "A step would have turned the outline of "
                                                                           "%1 over itself; a smaller one was taken"),
                                              {patch.name}});
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
    std::vector<Neighbours> m_neighbours;
    FitRows m_rows;
    Eigen::VectorXd m_scale; // steps of the freedoms
    FitResult m_result;
    int m_stage = 0, m_stages = 1;
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

} // namespace bolster
