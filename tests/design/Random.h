// Numbers, curves and designs by chance, the same in every run.
#pragma once

#include "BSpline.h"

#include <cmath>
#include <numbers>
#include <random>

namespace bolster::test {

class Random {
public:
    explicit Random(unsigned seed)
        : m_engine(seed)
    {}

    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_engine); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }
    bool chance(double share) { return real(0, 1) < share; }

private:
    std::mt19937 m_engine;
};

template <int Dim>
Eigen::Matrix<double, Dim, 1> randomPoint(Random& random, double size)
{
    Eigen::Matrix<double, Dim, 1> point;
    for (double& coordinate : point)
        coordinate = random.real(-size, size);
    return point;
}

/// A star-shaped curve about the origin that does not cross itself if it is closed, and some random knots.
template <int Dim>
BSpline<Dim> randomCurve(Random& random, int degree, bool closed)
{
    const int count = (closed ? 3 : degree + 1) + random.whole(0, 8);
    std::vector<Eigen::Matrix<double, Dim, 1>> points;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const double radius = random.real(60, 140);
        auto point = randomPoint<Dim>(random, 40);
        point[0] = radius * std::cos(angle);
        point[1] = radius * std::sin(angle);
        points.push_back(point);
    }
    BSpline<Dim> curve(degree, closed, points);
    for (int i = random.whole(0, 6); i > 0; --i) {
        const auto& knots = curve.knots();
        const double present = knots[static_cast<std::size_t>(random.whole(0, static_cast<int>(knots.size()) - 1))];
        curve = curve.withKnot(random.chance(0.5) ? present : random.real(curve.domainStart(), curve.domainEnd()));
    }
    return curve;
}

} // namespace bolster::test
