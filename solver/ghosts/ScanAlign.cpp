#include "ScanAlign.h"

#include "RigidFit.h"
#include "WorkerPool.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr std::size_t coarseSamples = 2000, fineSamples = 20'000;
constexpr std::size_t fewestSamples = 20;
constexpr int targetPlaces = 1500;
constexpr double clearly = 0.98;
constexpr double leastReach = 40, mostReach = 200; // mm, at the beginning
constexpr double reachShare = 0.12;                // of the target's diagonal
constexpr double shrinking = 0.6;                  // of the reach, from stage to stage
constexpr double tightest = 1;                     // mm: no scanner is more exact
constexpr double noiseReach = 4.5;                 // standard deviations
constexpr double fineFrom = 30;                    // mm of reach: from there on all samples count
constexpr int startSteps = 12, stageSteps = 30;
constexpr double resting = 2e-4;   // mm: a step that is none
constexpr double startTurn = 0.21; // 12 degrees
constexpr double steepest = 0.6;   // cosine between the way to a foot and its normal: beside a border it is less

struct FootMatch {
    PlanePair pair;
    double distance = std::numeric_limits<double>::infinity(); // mm; infinite: none
};

class Aligner {
public:
    Aligner(const AlignTarget& target, const ScanIndex& index, const std::stop_token& stop,
            const std::function<void(int)>& progress)
        : m_target(target)
        , m_index(index)
        , m_stop(stop)
        , m_progress(progress)
        , m_middle(target.box().center())
        , m_radius(0.5 * target.box().diagonal().norm())
    {}

    std::optional<ScanAlignment> run(const Placement& from)
    {
        const std::vector<Vec3> coarse = samplesNear(from, coarseSamples);
        if (coarse.size() < fewestSamples || !(m_radius > 0))
            return std::nullopt;
        auto [placement, reach] = bestStart(from, coarse);
        std::vector<Vec3> fine;
        for (;;) {
            const bool all = reach <= fineFrom;
            if (all && fine.empty())
                fine = samplesNear(placement, fineSamples);
            const std::vector<Vec3>& samples = all ? fine : coarse;
            if (!descend(placement, samples, reach, stageSteps))
                return std::nullopt;
            if (!all) {
                reach = std::max(fineFrom, shrinking * reach);
                continue;
            }
            const double floor = std::max(tightest, noiseReach * noise(placement, samples, reach));
            if (reach <= floor)
                break;
            reach = std::max(floor, shrinking * reach);
        }
        return measured(placement, fine, reach);
    }

private:
    /// Points of the scan that are near the target, or might be; evenly out of their order.
    std::vector<Vec3> samplesNear(const Placement& placement, std::size_t most) const
    {
        Box3 box = m_target.box();
        const Vec3 room = Vec3::Constant(0.25 * m_radius + leastReach);
        box = Box3(box.min() - room, box.max() + room);
        std::vector<Vec3> near;
        for (int i = 0; i < m_index.size(); ++i)
            if (box.contains(placement.placed(m_index.point(i))))
                near.push_back(m_index.point(i));
        if (near.size() <= most)
            return near;
        std::vector<Vec3> samples;
        for (std::size_t k = 0; k < most; ++k)
            samples.push_back(near[k * near.size() / most]);
        return samples;
    }

    struct Start {
        Placement placement;
        double reach = 0;
    };

    /// The given one, or one that is turned a little against it, with a reach that is long enough and not so long
    /// that a wall behind the target is taken for it: whichever leaves the least of the target without points.
    Start bestStart(const Placement& from, const std::vector<Vec3>& samples)
    {
        const double longest = std::clamp(reachShare * 2 * m_radius, leastReach, mostReach);
        const std::vector<Vec3> places = m_target.spread(targetPlaces);
        Start best{from, longest};
        double least = std::numeric_limits<double>::infinity();
        for (double reach = longest; reach >= fineFrom; reach /= 2)
            for (int k = 0; k <= 6; ++k) {
                Placement start = k == 0 ? from : turned(from, k);
                if (!descend(start, samples, reach, startSteps))
                    continue;
                const double cost = bareness(start, places);
                if (cost < clearly * least) { // where nothing tells them apart, as it was clicked
                    least = cost;
                    best = {start, reach};
                }
            }
        return best;
    }

    /// 0 to 1: how little of the target has points of the scan.
    double bareness(const Placement& placement, const std::vector<Vec3>& places) const
    {
        double sum = 0;
        for (const Vec3& place : places) {
            const double distance =
                placement.scale *
                m_index.search(placement.filePoint(place), fineFrom / placement.scale).firstDistance;
            sum += std::min(1.0, std::pow(distance / fineFrom, 2));
        }
        return sum / static_cast<double>(std::max<std::size_t>(1, places.size()));
    }

    Placement turned(const Placement& from, int k) const
    {
        const Vec3 axis = Vec3::Unit((k - 1) / 2);
        const Quat turn(Eigen::AngleAxisd(k % 2 == 0 ? startTurn : -startTurn, axis));
        Placement start = from;
        start.rotation = (turn * from.rotation).normalized();
        start.position = turn * (from.position - m_middle) + m_middle;
        return start;
    }

    std::vector<FootMatch> matches(const Placement& placement, const std::vector<Vec3>& samples, double reach)
    {
        std::vector<FootMatch> found(samples.size());
        m_pool.forChunks(static_cast<int>(samples.size()), [&](int, int begin, int end) {
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                const Vec3 at = placement.placed(samples[i]);
                const std::optional<AlignTarget::Foot> foot = m_target.nearest(at, reach);
                if (!foot)
                    continue;
                const Vec3 way = at - foot->point;
                const double distance = way.norm(), along = foot->normal.dot(way);
                if (std::abs(along) < steepest * distance && distance > 0.1 * reach)
                    continue; // beside the border of what is there
                found[i] = {{at - m_middle, foot->normal, along}, distance};
            }
        });
        return found;
    }

    /// Tukey's weights.
    bool descend(Placement& placement, const std::vector<Vec3>& samples, double reach, int steps)
    {
        for (int i = 0; i < steps; ++i) {
            if (m_stop.stop_requested())
                return false;
            if (m_progress)
                m_progress(m_step++);
            RigidFit fit(m_middle, m_radius);
            std::size_t count = 0;
            for (FootMatch& match : matches(placement, samples, reach)) {
                const double share = match.distance / reach;
                if (!(share < 1))
                    continue;
                match.pair.weight = std::pow(1 - share * share, 2);
                fit.add(match.pair);
                ++count;
            }
            double length = 0;
            const std::optional<Placement> moved = fit.moved(placement, &length);
            if (count < 6 || !moved)
                return false;
            placement = *moved;
            if (length < resting)
                break;
        }
        return true;
    }

    /// The standard deviation, by the quarter that lies nearest: most of the others may belong to something else.
    double noise(const Placement& placement, const std::vector<Vec3>& samples, double reach)
    {
        std::vector<double> along;
        for (const FootMatch& match : matches(placement, samples, reach))
            if (match.distance < reach)
                along.push_back(std::abs(match.pair.along));
        if (along.empty())
            return 0;
        const auto quarter = along.begin() + std::ssize(along) / 4;
        std::nth_element(along.begin(), quarter, along.end());
        constexpr double ofDeviation = 0.3186; // within it lies a quarter of a normal distribution
        return *quarter / ofDeviation;
    }

    /// Of all the scan's points, not only of those that were looked at.
    std::optional<ScanAlignment> measured(const Placement& placement, const std::vector<Vec3>& samples,
                                          double reach)
    {
        ScanAlignment result{placement, 0, reach, 0};
        std::size_t count = 0;
        for (const FootMatch& match : matches(placement, samples, reach))
            if (match.distance < reach) {
                result.rms += match.pair.along * match.pair.along;
                ++count;
            }
        if (count < fewestSamples || m_stop.stop_requested())
            return std::nullopt;
        result.rms = std::sqrt(result.rms / static_cast<double>(count));
        std::vector<Vec3> all;
        const std::size_t step = 1 + static_cast<std::size_t>(m_index.size()) / (5 * fineSamples);
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_index.size()); i += step)
            all.push_back(m_index.point(static_cast<int>(i)));
        const std::vector<FootMatch> found = matches(placement, all, reach);
        const auto near =
            std::ranges::count_if(found, [&](const FootMatch& match) { return match.distance < reach; });
        result.matched = static_cast<double>(near) / static_cast<double>(all.size());
        return result;
    }

    const AlignTarget& m_target;
    const ScanIndex& m_index;
    const std::stop_token& m_stop;
    const std::function<void(int)>& m_progress;
    Vec3 m_middle;
    double m_radius;
    int m_step = 0;
    WorkerPool m_pool{0};
};

/// Of what lies on a line the second is none of the first.
constexpr double leastBreadth = 0.02;

bool spansPlane(const Eigen::Matrix3Xd& points)
{
    const Eigen::JacobiSVD<Eigen::Matrix3Xd> axes(points);
    const Vec3 sizes = Vec3(axes.singularValues());
    return sizes.allFinite() && sizes[1] > leastBreadth * sizes[0];
}

} // namespace

std::optional<Placement> placementByPairs(const std::vector<ScanPair>& pairs, const Placement& from)
{
    if (pairs.size() < 3)
        return std::nullopt;
    Eigen::Matrix3Xd scan(3, static_cast<Eigen::Index>(pairs.size())), target = scan;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        scan.col(static_cast<Eigen::Index>(i)) = from.scale * pairs[i].onScan;
        target.col(static_cast<Eigen::Index>(i)) = pairs[i].onTarget;
    }
    const Vec3 scanMiddle = scan.rowwise().mean(), targetMiddle = target.rowwise().mean();
    scan.colwise() -= scanMiddle;
    target.colwise() -= targetMiddle;
    if (!spansPlane(scan) || !spansPlane(target))
        return std::nullopt;
    const Eigen::JacobiSVD<Eigen::Matrix3d> axes(target * scan.transpose(),
                                                 Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double hand = axes.matrixU().determinant() * axes.matrixV().determinant();
    const Eigen::Matrix3d rotation =
        axes.matrixU() * Vec3(1, 1, hand < 0 ? -1 : 1).asDiagonal() * axes.matrixV().transpose();
    Placement placement = from;
    placement.rotation = Quat(rotation).normalized();
    placement.position = targetMiddle - placement.rotation * scanMiddle;
    return placement;
}

double pairResidual(const std::vector<ScanPair>& pairs, const Placement& placement)
{
    double squares = 0;
    for (const ScanPair& pair : pairs)
        squares += (placement.placed(pair.onScan) - pair.onTarget).squaredNorm();
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, pairs.size())));
}

std::optional<ScanAlignment> alignScan(const AlignTarget& target, const ScanIndex& index, const Placement& from,
                                       const std::stop_token& stop, const std::function<void(int)>& progress)
{
    if (target.empty() || index.empty())
        return std::nullopt;
    return Aligner(target, index, stop, progress).run(from);
}

} // namespace bolster
