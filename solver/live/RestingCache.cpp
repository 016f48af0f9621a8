#include "RestingCache.h"

#include "SolvePlan.h"

#include <algorithm>
#include <iterator>

namespace bolster {

namespace {

/// Designs and files are shared with the document.
std::size_t bytesOf(const RestingSurface& kept)
{
    const SurfaceTopology& topology = *kept.surface->topology;
    return kept.surface->positions.size() * (sizeof(Vec3) + sizeof(Eigen::Vector3f)) +
           topology.triangles.size() * sizeof(topology.triangles[0]) +
           topology.pattern.size() * (sizeof(Vec2) + sizeof(std::uint32_t)) +
           static_cast<std::size_t>(kept.state.positions.size() + kept.state.frames.size()) * sizeof(double);
}

} // namespace

RestingSurfacePtr RestingCache::find(const SolveInput& input)
{
    const std::scoped_lock lock(m_mutex);
    return findLocked(input);
}

RestingSurfacePtr RestingCache::findLocked(const SolveInput& input)
{
    const auto found = std::ranges::find_if(m_surfaces, [&](const RestingSurfacePtr& kept) {
        return planSolve(kept->input, input) == SolvePlan::Nothing;
    });
    if (found == m_surfaces.end())
        return nullptr;
    m_surfaces.splice(m_surfaces.begin(), m_surfaces, found);
    return m_surfaces.front();
}

void RestingCache::keep(RestingSurface surface)
{
    auto kept = std::make_shared<const RestingSurface>(std::move(surface));
    const std::scoped_lock lock(m_mutex);
    if (findLocked(kept->input))
        m_surfaces.front() = std::move(kept);
    else
        m_surfaces.push_front(std::move(kept));
    constexpr std::size_t least = 2;
    std::size_t bytes = 0, count = 0;
    const auto last = std::ranges::find_if(m_surfaces, [&](const RestingSurfacePtr& other) {
        bytes += bytesOf(*other);
        return ++count > least && bytes > m_most;
    });
    m_surfaces.erase(last, m_surfaces.end());
}

void RestingCache::clear()
{
    const std::scoped_lock lock(m_mutex);
    m_surfaces.clear();
}

std::size_t RestingCache::count() const
{
    const std::scoped_lock lock(m_mutex);
    return m_surfaces.size();
}

} // namespace bolster
