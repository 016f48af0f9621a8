#include "CloudThinner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <unordered_set>

namespace bolster {
namespace {

using Cube = std::array<std::int64_t, 3>;

// A millisecond of work, or less: a busy machine makes it several.
constexpr std::size_t pointsBetweenChecks = 1 << 13;
constexpr std::size_t slotsBetweenChecks = 1 << 19;

Cube cubeOf(const Vec3& point, double edge)
{
    Cube cube;
    for (std::size_t axis = 0; axis < 3; ++axis)
        cube[axis] = static_cast<std::int64_t>(std::floor(point[static_cast<Eigen::Index>(axis)] / edge));
    return cube;
}

std::uint64_t hashOf(const Cube& cube, std::uint64_t seed)
{
    std::uint64_t hash = seed;
    for (const std::int64_t index : cube) {
        hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29;
    }
    hash *= 0xBF58476D1CE4E5B9u;
    return hash ^ hash >> 32;
}

/// Edges of cubes to choose from: quarters of octaves, so that they can be doubled.
double edgeNumber(int number)
{
    return std::exp2(number / 4.0);
}
constexpr int finest = -80;  // 1e-6: whatever the unit, no scanner sees that
constexpr int coarsest = 96; // 1.7e7: all in a few

} // namespace

CloudThinner::CloudThinner(std::size_t most, ImportWatch watch)
    : m_most(most)
    , m_watch(std::move(watch))
    , m_seed(std::random_device()() | std::uint64_t{std::random_device()()} << 32)
{}

void CloudThinner::reserve(std::uint64_t count)
{
    m_cloud.points.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, m_most)));
}

void CloudThinner::add(const Vec3& point, std::optional<std::uint32_t> color)
{
    if (++m_count % pointsBetweenChecks == 0)
        m_watch.checkStop();
    m_colored = color && (m_colored || m_count == 1);
    if (!m_colored)
        m_cloud.colors = {};
    if (m_taken.empty()) {
        if (!isFull()) {
            grow();
            append(point, color);
            return;
        }
        chooseGrid();
    }
    while (!keep(point, color)) {
        m_cloud.spacing *= 2;
        thin();
    }
}

PointCloud CloudThinner::take()
{
    if (!m_taken.empty())
        m_cloud.thinnedFrom = m_count;
    m_taken = {};
    if (m_cloud.points.size() < m_cloud.points.capacity() / 4 * 3)
        shrink();
    return std::move(m_cloud);
}

void CloudThinner::append(const Vec3& point, std::optional<std::uint32_t> color)
{
    m_cloud.points.push_back(point);
    if (m_colored)
        m_cloud.colors.push_back(*color);
}

/// Of many points all that may come get their room at once, before it is used: moving them again and again could
/// not be stopped.
void CloudThinner::grow()
{
    constexpr std::size_t many = 100'000;
    std::vector<Vec3>& points = m_cloud.points;
    if (points.size() == points.capacity() && points.size() >= many)
        points.reserve(m_most);
    if (m_colored && m_cloud.colors.size() == m_cloud.colors.capacity() && points.size() >= many)
        m_cloud.colors.reserve(m_most);
}

void CloudThinner::shrink()
{
    const std::vector<Vec3>& points = m_cloud.points;
    std::vector<Vec3> fitting;
    fitting.reserve(points.size());
    while (fitting.size() < points.size()) {
        m_watch.checkStop();
        const auto from = points.begin() + static_cast<std::ptrdiff_t>(fitting.size());
        const std::size_t count = std::min(pointsBetweenChecks, points.size() - fitting.size());
        fitting.insert(fitting.end(), from, from + static_cast<std::ptrdiff_t>(count));
    }
    m_cloud.points = std::move(fitting);
    m_cloud.colors.shrink_to_fit();
}

/// The finest one that leaves some room.
void CloudThinner::chooseGrid()
{
    const std::size_t goal = m_most / 10 * 9;
    int low = finest, high = coarsest;
    while (low < high) {
        const int probe = low + (high - low) / 2;
        if (estimateCubes(edgeNumber(probe)) <= goal)
            high = probe;
        else
            low = probe + 1;
    }
    m_cloud.spacing = edgeNumber(high);
    thin();
}

std::size_t CloudThinner::estimateCubes(double edge) const
{
    const std::uint64_t sampled = 1 + m_most / 200'000; // one cube of so many is counted
    std::unordered_set<std::uint64_t> found;
    for (std::size_t i = 0; i < m_cloud.points.size(); ++i) {
        if (i % pointsBetweenChecks == 0)
            m_watch.checkStop();
        const std::uint64_t hash =
            hashOf(cubeOf(m_cloud.points[i], edge), 1); // not by chance: the choice depends on it
        if (hash % sampled == 0)
            found.insert(hash);
    }
    return found.size() * sampled;
}

void CloudThinner::emptyCubes()
{
    const std::size_t places = std::bit_ceil(m_most + m_most / 2);
    m_taken.clear();
    m_taken.reserve(places);
    while (m_taken.size() < places) {
        m_watch.checkStop();
        m_taken.resize(std::min(places, m_taken.size() + slotsBetweenChecks));
    }
}

/// What there is, by the present grid; until it is not too many.
void CloudThinner::thin()
{
    for (bool fits = false; !fits;) {
        emptyCubes();
        std::vector<Vec3>& points = m_cloud.points;
        const std::size_t count = points.size();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (i % pointsBetweenChecks == 0)
                m_watch.checkStop();
            const Vec3 point = points[i];
            const std::size_t slot = slotOf(point);
            if (m_taken[slot] != 0)
                continue;
            if (m_colored)
                m_cloud.colors[kept] = m_cloud.colors[i];
            points[kept++] = point;
            m_taken[slot] = static_cast<std::uint32_t>(kept);
        }
        points.resize(kept);
        if (m_colored)
            m_cloud.colors.resize(kept);
        fits = kept < m_most;
        if (!fits)
            m_cloud.spacing *= 2;
    }
}

/// False when the cube is free but there is no room for its point.
bool CloudThinner::keep(const Vec3& point, std::optional<std::uint32_t> color)
{
    const std::size_t slot = slotOf(point);
    if (m_taken[slot] != 0)
        return true;
    if (isFull())
        return false;
    append(point, color);
    m_taken[slot] = static_cast<std::uint32_t>(m_cloud.points.size());
    return true;
}

/// Where the point's cube is, or would be.
std::size_t CloudThinner::slotOf(const Vec3& point) const
{
    const Cube cube = cubeOf(point, m_cloud.spacing);
    const std::size_t mask = m_taken.size() - 1;
    std::size_t slot = hashOf(cube, m_seed) & mask;
    while (m_taken[slot] != 0 && cubeOf(m_cloud.points[m_taken[slot] - 1], m_cloud.spacing) != cube)
        slot = (slot + 1) & mask;
    return slot;
}

} // namespace bolster
