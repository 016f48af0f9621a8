#include "CoverTeam.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

namespace bolster {

CoverTeam::CoverTeam(const SolveInput& input, WarmOrder order, int threads, const std::stop_token& stop)
{
    const int count = threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    m_covers.resize(static_cast<std::size_t>(count));
    order.threads = 1;
    std::vector<std::jthread> makers;
    for (auto& cover : m_covers)
        makers.emplace_back([&] { cover = std::make_unique<WarmCover>(input, order, stop); });
}

void CoverTeam::forTasks(int count, const std::function<void(WarmCover&, int)>& work)
{
    std::atomic<int> next = 0;
    std::vector<std::jthread> workers;
    for (auto& cover : m_covers)
        workers.emplace_back([&] {
            for (int task = next++; task < count; task = next++)
                work(*cover, task);
        });
}

bool CoverTeam::moveHome(const Design& design, const std::stop_token& stop)
{
    std::atomic<bool> all = true;
    std::vector<std::jthread> movers;
    for (auto& cover : m_covers)
        movers.emplace_back([&] {
            if (!cover->moveHome(design, stop))
                all = false;
        });
    movers.clear();
    return all;
}

double usualStep(const Freedom& freedom)
{
    return freedom.step > freedom.most ? -freedom.step : freedom.step;
}

std::vector<Vec3> vertexPlaces(const WarmCover& cover)
{
    const Eigen::Matrix3Xd positions = cover.state().positions;
    std::vector<Vec3> places;
    places.reserve(cover.mesh().topology->unknown.size());
    for (const std::uint32_t u : cover.mesh().topology->unknown)
        places.emplace_back(positions.col(u));
    return places;
}

Eigen::VectorXd placesOf(const WarmCover& cover)
{
    const Eigen::Matrix3Xd positions = cover.state().positions;
    return positions.reshaped();
}

Derivatives differentiate(CoverTeam& team, const Design& at, std::span<const Freedom> freedoms,
                          const CoverMeasure& measure, bool central, const std::function<void(double)>& progress,
                          const std::stop_token& stop)
{
    const int count = static_cast<int>(freedoms.size());
    Derivatives result;
    result.known.assign(freedoms.size(), false);
    Eigen::VectorXd here;
    if (!central) {
        if (!team.first().follow(at, stop))
            return result;
        here = measure(team.first(), at);
    }
    std::mutex mutex; // of what follows
    std::vector<char> known(freedoms.size(), 0);
    int done = 0;
    team.forTasks(count, [&](WarmCover& cover, int k) {
        if (stop.stop_requested())
            return;
        const std::span<const Freedom> one = freedoms.subspan(static_cast<std::size_t>(k), 1);
        const double step = usualStep(one.front());
        const auto beside = [&](double value) -> Eigen::VectorXd {
            const Design moved = withFreedoms(at, one, Eigen::VectorXd::Constant(1, value));
            return cover.lookBeside(moved, stop) ? measure(cover, moved) : Eigen::VectorXd();
        };
        const Eigen::VectorXd after = beside(step), before = central ? beside(-step) : here;
        const std::scoped_lock lock(mutex);
        if (after.size() > 0 && after.size() == before.size()) {
            if (result.columns.size() == 0)
                result.columns = Eigen::MatrixXd::Zero(after.size(), count);
            result.columns.col(k) = (after - before) / (central ? 2 * step : step);
            known[static_cast<std::size_t>(k)] = 1;
        }
        if (progress)
            progress(static_cast<double>(++done) / count);
    });
    result.known.assign(known.begin(), known.end());
    return result;
}

} // namespace bolster
