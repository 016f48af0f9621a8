#include "PiecedSpline.h"

#include "PlaneCurves.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

/// The polar form of a piece: its control points are its values at its ends.
Vec2 polar(const BezierPiece<2>& piece, const std::array<double, 3>& arguments)
{
    std::array<Vec2, 4> p = piece.points;
    for (int r = piece.degree; r > 0; --r) {
        const double u =
            (arguments[static_cast<std::size_t>(piece.degree - r)] - piece.start) / (piece.end - piece.start);
        for (int j = 0; j < r; ++j) {
            const auto i = static_cast<std::size_t>(j);
            p[i] = (1 - u) * p[i] + u * p[i + 1];
        }
    }
    return p[0];
}

class ClosedSpline {
public:
    ClosedSpline(const std::vector<BezierPiece<2>>& pieces, std::vector<double> knots, double period)
        : m_pieces(pieces)
        , m_degree(pieces.front().degree)
        , m_knots(std::move(knots))
        , m_period(period)
    {}

    BSpline2 curve() const
    {
        const int count = static_cast<int>(m_knots.size());
        std::vector<Vec2> points;
        for (int i = 0; i < count; ++i)
            points.push_back(point(i));
        std::vector<double> knots = m_knots;
        knots.push_back(knots.front() + m_period);
        return {m_degree, true, std::move(points), std::move(knots)};
    }

private:
    double knot(int i) const
    {
        const int count = static_cast<int>(m_knots.size());
        const int turn = i >= 0 ? i / count : -((count - 1 - i) / count);
        return m_knots[static_cast<std::size_t>(i - turn * count)] + turn * m_period;
    }

    /// Of a piece within the point's support, the longest one of those in its longest span.
    Vec2 point(int i) const
    {
        const int first = i - (m_degree + 1) / 2;
        int widest = first;
        for (int k = first; k <= first + m_degree; ++k)
            if (knot(k + 1) - knot(k) > knot(widest + 1) - knot(widest))
                widest = k;
        const double low = knot(widest), high = knot(widest + 1);
        const BezierPiece<2>* best = nullptr;
        double turn = 0;
        for (const BezierPiece<2>& piece : m_pieces)
            for (int k = -2; k <= 2; ++k) {
                const double middle = (piece.start + piece.end) / 2 + k * m_period;
                if (middle > low && middle < high && (!best || piece.end - piece.start > best->end - best->start)) {
                    best = &piece;
                    turn = k * m_period;
                }
            }
        std::array<double, 3> arguments{};
        for (int k = 0; k < m_degree; ++k)
            arguments[static_cast<std::size_t>(k)] = knot(first + 1 + k) - turn;
        return best ? polar(*best, arguments) : Vec2(Vec2::Zero());
    }

    const std::vector<BezierPiece<2>>& m_pieces;
    int m_degree;
    std::vector<double> m_knots;
    double m_period;
};

/// Sorted within one period that begins at 0 if there is a knot, else at the first one of the outline's domain. The
/// last copy of a corner's knot at the start of a cubic lies at the end of the period, so that its point is the
/// first one.
std::vector<double> inOnePeriod(std::vector<double> knots, const BSpline2& outline)
{
    const double period = outline.period(), gap = 1e-9 * period;
    const auto isKnot = [&](double t) {
        return std::ranges::any_of(knots,
                                   [&](double knot) { return std::abs(std::remainder(knot - t, period)) < gap; });
    };
    double first = outline.domainEnd();
    for (const double knot : knots)
        first = std::min(first, inFirstTurn(outline, knot));
    const double start = isKnot(0) ? 0 : first;
    for (double& knot : knots) {
        knot -= period * std::floor((knot - start + gap) / period);
        if (std::abs(knot - start) < gap)
            knot = start;
    }
    std::ranges::sort(knots);
    if (outline.degree() == 3 && std::ranges::count(knots, start) >= 3) {
        knots.erase(knots.begin());
        knots.push_back(start + period);
    }
    return knots;
}

} // namespace

std::vector<double> innerKnots(const BSpline2& open)
{
    const auto clamped = open.degree() + 1;
    return {open.knots().begin() + clamped, open.knots().end() - clamped};
}

BSpline2 closedSpline(const std::vector<BezierPiece<2>>& pieces, std::vector<double> knots, const BSpline2& outline)
{
    return ClosedSpline(pieces, inOnePeriod(std::move(knots), outline), outline.period()).curve();
}

} // namespace bolster::edits
