#include "SlippedOutline.h"

#include "ArcLength.h"
#include "Stretch.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr int probesOfPoint = 8;
constexpr double mostSlip = 1.0 / 3; // of the length: more would turn the order of places around

std::vector<int> pointsInside(const BSpline2& outline, double from, double end)
{
    const double slack = 1e-6 * outline.period();
    std::vector<int> inside;
    for (int k = 0; k < outline.pointCount(); ++k) {
        double at = outline.parameterOfPoint(k);
        while (at <= from + slack)
            at += outline.period();
        if (at < end - slack)
            inside.push_back(k);
    }
    return inside;
}

/// How much control point k has to say at a parameter.
double influence(const BSpline2& outline, int k, double parameter)
{
    std::vector<Vec2> points(outline.points().size(), Vec2::Zero());
    points[static_cast<std::size_t>(k)] = Vec2::UnitX();
    return outline.withPoints(std::move(points)).at(parameter).x();
}

} // namespace

BSpline2 slippedOutline(const BSpline2& outline, double from, double to, double by)
{
    const double end = unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd());
    const std::vector<int> inside = pointsInside(outline, from, end);
    if (inside.empty() || by == 0)
        return outline;
    const ArcLength2 length(outline);
    const double begin = length.at(from), all = length.at(end) - begin;
    const double slip = std::clamp(by, -mostSlip * all, mostSlip * all);
    const auto probes = static_cast<Eigen::Index>(probesOfPoint * (inside.size() + 2));
    Eigen::MatrixXd influences(probes, std::ssize(inside));
    Eigen::MatrixX2d moves(probes, 2);
    for (Eigen::Index p = 0; p < probes; ++p) {
        const double share = (static_cast<double>(p) + 0.5) / static_cast<double>(probes);
        const double at = outline.wrapped(length.parameterAt(begin + share * all));
        const double bump = std::pow(std::sin(std::numbers::pi * share), 2);
        const double there = outline.wrapped(length.parameterAt(begin + share * all + slip * bump));
        moves.row(p) = (outline.at(there) - outline.at(at)).transpose();
        for (Eigen::Index k = 0; k < influences.cols(); ++k)
            influences(p, k) = influence(outline, inside[static_cast<std::size_t>(k)], at);
    }
    const Eigen::MatrixX2d found = influences.colPivHouseholderQr().solve(moves);
    std::vector<Vec2> points = outline.points();
    for (std::size_t k = 0; k < inside.size(); ++k)
        points[static_cast<std::size_t>(inside[k])] += found.row(static_cast<Eigen::Index>(k)).transpose();
    return outline.withPoints(std::move(points));
}

} // namespace bolster
