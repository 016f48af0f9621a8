#include "SplineKnots.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace bolster::spline {

namespace {

constexpr double largestKnot = 1e7;

std::optional<Message> multiplicityProblem(int degree, bool closed, const std::vector<double>& knots, int first,
                                           int last)
{
    // A closed curve is looked at twice round, so that a knot at its start is counted on both sides.
    const double period = knots.back() - knots.front();
    const int count = last - first;
    int run = 1;
    for (int i = 1; i < (closed ? 2 * count : count); ++i) {
        const auto value = [&](int k) {
            const double base = knots[static_cast<std::size_t>(first + k % count)];
            // k_n is the same place as k_0, one turn later.
            return closed && base == knots.back() ? knots.front() + (k / count + 1) * period
                                                  : base + (k / count) * period;
        };
        run = value(i) == value(i - 1) ? run + 1 : 1;
        if (run > degree)
            return Message{QT_TRANSLATE_NOOP("Message",
                                             "knot %1 occurs more often than %2 times, the degree; remove "
                                             "the surplus ones"),
                           {numberText(value(i)), std::to_string(degree)}};
    }
    return std::nullopt;
}

std::optional<Message> clampProblem(int degree, const std::vector<double>& knots)
{
    const auto d = static_cast<std::size_t>(degree);
    const bool start =
        std::all_of(knots.begin(), knots.begin() + degree + 1, [&](double k) { return k == knots.front(); });
    const bool end =
        std::all_of(knots.end() - degree - 1, knots.end(), [&](double k) { return k == knots.back(); });
    if (start && end && knots[d] < knots[knots.size() - d - 1])
        return std::nullopt;
    return Message{QT_TRANSLATE_NOOP("Message",
                                     "the knots of an open curve must begin with %1 equal ones and end with "
                                     "%1 equal, larger ones"),
                   {std::to_string(degree + 1)}};
}

} // namespace

std::vector<double> defaultKnots(int degree, bool closed, int pointCount)
{
    std::vector<double> knots;
    if (closed) {
        for (int i = 0; i <= pointCount; ++i)
            knots.push_back(i);
        return knots;
    }
    const int end = pointCount - degree;
    for (int i = -degree; i <= end + degree; ++i)
        knots.push_back(std::clamp(i, 0, end));
    return knots;
}

std::vector<double> cornerKnots(int pointCount, const std::vector<int>& corners)
{
    std::vector<double> knots(static_cast<std::size_t>(pointCount) + 1);
    const auto set = [&](int index, double value) {
        const int turn = index < 0 ? -1 : index / pointCount;
        knots[static_cast<std::size_t>(index - turn * pointCount)] = value - turn * pointCount;
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int here = corners[i];
        const int next = i + 1 < corners.size() ? corners[i + 1] : corners.front() + pointCount;
        const int spans = next - here - 2;
        for (int j = 1; j < spans; ++j)
            set(here + 1 + j, here + (next - here) * static_cast<double>(j) / spans);
        for (int j = -1; j <= 1; ++j)
            set(here + j, here);
    }
    knots.back() = knots.front() + pointCount;
    return knots;
}

double smallestGap(const std::vector<double>& knots)
{
    const double first = knots.front();
    const double last = knots.back();
    return 1e-9 * std::max({last - first, std::abs(first), std::abs(last)});
}

std::optional<Message> knotProblem(int degree, bool closed, int pointCount, const std::vector<double>& knots)
{
    const int expected = closed ? pointCount + 1 : pointCount + degree + 1;
    if (static_cast<int>(knots.size()) != expected)
        return Message{QT_TRANSLATE_NOOP("Message", "%1 points of degree %2 need %3 knots, not %4"),
                       {std::to_string(pointCount), std::to_string(degree), std::to_string(expected),
                        std::to_string(knots.size())}};
    for (const double k : knots)
        if (!(std::abs(k) <= largestKnot))
            return Message{QT_TRANSLATE_NOOP("Message", "a knot is no number or beyond 1e7")};
    if (!std::is_sorted(knots.begin(), knots.end()))
        return Message{QT_TRANSLATE_NOOP("Message", "the knots must not decrease")};
    if (!(knots.back() > knots.front()))
        return Message{QT_TRANSLATE_NOOP("Message", "the last knot must be larger than the first")};
    const double gap = smallestGap(knots);
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i] != knots[i - 1] && knots[i] - knots[i - 1] < gap)
            return Message{QT_TRANSLATE_NOOP("Message", "two knots near %1 are almost equal; make them equal"),
                           {numberText(knots[i])}};
    if (closed)
        return multiplicityProblem(degree, true, knots, 0, pointCount);
    if (const auto wrong = clampProblem(degree, knots))
        return wrong;
    return multiplicityProblem(degree, false, knots, degree + 1, pointCount);
}

} // namespace bolster::spline
