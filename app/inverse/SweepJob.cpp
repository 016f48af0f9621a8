#include "SweepJob.h"

#include "SolveFailure.h"
#include "VertexAreas.h"

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

constexpr double shareLinear = 0.2; // of the time, when pieces are solved
constexpr int linearSamples = 10'000;
constexpr int piecesAtOnce = 10;
constexpr double fewestTold = 20;
constexpr double untilNext = 1.5; // times as many pieces as were known when figures were told last

/// None when it was stopped.
std::shared_ptr<const LinearCovers> linearCovers(Sweep& sweep, const SweepWanted& wanted, const SweepNews& news,
                                                 const std::stop_token& stop)
{
    auto linear = std::make_shared<LinearCovers>();
    linear->nominal = sweep.nominal();
    const double share = wanted.samples > 0 ? shareLinear : 1;
    linear->columns = sweep.linear([&](double done) { news(share * done, nullptr); }, stop);
    linear->unknown = sweep.unknown();
    if (!stop.stop_requested())
        linear->p95 = linearP95(linear->columns, wanted.tolerances, linearSamples, stop);
    return stop.stop_requested() ? nullptr : linear;
}

/// What is known without a solved piece.
void countLinear(const SweepWanted& wanted, SweepFound& found, const std::stop_token& stop)
{
    const LinearCovers& linear = *found.known.linear;
    found.p95 = linear.p95.map;
    found.influence = influences(linear.columns, wanted.tolerances,
                                 vertexAreas(*linear.nominal->topology, linear.nominal->positions));
    for (Eigen::Index k = 0; k < linear.columns.cols(); k += 2)
        found.mostMoved.push_back(static_cast<double>(linear.columns.middleCols<2>(k).cwiseAbs().maxCoeff()));
    for (int s = 0; s < SweepFound::linearPieces && !stop.stop_requested(); ++s)
        found.out +=
            linearSample(linear.columns, wanted.tolerances, static_cast<std::uint64_t>(s)).p95 > wanted.limit;
}

/// What is known by the pieces that have been solved.
void countSolved(const SweepWanted& wanted, SweepFound& found)
{
    const auto& pieces = found.known.pieces;
    std::vector<const SweepSample*> resting;
    for (std::size_t k = 0; k < pieces.size() && std::cmp_less(k, wanted.samples); ++k)
        if (!pieces[k]->outside.empty())
            resting.push_back(pieces[k].get());
    found.solved = std::min(static_cast<int>(pieces.size()), wanted.samples);
    found.resting = static_cast<int>(resting.size());
    if (resting.empty())
        return; // what is known is by linear covers
    const LinearCovers& linear = *found.known.linear;
    CorrectedP95 corrected = correctedP95(linear.p95, linear.columns, wanted.tolerances, resting);
    found.p95 = std::move(corrected.map);
    found.error = corrected.rmsError;
    found.out = static_cast<int>(
        std::ranges::count_if(resting, [&](const SweepSample* sample) { return sample->p95 > wanted.limit; }));
}

void solvePieces(Sweep& sweep, const SweepWanted& wanted, SweepFound& found, const SweepNews& news,
                 const std::stop_token& stop)
{
    auto& pieces = found.known.pieces;
    double next = std::max(fewestTold, untilNext * found.resting);
    std::ptrdiff_t resting = found.resting;
    while (std::ssize(pieces) < wanted.samples) {
        const int count = std::min(piecesAtOnce, wanted.samples - static_cast<int>(pieces.size()));
        std::vector<SweepSample> more = sweep.solve(pieces.size(), count, stop);
        if (stop.stop_requested())
            return;
        for (SweepSample& sample : more) {
            resting += !sample.outside.empty();
            pieces.push_back(std::make_shared<const SweepSample>(std::move(sample)));
        }
        if (static_cast<double>(resting) >= next) { // of fewer 95 % means nothing
            countSolved(wanted, found);
            next = untilNext * static_cast<double>(resting);
        }
        news(shareLinear + (1 - shareLinear) * static_cast<double>(pieces.size()) / wanted.samples, &found);
    }
}

/// What is not known yet.
void findMore(const SweepWanted& wanted, SweepFound& found, const SweepNews& news, const std::stop_token& stop)
{
    Sweep sweep(wanted.input, wanted.tolerances, 0, stop);
    found.problem = sweep.problem();
    if (!sweep.nominal())
        return;
    if (!found.known.linear)
        found.known.linear = linearCovers(sweep, wanted, news, stop);
    if (!found.known.linear)
        return;
    countLinear(wanted, found, stop);
    countSolved(wanted, found);
    if (std::ssize(found.known.pieces) < wanted.samples && !stop.stop_requested()) {
        news(shareLinear, &found);
        solvePieces(sweep, wanted, found, news, stop);
        countSolved(wanted, found);
    }
    found.whole = true;
}

} // namespace

SweepFound findSweep(const SweepWanted& wanted, const SweepNews& news, const std::stop_token& stop)
{
    SweepFound found;
    found.number = wanted.number;
    found.known = wanted.known;
    try {
        if (!found.known.linear || std::ssize(found.known.pieces) < wanted.samples) {
            findMore(wanted, found, news, stop);
        } else {
            countLinear(wanted, found, stop);
            countSolved(wanted, found);
            found.whole = true;
        }
    } catch (const std::exception& error) {
        found.problem = failureMessage(error);
    }
    return found;
}

} // namespace bolster
