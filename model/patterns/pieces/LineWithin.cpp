#include "LineWithin.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace bolster {

namespace {

constexpr double widestAllowance = 80;
constexpr double evenAllowance = 0.35; // of its width: how much a line may come nearer and be an allowance still

} // namespace

bool isWithin(const Contour& inner, const Contour& outer)
{
    const Box2 a = inner.box(), b = outer.box();
    if ((a.min().array() < b.min().array() - sameVertex).any() ||
        (a.max().array() > b.max().array() + sameVertex).any())
        return false;
    const std::size_t step = std::max<std::size_t>(1, inner.points.size() / 64);
    for (std::size_t i = 0; i < inner.points.size(); i += step)
        if (!outer.contains(inner.points[i].at) && outer.distance(inner.points[i].at) > sameVertex)
            return false;
    return true;
}

bool followsWithin(const Contour& inner, const Contour& outer)
{
    if (!isWithin(inner, outer))
        return false;
    std::vector<double> distances;
    const std::size_t step = std::max<std::size_t>(1, inner.points.size() / 200);
    for (std::size_t i = 0; i < inner.points.size(); i += step) {
        const Vec2 &a = inner.points[i].at, &b = inner.points[(i + 1) % inner.points.size()].at;
        distances.push_back(outer.distance((a + b) / 2));
    }
    std::ranges::sort(distances);
    const double middle = distances[distances.size() / 2];
    return distances.back() < widestAllowance && distances.back() <= middle * (1 + evenAllowance) + 0.5 &&
           distances.front() >= middle * (1 - evenAllowance) - 0.5 && outer.signedArea() < 4 * inner.signedArea();
}

void sortLargestFirst(std::vector<Contour>& lines)
{
    std::vector<std::pair<bool, double>> sizes;
    for (const Contour& line : lines)
        sizes.emplace_back(line.closed, line.closed ? std::abs(line.signedArea()) : 0);
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return sizes[i]; });
    std::vector<Contour> sorted;
    for (const std::size_t i : order)
        sorted.push_back(std::move(lines[i]));
    lines = std::move(sorted);
}

} // namespace bolster
