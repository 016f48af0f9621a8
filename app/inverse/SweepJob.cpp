#include "SweepJob.h"

#include "SolveFailure.h"
#include "VertexAreas.h"

#include <algorithm>
#include <optional>

namespace bolster {

namespace {

constexpr double shareLinear = 0.2; // of the time, when pieces are solved
constexpr int linearPieces = 1000;  // that are counted
constexpr int piecesAtOnce = 10;
constexpr double fewestTold = 20;
constexpr double untilNext = 1.5; // times as many pieces as were known when figures were told last

/// What each tolerance does, and what that makes of many pieces.
struct Linear {
    Eigen::MatrixXf columns;
    std::vector<float> p95; ///< mm
};

/// None when it was stopped.
std::optional<Linear> addLinear(Sweep& sweep, const SweepWanted& wanted, SweepFound& found, const SweepNews& news,
                                const std::stop_token& stop)
{
    const double share = wanted.samples > 0 ? shareLinear : 1;
    Eigen::MatrixXf linear = sweep.linear([&](double done) { news(share * done, nullptr); }, stop);
    if (stop.stop_requested())
        return std::nullopt;
    found.unknown = sweep.unknown();
    found.p95 = linearP95(linear, wanted.tolerances, SweepFound::linearSamples, stop);
    found.influence =
        influences(linear, wanted.tolerances, vertexAreas(*found.nominal->topology, found.nominal->positions));
    for (Eigen::Index k = 0; k < linear.cols(); k += 2)
        found.mostMoved.push_back(static_cast<double>(linear.middleCols<2>(k).cwiseAbs().maxCoeff()));
    for (int s = 0; s < linearPieces && !stop.stop_requested(); ++s)
        found.out += linearSample(linear, wanted.tolerances, static_cast<std::uint64_t>(s)).p95 > wanted.limit;
    if (stop.stop_requested())
        return std::nullopt;
    return Linear{std::move(linear), found.p95};
}

/// What is known by the pieces that have been solved.
void countSolved(const std::vector<SweepSample>& all, const Linear& linear, const SweepWanted& wanted,
                 SweepFound& found)
{
    std::vector<const SweepSample*> resting;
    for (const SweepSample& sample : all)
        if (!sample.outside.empty())
            resting.push_back(&sample);
    found.solved = static_cast<int>(all.size());
    found.resting = static_cast<int>(resting.size());
    if (resting.empty())
        return; // what is known is by linear covers
    found.p95 = correctedP95(linear.p95, linear.columns, wanted.tolerances, resting);
    found.error = correctedRmsError(linear.p95, linear.columns, wanted.tolerances, resting);
    found.out = static_cast<int>(
        std::ranges::count_if(resting, [&](const SweepSample* sample) { return sample->p95 > wanted.limit; }));
}

void addSolved(Sweep& sweep, const Linear& linear, const SweepWanted& wanted, SweepFound& found,
               const SweepNews& news, const std::stop_token& stop)
{
    std::vector<SweepSample> all;
    double next = fewestTold;
    while (std::ssize(all) < wanted.samples) {
        const int count = std::min(piecesAtOnce, wanted.samples - static_cast<int>(all.size()));
        std::vector<SweepSample> more = sweep.solve(all.size(), count, stop);
        if (stop.stop_requested())
            return;
        std::ranges::move(more, std::back_inserter(all));
        const auto resting = std::ranges::count_if(all, [](const SweepSample& s) { return !s.outside.empty(); });
        const bool tells = static_cast<double>(resting) >= next; // of fewer 95 % means nothing
        if (tells) {
            countSolved(all, linear, wanted, found);
            next = untilNext * static_cast<double>(resting);
        }
        news(shareLinear + (1 - shareLinear) * static_cast<double>(all.size()) / wanted.samples,
             tells ? &found : nullptr);
    }
    countSolved(all, linear, wanted, found);
}

} // namespace

double SweepFound::outShare() const
{
    return static_cast<double>(out) / (resting > 0 ? resting : linearPieces);
}

SweepFound findSweep(const SweepWanted& wanted, const SweepNews& news, const std::stop_token& stop)
{
    SweepFound found;
    found.number = wanted.number;
    try {
        Sweep sweep(wanted.input, wanted.tolerances, 0, stop);
        found.problem = sweep.problem();
        found.nominal = sweep.nominal();
        const std::optional<Linear> linear =
            found.nominal ? addLinear(sweep, wanted, found, news, stop) : std::nullopt;
        if (!linear)
            return found;
        if (wanted.samples > 0) {
            news(shareLinear, &found);
            addSolved(sweep, *linear, wanted, found, news, stop);
        }
        found.whole = true;
    } catch (const std::exception& error) {
        found.problem = failureMessage(error);
    }
    return found;
}

} // namespace bolster
