// Which boxes hold a point. Private to the library.
#pragma once

#include "Geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace bolster {

/// Boxes of all sizes, each in the squares of a grid that is as coarse as it is large. More may be added at any
/// time.
class BoxLevels {
public:
    void add(const Box2& box, std::size_t index)
    {
        if (box.isEmpty())
            return;
        const int level = levelOf(box);
        eachSquare(box, level, [&](std::uint64_t where) { m_levels[level][where].push_back({box, index}); });
    }

    /// Calls visit(index) for each box that the point lies in, in no order.
    template <class Visit>
    void at(const Vec2& point, const Visit& visit) const
    {
        for (const auto& [level, squares] : m_levels)
            if (const auto found = squares.find(key(square(point.x(), level), square(point.y(), level)));
                found != squares.end())
                for (const auto& [box, index] : found->second)
                    if (box.contains(point))
                        visit(index);
    }

    /// Whether one of them has more than `slack` in common with a box that is no larger than any of them.
    bool anyMeets(const Box2& box, double slack) const
    {
        bool meets = false;
        for (const auto& [level, squares] : m_levels)
            eachSquare(box, level, [&, &squares = squares](std::uint64_t where) {
                if (const auto found = squares.find(where); found != squares.end() && !meets)
                    meets = std::ranges::any_of(found->second, [&](const auto& other) {
                        const Box2 common = box.intersection(other.first);
                        return !common.isEmpty() && common.sizes().minCoeff() > slack;
                    });
            });
        return meets;
    }

private:
    static int levelOf(const Box2& box) { return std::ilogb(std::max(box.sizes().maxCoeff(), 1e-6)) + 1; }
    static std::int64_t square(double x, int level)
    {
        return static_cast<std::int64_t>(std::floor(std::clamp(std::ldexp(x, -level), -1e15, 1e15)));
    }
    static std::uint64_t key(std::int64_t i, std::int64_t k)
    {
        return static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ull ^
               static_cast<std::uint64_t>(k) * 0xC2B2AE3D27D4EB4Full;
    }
    template <class Visit>
    static void eachSquare(const Box2& box, int level, const Visit& visit)
    {
        const std::int64_t x = square(box.max().x(), level), y = square(box.max().y(), level);
        for (std::int64_t i = square(box.min().x(), level); i <= x; ++i)
            for (std::int64_t k = square(box.min().y(), level); k <= y; ++k)
                visit(key(i, k));
    }

    std::map<int, std::unordered_map<std::uint64_t, std::vector<std::pair<Box2, std::size_t>>>> m_levels;
};

} // namespace bolster
