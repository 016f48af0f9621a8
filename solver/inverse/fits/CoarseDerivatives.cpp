#include "CoarseDerivatives.h"

#include "PatternLocator.h"

#include <algorithm>

namespace bolster {

namespace {

/// Of each vertex its place and where it lies in the pattern.
constexpr int perVertex = 5;

Eigen::VectorXd asColumn(const WarmCover& cover)
{
    const std::vector<Vec3> places = vertexPlaces(cover);
    const std::vector<Vec2>& pattern = cover.mesh().topology->pattern;
    Eigen::VectorXd column(perVertex * std::ssize(places));
    for (std::size_t v = 0; v < places.size(); ++v)
        column.segment<perVertex>(perVertex * static_cast<Eigen::Index>(v)) << places[v], pattern[v];
    return column;
}

/// Where the vertices of one surface lie on another one of the same pattern; those of patches that it lacks
/// nowhere.
std::vector<PatternPlace> placesOn(const SurfaceTopology& few, const SurfaceTopology& many)
{
    std::vector<PatternPlace> places(many.pattern.size());
    for (const SurfaceTopology::PatchRange& range : many.patches) {
        const auto there = std::ranges::find(few.patches, range.patch, &SurfaceTopology::PatchRange::patch);
        if (there == few.patches.end() || there->triangleCount == 0)
            continue;
        const PatternLocator locator(few, *there);
        for (std::uint32_t v = range.firstVertex; v < range.firstVertex + range.vertexCount; ++v)
            places[v] = locator.locate(many.pattern[v]);
    }
    return places;
}

} // namespace

CoarseDerivatives::CoarseDerivatives(const SolveInput& input, const WarmOrder& order, int threads,
                                     const std::stop_token& stop)
    : m_team(input, order, threads, stop)
{}

Derivatives CoarseDerivatives::of(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                                  const Measure& measure, const std::function<void(double)>& progress,
                                  const std::stop_token& stop)
{
    if (!m_team.moveHome(at, stop))
        return {};
    m_few = differentiate(
        m_team, at, freedoms, [](const WarmCover& cover, const Design&) { return asColumn(cover); }, false,
        progress, stop);
    return carriedTo(fine, at, freedoms, measure, stop);
}

Derivatives CoarseDerivatives::again(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                                     const Measure& measure, const std::stop_token& stop)
{
    const bool theirs = m_few.columns.cols() == std::ssize(freedoms) && m_team.moveHome(at, stop) &&
                        m_few.columns.rows() == perVertex * std::ssize(m_team.first().mesh().topology->unknown);
    return theirs ? carriedTo(fine, at, freedoms, measure, stop) : Derivatives();
}

Derivatives CoarseDerivatives::carriedTo(const WarmCover& fine, const Design& at, std::span<const Freedom> freedoms,
                                         const Measure& measure, const std::stop_token& stop)
{
    Derivatives result{{}, m_few.known};
    // Where the few triangles lie in the pattern now.
    if (m_few.columns.size() == 0 || !m_team.first().follow(at, stop))
        return result;
    const std::vector<PatternPlace> on = placesOn(*m_team.first().mesh().topology, *fine.mesh().topology);
    const std::vector<Vec3> places = vertexPlaces(fine);
    const Eigen::VectorXd here = measure(*fine.mesh().topology, places, at);
    result.columns = Eigen::MatrixXd::Zero(here.size(), std::ssize(freedoms));
    m_team.forTasks(static_cast<int>(freedoms.size()), [&](WarmCover&, int task) {
        if (!m_few.known[static_cast<std::size_t>(task)] || stop.stop_requested())
            return;
        const std::span<const Freedom> one = freedoms.subspan(static_cast<std::size_t>(task), 1);
        const double step = usualStep(one.front());
        std::vector<Vec3> moved = places;
        SurfaceTopology topology = *fine.mesh().topology;
        for (std::size_t v = 0; v < moved.size(); ++v) {
            Eigen::Vector<double, perVertex> by = Eigen::Vector<double, perVertex>::Zero();
            for (std::size_t k = 0; k < 3; ++k)
                by += on[v].weights[static_cast<Eigen::Index>(k)] *
                      m_few.columns.col(task).segment<perVertex>(perVertex *
                                                                 static_cast<Eigen::Index>(on[v].corners[k]));
            moved[v] += step * by.head<3>();
            topology.pattern[v] += step * by.tail<2>();
        }
        const Design beside = withFreedoms(at, one, Eigen::VectorXd::Constant(1, step));
        const Eigen::VectorXd there = measure(topology, moved, beside);
        if (there.size() == here.size())
            result.columns.col(task) = (there - here) / step;
    });
    return result;
}

} // namespace bolster
