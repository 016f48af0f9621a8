#include "Reliefs.h"

#include "CoverMove.h"
#include "CoverTeam.h"
#include "DesignCheck.h"
#include "EditCheck.h"
#include "Pulls.h"
#include "ReliefCandidates.h"
#include "RestingSolve.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <set>

namespace bolster {

namespace {

constexpr int amounts = 24;       // that are looked at on each side
constexpr double worthMore = 0.9; // of the best gain: a smaller amount that gains so much is better
constexpr double leastGain = 1e-3;
constexpr double spareOfMost = 0.5;     // differences are taken at this share of the bound
constexpr double sharePredicting = 0.7; // of the progress; the rest is solving the best

CoverStrains strainsOf(const WarmCover& cover, const std::optional<double>& limit)
{
    return coverStrains(*cover.mesh().topology, vertexPlaces(cover), cover.homeDesign(), limit);
}

/// Strains as polynomials of an amount, from those at three.
class StrainCurve {
public:
    StrainCurve(const CoverStrains& here, const CoverStrains* above, const CoverStrains* below, double step)
        : m_strains(here)
    {
        if (above && below) {
            m_slope = (above->strains - below->strains) / (2 * step);
            m_bend = (above->strains - 2 * here.strains + below->strains) / (2 * step * step);
        } else {
            const CoverStrains& only = above ? *above : *below;
            m_slope = (only.strains - here.strains) / (above ? step : -step);
            m_bend = Eigen::Matrix3Xd::Zero(3, here.strains.cols());
        }
    }

    double energyAt(double amount)
    {
        const Eigen::Matrix3Xd strains = m_strains.strains + amount * m_slope + amount * amount * m_bend;
        return squaresOver(m_strains, strains).dot(m_strains.areas) / m_strains.areas.sum();
    }

private:
    const CoverStrains& m_strains;
    Eigen::Matrix3Xd m_slope, m_bend;
};

struct Best {
    double amount = 0, gain = 0;
};

bool anySeamPuckers(const Design& before, const Design& after)
{
    bool any = false;
    before.each<Seam>([&](ElementId id, const Seam& seam) {
        const auto* now = after.find<Seam>(id);
        any = any || (now && puckers(after, *now) && !puckers(before, seam));
    });
    return any;
}

/// What is left of an amount so that no seam puckers that did not.
double withoutPuckers(const Design& design, const ReliefMove& move, double amount)
{
    constexpr int halvings = 4;
    for (int k = 0; k < halvings; ++k, amount /= 2)
        if (!anySeamPuckers(design, withMove(design, move, amount)))
            return amount;
    return 0;
}

/// The smallest amount between two, one on each side of 0, that gains nearly the most.
Best bestAmount(StrainCurve& curve, double lowest, double highest)
{
    const double now = curve.energyAt(0);
    std::vector<Best> all;
    for (int k = -amounts; k <= amounts; ++k) {
        const double amount = (k < 0 ? -lowest : highest) * k / amounts;
        all.push_back({amount, 1 - curve.energyAt(amount) / now});
    }
    const double gain = std::ranges::max(all, {}, &Best::gain).gain;
    std::erase_if(all, [&](const Best& one) { return one.gain < worthMore * gain; });
    return gain > 0 ? std::ranges::min(all, {}, [](const Best& one) { return std::abs(one.amount); }) : Best{};
}

/// Predicts what candidates gain, several at a time.
class Predictor {
public:
    Predictor(const SolveInput& input, const ReliefOrder& order, std::function<void(double)> progress,
              const std::stop_token& stop)
        : m_input(input)
        , m_order(order)
        , m_progress(std::move(progress))
        , m_stop(stop)
        , m_team(input, {.edgeLength = order.edgeLength}, order.threads, stop)
    {}

    const Message& problem() const { return m_team.problem(); }

    std::vector<Relief> predicted()
    {
        m_now = strainsOf(m_team.first(), m_order.limit);
        m_energy = overLimit(m_now).energy;
        if (!(m_energy > 0))
            return {};
        const std::vector<ReliefMove> moves = reliefMoves(m_input.design);
        std::vector<Relief> whole = continuityReliefs(m_input.design);
        for (Relief& dart : dartReliefs(m_input.design, *m_team.first().mesh().topology, m_now))
            whole.push_back(std::move(dart));
        const std::size_t count = moves.size() + whole.size();
        std::vector<std::optional<Relief>> found(count);
        m_team.forTasks(static_cast<int>(count), [&](WarmCover& cover, int task) {
            const auto k = static_cast<std::size_t>(task);
            if (m_stop.stop_requested())
                return;
            found[k] = k < moves.size() ? moved(cover, moves[k]) : tried(cover, whole[k - moves.size()]);
            const std::scoped_lock lock(m_mutex);
            m_progress(static_cast<double>(++m_done) / static_cast<double>(count));
        });
        std::vector<Relief> reliefs;
        for (std::optional<Relief>& relief : found)
            if (relief && relief->predicted > leastGain)
                reliefs.push_back(std::move(*relief));
        std::ranges::stable_sort(reliefs, std::ranges::greater(), &Relief::predicted);
        return reliefs;
    }

private:
    std::optional<CoverStrains> strainsWith(WarmCover& cover, const Design& design) const
    {
        if (!cover.follow(design, m_stop))
            return std::nullopt;
        return strainsOf(cover, m_order.limit);
    }

    std::optional<Relief> moved(WarmCover& cover, const ReliefMove& move) const
    {
        const double step = spareOfMost * m_order.most;
        const std::optional<CoverStrains> above = strainsWith(cover, withMove(m_input.design, move, step));
        const std::optional<CoverStrains> below = strainsWith(cover, withMove(m_input.design, move, -step));
        if (!above && !below)
            return std::nullopt;
        StrainCurve curve(m_now, above ? &*above : nullptr, below ? &*below : nullptr, step);
        const Best best = bestAmount(curve, withoutPuckers(m_input.design, move, -m_order.most),
                                     withoutPuckers(m_input.design, move, m_order.most));
        if (!(best.gain > 0))
            return std::nullopt;
        Relief relief = reliefOf(m_input.design, move, best.amount);
        relief.predicted = best.gain;
        if (edits::brokenBy(m_input.design, relief.edit))
            return std::nullopt;
        return relief;
    }

    /// What has no amount: seams are followed on the same triangles, darts need others.
    std::optional<Relief> tried(WarmCover& cover, Relief relief) const
    {
        const Design design = m_input.design.with(relief.edit);
        std::optional<CoverStrains> strains;
        if (relief.kind == Relief::Kind::Dart) {
            const WarmCover other({design, m_input.files}, {.edgeLength = m_order.edgeLength}, m_stop);
            if (other.hasHome())
                strains = strainsOf(other, m_order.limit);
        } else {
            strains = strainsWith(cover, design);
        }
        if (!strains)
            return std::nullopt;
        relief.predicted = 1 - overLimit(*strains).energy / m_energy;
        return relief;
    }

    const SolveInput& m_input;
    const ReliefOrder& m_order;
    std::function<void(double)> m_progress;
    std::stop_token m_stop;
    CoverTeam m_team;
    CoverStrains m_now;
    double m_energy = 0;
    std::mutex m_mutex; // of the progress
    int m_done = 0;
};

OverLimit overLimitOf(const SurfaceMesh& cover, const Design& design, const std::optional<double>& limit)
{
    return overLimit(coverStrains(*cover.topology, cover.positions, design, limit));
}

/// The best at each place come first; returns how many.
std::size_t bestFirst(std::vector<Relief>& reliefs, int wanted)
{
    std::set<ElementId> places;
    const auto rest = std::stable_partition(reliefs.begin(), reliefs.end(), [&](const Relief& relief) {
        return std::ssize(places) < wanted && places.insert(relief.element).second;
    });
    return static_cast<std::size_t>(rest - reliefs.begin());
}

double shapeChange(const SurfaceMesh& before, const SurfaceMesh& after)
{
    const SurfaceMeshPtr from = moveBetween(before, after).from;
    if (!from || after.positions.empty())
        return 0;
    double squares = 0;
    for (std::size_t v = 0; v < after.positions.size(); ++v)
        squares += (after.positions[v] - from->positions[v]).squaredNorm();
    return std::sqrt(squares / static_cast<double>(after.positions.size()));
}

} // namespace

std::vector<ScanChange> scanChanges(const ReliefList& list, const Relief& relief)
{
    std::vector<ScanChange> changes;
    for (std::size_t k = 0; k < std::min(list.scans.size(), relief.scans.size()); ++k) {
        const ScanFigures &before = list.scans[k].figures, &after = relief.scans[k].figures;
        if (before.coverage > 0 && after.coverage > 0)
            changes.push_back({list.scans[k].name, before.rms, after.rms});
    }
    return changes;
}

const char* wordOf(Relief::Kind kind)
{
    static constexpr const char* words[] = {"ease", "let-out", "move-seam", "corner", "dart", "continuity"};
    return words[static_cast<std::size_t>(kind)];
}

void solveRelief(const SolveInput& input, const std::optional<double>& limit, const OverLimit& now, int threads,
                 Relief& relief, const std::stop_token& stop)
{
    const Design design = withoutPulls(input.design.with(relief.edit));
    const SolveResult result = solveResting({design, input.files}, {.threads = threads}, stop);
    if (result.status != SolveResult::Status::Solved || !(now.energy > 0))
        return;
    relief.cover = result.surface;
    relief.scans = result.report.scans;
    const OverLimit with = overLimitOf(*result.surface, design, limit);
    relief.solved = {1 - with.energy / now.energy, 1 - with.area / now.area};
}

ReliefList proposeReliefs(const SolveInput& input, const ReliefOrder& order, const ReliefNews& news,
                          const std::stop_token& stop)
{
    ReliefList result;
    const SolveResult now =
        solveResting({withoutPulls(input.design), input.files}, {.threads = order.threads}, stop);
    if (now.status != SolveResult::Status::Solved) {
        result.problem = now.reason;
        return result;
    }
    result.cover = now.surface;
    result.scans = now.report.scans;
    result.now = overLimitOf(*now.surface, input.design, order.limit);
    {
        const auto predicting = [&](double share) {
            if (news)
                news(sharePredicting * share, nullptr);
        };
        Predictor predictor(input, order, predicting, stop);
        result.problem = predictor.problem();
        if (!result.problem.empty() || stop.stop_requested())
            return result;
        result.reliefs = predictor.predicted();
    }
    const std::size_t best = bestFirst(result.reliefs, order.solved);
    for (std::size_t k = 0; k < best; ++k) {
        solveRelief(input, order.limit, result.now, order.threads, result.reliefs[k], stop);
        if (result.reliefs[k].cover)
            result.reliefs[k].shape = shapeChange(*result.cover, *result.reliefs[k].cover);
        if (news && !stop.stop_requested())
            news(sharePredicting + (1 - sharePredicting) * static_cast<double>(k + 1) / static_cast<double>(best),
                 &result);
    }
    std::stable_sort(result.reliefs.begin(), result.reliefs.begin() + static_cast<std::ptrdiff_t>(best),
                     [](const Relief& a, const Relief& b) {
                         return (a.solved ? a.solved->energy : -1) > (b.solved ? b.solved->energy : -1);
                     });
    return result;
}

} // namespace bolster
