#include "RationalSpline.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr int highestDegree = 15;
constexpr int stepsPerSpan = 16;

} // namespace

bool RationalSpline::isSound() const
{
    const auto order = static_cast<std::size_t>(degree) + 1;
    return degree >= 1 && degree <= highestDegree && points.size() >= order &&
           knots.size() == points.size() + order && std::ranges::is_sorted(knots) &&
           (weights.empty() || weights.size() == points.size()) &&
           std::ranges::all_of(weights, [](double weight) { return weight > 0; }) &&
           knots[points.size()] > knots[static_cast<std::size_t>(degree)];
}

/// De Boor's algorithm in homogeneous coordinates.
Vec2 RationalSpline::at(double t, std::size_t span) const
{
    const auto order = static_cast<std::size_t>(degree);
    std::vector<Vec3> d;
    for (std::size_t i = span - order; i <= span; ++i) {
        const double weight = weights.empty() ? 1 : weights[i];
        d.emplace_back(weight * points[i].x(), weight * points[i].y(), weight);
    }
    for (std::size_t r = 1; r <= order; ++r)
        for (std::size_t j = order; j >= r; --j) {
            const double low = knots[span - order + j], high = knots[span + 1 + j - r];
            const double share = high > low ? (t - low) / (high - low) : 0;
            d[j] = (1 - share) * d[j - 1] + share * d[j];
        }
    return d[order].head<2>() / d[order].z();
}

void RationalSpline::draw(DrawingPen& pen) const
{
    const auto order = static_cast<std::size_t>(degree);
    for (std::size_t span = order; span < points.size(); ++span) {
        const double from = knots[span], to = knots[span + 1];
        if (!(to > from))
            continue;
        std::vector<Vec2> row;
        const int steps = degree == 1 ? 1 : stepsPerSpan;
        for (int k = pen.empty() ? 0 : 1; k <= steps; ++k)
            row.push_back(at(from + (to - from) * k / steps, span));
        // Where spans meet, the curve is smooth unless so many knots fall together.
        const auto same = std::equal_range(knots.begin(), knots.end(), to);
        pen.smoothTo(row);
        if (same.second - same.first < degree)
            pen.smoothHere();
    }
}

} // namespace bolster
