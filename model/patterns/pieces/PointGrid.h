// What is near a point. Private to the library.
#pragma once

#include "Geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace bolster {

/// Indices of points by where they are, in squares of a grid.
class PointGrid {
public:
    explicit PointGrid(double reach)
        : m_reach(std::max(reach, 1e-9))
    {}

    void add(const Vec2& at, std::size_t index) { m_squares[key(square(at.x()), square(at.y()))].push_back(index); }

    /// Points of squares around one that were added after it, so many of each square at most. `index` grows as they
    /// are added.
    template <class Visit>
    void nearLater(const Vec2& at, std::size_t index, std::size_t most, const Visit& visit) const
    {
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t k = -1; k <= 1; ++k)
                if (const auto found = m_squares.find(key(square(at.x()) + i, square(at.y()) + k));
                    found != m_squares.end()) {
                    auto later = std::ranges::upper_bound(found->second, index);
                    for (std::size_t n = 0; n < most && later != found->second.end(); ++n, ++later)
                        visit(*later);
                }
    }

    /// So many of each square around a point at most.
    template <class Visit>
    void some(const Vec2& at, std::size_t most, const Visit& visit) const
    {
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t k = -1; k <= 1; ++k)
                if (const auto found = m_squares.find(key(square(at.x()) + i, square(at.y()) + k));
                    found != m_squares.end())
                    for (std::size_t n = 0; n < std::min(most, found->second.size()); ++n)
                        visit(found->second[n]);
    }

    template <class Visit>
    void near(const Vec2& at, const Visit& visit) const
    {
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t k = -1; k <= 1; ++k)
                if (const auto found = m_squares.find(key(square(at.x()) + i, square(at.y()) + k));
                    found != m_squares.end())
                    for (const std::size_t index : found->second)
                        visit(index);
    }

private:
    std::int64_t square(double x) const
    {
        return static_cast<std::int64_t>(std::floor(std::clamp(x / m_reach, -1e15, 1e15)));
    }
    static std::uint64_t key(std::int64_t i, std::int64_t k)
    {
        return static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ull ^
               static_cast<std::uint64_t>(k) * 0xC2B2AE3D27D4EB4Full;
    }

    double m_reach;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> m_squares;
};

} // namespace bolster
