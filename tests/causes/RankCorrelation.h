// Whether two rows of numbers have the same order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bolster::test {

/// Spearman's, for numbers that are all different: 1 for the same order, -1 for the opposite one.
inline double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b)
{
    const auto rank = [](const std::vector<double>& all, double value) {
        return static_cast<double>(std::ranges::count_if(all, [&](double other) { return other < value; }));
    };
    double squares = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double apart = rank(a, a[k]) - rank(b, b[k]);
        squares += apart * apart;
    }
    const auto n = static_cast<double>(a.size());
    return n > 1 ? 1 - 6 * squares / (n * (n * n - 1)) : 0;
}

} // namespace bolster::test
