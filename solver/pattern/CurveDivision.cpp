#include "CurveDivision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// An edge may be this much shorter than asked for where the curve bends sharply.
constexpr double shortestEdge = 0.4;
constexpr double largestTurnPerEdge = std::numbers::pi / 6;

/// How sharply a piece bends in all, in radians, its ends left out.
double turning(const BSpline2& curve, const ArcLength2& length, double s0, double s1, int probes)
{
    double turn = 0;
    Vec2 previous = Vec2::Zero();
    for (int k = 0; k <= probes; ++k) {
        // A hair inside the ends, where a corner would turn as well.
        const double s = s0 + (s1 - s0) * std::clamp(double(k) / probes, 1e-6, 1 - 1e-6);
        const Vec2 tangent = curve.derivative(length.parameterAt(s)).normalized();
        if (k > 0 && tangent.allFinite() && previous.allFinite())
            turn += std::acos(std::clamp(tangent.dot(previous), -1.0, 1.0));
        previous = tangent;
    }
    return turn;
}

} // namespace

int edgesOf(const BSpline2& curve, const ArcLength2& length, double s0, double s1, double edgeLength)
{
    int edges = std::max(1, static_cast<int>(std::lround((s1 - s0) / edgeLength)));
    const double turn = turning(curve, length, s0, s1, std::max(4, 2 * edges));
    const int forTurn = static_cast<int>(std::ceil(turn / largestTurnPerEdge - 1e-6));
    const int most = std::max(1, static_cast<int>((s1 - s0) / (shortestEdge * edgeLength)));
    edges = std::max(edges, std::min(forTurn, most));
    // A single edge would flatten the bend altogether.
    return turn > 0.5 ? std::max(edges, 2) : edges;
}

} // namespace bolster
